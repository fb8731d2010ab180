//! The threads that draw.

use rayon::ThreadPoolBuilder;
use std::thread;

/// Runs a function that may draw on several threads: one for each processor. If the system has no
/// threads to spare, it runs on the current one.
pub fn run_on_threads<T: Send>(act: impl FnOnce() -> T + Send) -> T {
    let count = thread::available_parallelism().map_or(1, usize::from);
    let alone = || ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
    match ThreadPoolBuilder::new().num_threads(count).build() {
        Ok(threads) => threads.install(act),
        Err(_) => {
            // This fails only if rayon has been used before, and then it has its threads.
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
