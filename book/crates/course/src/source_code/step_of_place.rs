//! Finds the step that contains a place. This code can't be in `place.rs`, because the build script
//! of the package `page` compiles `place.rs` without the rest of this crate.

use crate::{Place, Step};

impl Place {
    /// The step whose source contains the place.
    ///
    /// # Panics
    ///
    /// Panics if the place's file isn't in a step. A test rules that out for all listed places.
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
