//! Scenes other than step 5's: the scene that a reader puts together, and the scene that is
//! generated from a person's name. This folder also has a table of the numbers in a scene, and the
//! names of the steps' lights.

mod light_names;
mod named_scene;
mod own_scene;
mod quantity;
pub use light_names::{LIGHT_NAMES, LightName};
pub use named_scene::generate_scene;
pub use own_scene::OwnScene;
pub use quantity::{Component, GROUND, Owner, QUANTITIES, Quantity, Scalar, TypedRange};
