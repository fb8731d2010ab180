//! Step 2, stage 2 of the lecture "Ray Casting": where a ray meets a sphere.
//!
//! A [`Ray`] meets a [`Sphere`] at those t that solve a quadratic equation. The
//! function [`quadratic`] finds them, as [`Roots`], and the smallest one above 0 is
//! the hit.

pub use step01_rays::{
    Camera, Ray, direction_colour, draw_and_save, draw_pixels, mean_colour, render,
    rgb8, sub_pixel_offsets,
};

mod quadratic;
pub use quadratic::{Roots, quadratic};

mod sphere;
pub use sphere::Sphere;

mod picture;
pub use picture::{SPHERE, colour, picture};
