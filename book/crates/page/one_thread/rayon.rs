//! Stands in for `rayon` in the modules of the pages, which have one thread, and in the programs
//! that draw mistakes: what the steps and the checker call of it. A module is a seventh smaller.

/// The methods of lists, under the names of `rayon`.
pub mod prelude {
    use std::slice::ChunksExactMut;

    /// A list that one thread writes into.
    pub trait ParallelSliceMut<T> {
        /// Parts of this size, to write into.
        fn par_chunks_exact_mut(&mut self, size: usize) -> ChunksExactMut<'_, T>;
    }

    impl<T> ParallelSliceMut<T> for [T] {
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
