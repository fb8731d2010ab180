//! The part of rayon's API that the steps and `check` use, on one thread.
//!
//! A page has only one thread, so the real rayon would draw on one thread, too. But its code for
//! sharing rows among threads would be compiled again for each picture, and make up a fifth of
//! `check.wasm`. If the steps or `check` use more of rayon than is here, the modules don't compile.

use std::convert::Infallible;
use std::slice;

/// The traits whose methods are called like rayon's, but return ordinary iterators.
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

/// The current thread.
pub struct ThreadPool;

impl ThreadPool {
    /// Calls a function on the current thread.
    pub fn install<T>(&self, function: impl FnOnce() -> T) -> T {
        function()
    }
}
