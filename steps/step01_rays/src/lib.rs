//! Step 1, stage 1 of the lecture "Ray Casting": generate the rays from the eye.

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
