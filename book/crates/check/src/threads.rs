//! The thread pool that draws.

use rayon::ThreadPoolBuilder;
use std::thread;

/// Runs a function that may draw in parallel, with one thread per processor. If the system can't
/// start threads, it runs on the current one.
pub fn run_on_threads<T: Send>(act: impl FnOnce() -> T + Send) -> T {
    let count = thread::available_parallelism().map_or(1, usize::from);
    match ThreadPoolBuilder::new().num_threads(count).build() {
        Ok(threads) => threads.install(act),
        Err(_) => {
            // This fails only if rayon already has a global pool. Then `act` uses that one.
            let _ = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
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
