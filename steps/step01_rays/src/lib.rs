//! Step 1, stage 1 of the lecture "Ray Casting": generate the rays from the eye.
//!
//! A [`Camera`] gives the [`Ray`] from the eye through any point of a picture, and
//! [`render`] draws any function from rays to colours.

mod ray;
pub use ray::Ray;

mod camera;
pub use camera::Camera;

mod rgb8;
pub use rgb8::rgb8;

mod direction_colour;
pub use direction_colour::direction_colour;

mod draw_pixels;
pub use draw_pixels::draw_pixels;

mod render;
pub use render::{mean_colour, render, sub_pixel_offsets};

mod picture;
pub use picture::picture;

mod aspect_ratio;
pub use aspect_ratio::AspectRatio;

mod program;
pub use program::{MAX_PIXELS, draw_and_save};
