use rayon::current_num_threads;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// How many are worth to be worked on at once.
pub(crate) fn at_once() -> usize {
    if cfg!(target_arch = "wasm32") { 1 } else { current_num_threads() }
}

/// What there is of each, in their order; all processors work at once, where there is
/// more than the one of a page.
pub(crate) fn each<T: Send, R: Send>(
    all: Vec<T>,
    what: impl Fn(T) -> Option<R> + Send + Sync,
) -> Vec<R> {
    if !cfg!(target_arch = "wasm32") {
        return all.into_par_iter().filter_map(what).collect();
    }
    let mut found = vec![];
    for one in all {
        found.extend(what(one));
    }
    found
}
