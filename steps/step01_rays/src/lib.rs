//! Step 1, stage 1 of the lecture: generate the rays from the eye.

mod ray;
mod row;

mod aspect_ratio;
mod camera;

mod colour;
mod render;

mod picture;

mod allowed;
mod file;
mod options;
mod program;

pub use aspect_ratio::AspectRatio;
pub use camera::Camera;
pub use picture::{direction_colour, picture};
pub use program::{Picture, run};
pub use ray::Ray;
pub use render::render;
pub use row::Row;
