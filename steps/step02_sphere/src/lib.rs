//! Step 2, stage 2 of the lecture "Ray Casting": where a ray meets a sphere.

pub use step01_rays::{
    Camera, Ray, direction_colour, draw_pixels, mean, render, rgb8, run, sub_pixels,
};

mod quadratic;
pub use quadratic::{Roots, quadratic};

mod sphere;
pub use sphere::Sphere;

mod picture;
pub use picture::{SPHERE, colour, picture};
