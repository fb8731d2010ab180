/// Sorts by two numbers, the first of which counts more; what is equal stays in its order.
///
/// One type of key for all lists, as each other one is 5 KB more for a page to load.
pub(crate) fn sort<T>(all: &mut [T], key: impl FnMut(&T) -> [usize; 2]) {
    all.sort_by_cached_key(key);
}
