//! Stands in for `rayon` in the modules of the pages, which have one thread: what the steps and
//! the checker call of it, for a seventh of a module less.

/// The methods of lists, under the names of `rayon`.
pub mod prelude {
    use std::slice::{ChunksExactMut, Iter};

    /// A list that one thread walks through.
    pub trait ParallelSlice<T> {
        /// Its items.
        fn par_iter(&self) -> Iter<'_, T>;

        /// Parts of this size, to write into.
        fn par_chunks_exact_mut(&mut self, size: usize) -> ChunksExactMut<'_, T>;
    }

    impl<T> ParallelSlice<T> for [T] {
        fn par_iter(&self) -> Iter<'_, T> {
            self.iter()
        }

        fn par_chunks_exact_mut(&mut self, size: usize) -> ChunksExactMut<'_, T> {
            self.chunks_exact_mut(size)
        }
    }

    /// A list that one thread uses up.
    pub trait IntoParallelIterator: IntoIterator + Sized {
        /// Its items.
        fn into_par_iter(self) -> Self::IntoIter {
            self.into_iter()
        }
    }

    impl<T> IntoParallelIterator for Vec<T> {}
}
