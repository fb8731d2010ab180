//! Step 3, stage 2 of the lecture: the nearest of several spheres.

mod hit;

mod scene;

mod picture;

pub use hit::{Hit, nearest};
pub use picture::{colour, picture};
pub use scene::{COLOURS, SPHERES};
pub use step02_sphere::{Camera, Ray, Sphere, direction_colour, render, run};
