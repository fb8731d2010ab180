/// Sorts by two numbers, the first of which counts more; what is equal stays in its order.
///
/// One type of key for all lists, as each other one is 5 KB more for a page to load.
pub(crate) fn sort<T>(all: &mut [T], key: impl FnMut(&T) -> [usize; 2]) {
    all.sort_by_cached_key(key);
}

/// The key of a number: in the order of numbers.
pub(crate) fn key(x: f64) -> [usize; 2] {
    let bits = x.to_bits() as i64;
    // Of negative numbers, those with the larger bits come first.
    let key = (bits ^ (bits >> 63 & i64::MAX)) as u64 ^ 1 << 63;
    [(key >> 32) as usize, key as u32 as usize]
}
