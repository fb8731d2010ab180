//! The source code of the steps, as text: the places in it that a reader may edit on a page, and
//! what turns a copy of a step into a module of another crate.

mod crate_as_module;
mod place;
mod step_dependencies;
mod step_of_place;
pub use crate_as_module::crate_as_module;
pub use place::{OccurrenceError, Place, PlaceNote, ValueType, all_listed_places};
pub use step_dependencies::step_dependencies;
