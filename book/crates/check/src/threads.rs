//! The threads that draw.

use rayon::ThreadPoolBuilder;
use std::thread;

/// Runs what may draw on several threads: on one for each processor, or, where the system has none
/// to spare, on this one alone.
pub fn run_on_threads<T: Send>(act: impl FnOnce() -> T + Send) -> T {
    let count = thread::available_parallelism().map_or(1, usize::from);
    let alone = || ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
    match ThreadPoolBuilder::new().num_threads(count).build() {
        Ok(threads) => threads.install(act),
        Err(_) => {
            // It only fails if rayon has been used before, and then has its threads.
            let _ = alone();
            act()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn result_is_returned() {
        assert_eq!(run_on_threads(|| 6 * 7), 42);
    }
}
