//! Starts the threads that draw.

use rayon::ThreadPoolBuilder;
use std::thread;

/// Runs a function in a pool with one thread per processor, so that the function can draw in
/// parallel. If the system can't start threads, the function runs on the current thread.
pub fn run_on_threads<T: Send>(act: impl FnOnce() -> T + Send) -> T {
    let count = thread::available_parallelism().map_or(1, usize::from);
    match ThreadPoolBuilder::new().num_threads(count).build() {
        Ok(threads) => threads.install(act),
        Err(_) => {
            // `build_global` fails only if rayon already has a global pool. In that case, `act`
            // uses the existing pool.
            let _ = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
            act()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn run_on_threads_returns_the_result() {
        assert_eq!(run_on_threads(|| 6 * 7), 42);
    }
}
