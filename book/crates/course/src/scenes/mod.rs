//! Scenes that differ from step 5's: a reader's own, whose numbers are listed in a table, and the
//! scene that belongs to a person's name. Also what the lights of the steps are called.

mod light_names;
mod named_scene;
mod own_scene;
mod quantity;
pub use light_names::{LIGHT_NAMES, LightName};
pub use named_scene::generate_scene;
pub use own_scene::OwnScene;
pub use quantity::{Component, GROUND, Owner, QUANTITIES, Quantity, Scalar, TypedRange};
