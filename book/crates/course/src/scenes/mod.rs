//! Scenes that differ from step 5's: a reader's own, whose numbers are listed in a table, and the
//! scene that belongs to a person's name.

mod named_scene;
mod own_scene;
mod quantity;
pub use named_scene::named_scene;
pub use own_scene::OwnScene;
pub use quantity::{Component, GROUND, Owner, QUANTITIES, Quantity, Scalar, TypedRange};
