//! The steps' source code as text. These modules:
//!
//! - list the places that a reader may edit on a page,
//! - turn a step's crate into a module of another crate,
//! - write the dependencies for the manifest of a program that contains copies of the steps.

mod crate_as_module;
mod dependencies_of_step_copies;
mod place;
mod step_of_place;
pub use crate_as_module::crate_as_module;
pub use dependencies_of_step_copies::dependencies_of_step_copies;
pub use place::{OccurrenceError, Place, PlaceNote, ValueType, all_listed_places};
