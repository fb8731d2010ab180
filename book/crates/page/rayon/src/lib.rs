//! The part of rayon's API that the steps and `check` use, implemented on one thread.
//!
//! A page has only one thread, so the real rayon would draw on one thread, too. But rayon's code
//! for sharing rows among threads would be compiled once for each picture, and would make up a
//! fifth of `check.wasm`. The WebAssembly modules don't compile if the steps or `check` use any
//! other part of rayon.

use std::convert::Infallible;
use std::slice;

/// Traits with the same names and methods as rayon's. Here, the methods return ordinary iterators.
pub mod prelude {
    pub use crate::{IntoParallelRefIterator, ParallelBridge};
}

/// An iterator whose items rayon would share among threads.
pub trait ParallelBridge: Iterator + Sized {
    /// Returns the iterator itself.
    fn par_bridge(self) -> Self {
        self
    }
}

impl<I: Iterator> ParallelBridge for I {}

/// A list whose items rayon would share among threads.
pub trait IntoParallelRefIterator<T> {
    /// Returns an iterator over the list.
    fn par_iter(&self) -> slice::Iter<'_, T>;
}

impl<T> IntoParallelRefIterator<T> for Vec<T> {
    fn par_iter(&self) -> slice::Iter<'_, T> {
        self.iter()
    }
}

/// Builds a [`ThreadPool`].
#[derive(Default)]
pub struct ThreadPoolBuilder;

impl ThreadPoolBuilder {
    /// Returns a builder.
    pub fn new() -> Self {
        Self
    }

    /// Returns the builder unchanged, since there is always one thread.
    pub fn num_threads(self, _count: usize) -> Self {
        self
    }

    /// Returns the builder unchanged, since the current thread is the only one.
    pub fn use_current_thread(self) -> Self {
        self
    }

    /// Returns the pool.
    pub fn build(self) -> Result<ThreadPool, Infallible> {
        Ok(ThreadPool)
    }

    /// Does nothing.
    pub fn build_global(self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// A pool whose only thread is the current one.
pub struct ThreadPool;

impl ThreadPool {
    /// Calls a function on the current thread.
    pub fn install<T>(&self, function: impl FnOnce() -> T) -> T {
        function()
    }
}
