//! Step 1, stage 1 of the lecture "Ray Casting": generate the rays from the eye.
//!
//! A [`Camera`] gives the [`Ray`] through any place (i, j) of a picture, from C along
//! [D_u D_v V_0] (i, j, 1)ᵀ. [`render`] draws any function from rays to colours.

mod ray;
pub use ray::Ray;

mod camera;
pub use camera::Camera;

mod render;
mod rgb8;
pub use render::{draw_pixels, mean, render, sub_pixels};
pub use rgb8::rgb8;

mod picture;
pub use picture::{direction_colour, picture};

mod aspect_ratio;
pub use aspect_ratio::AspectRatio;

mod program;
pub use program::run;
