//! Step 3, stage 2 of the lecture: the nearest of several objects.

pub use step02_sphere::{Camera, Ray, Sphere, direction_colour, render, run};

mod nearest;
mod object;
pub use nearest::{Hit, nearest};
pub use object::Object;

mod objects;
mod picture;
pub use objects::objects;
pub use picture::{colour, picture};
