//! The step that a place is in. The build script of the package `page` compiles `place.rs` without
//! the other files of this crate, so this can't be there.

use crate::{Place, Step};

impl Place {
    /// The step whose source it is in.
    ///
    /// # Panics
    ///
    /// Panics if its file isn't in a step, which a test of all places rules out.
    pub fn step(&self) -> Step {
        let folder = self.file.split('/').next();
        folder.and_then(Step::from_name).expect("the file of a place is in a step")
    }
}

#[cfg(test)]
mod tests {
    use crate::all_listed_places;

    #[test]
    fn each_place_is_in_a_step() {
        for place in all_listed_places() {
            assert!(place.file.starts_with(place.step().name()), "{}", place.name);
        }
    }
}
