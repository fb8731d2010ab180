//! Step 2, stage 2 of the lecture: where a ray meets a sphere.

mod quadratic;
mod sphere;

mod picture;

pub use picture::{SPHERE, colour, picture};
pub use quadratic::{Roots, quadratic};
pub use sphere::Sphere;
pub use step01_rays::{Camera, Ray, direction_colour, render, run};
