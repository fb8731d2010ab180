//! Step 2, stage 2 of the lecture "Ray Casting": where a ray meets a sphere.
//!
//! A [`Sphere`] makes at² + bt + c = 0 of a [`Ray`], and [`quadratic`] finds its
//! [`Roots`], of which the smallest above 0 is the hit.

pub use step01_rays::{
    Camera, Ray, direction_colour, draw_pixels, mean, render, rgb8, run, sub_pixels,
};

mod quadratic;
pub use quadratic::{Roots, quadratic};

mod sphere;
pub use sphere::Sphere;

mod picture;
pub use picture::{SPHERE, colour, picture};
