//! Step 1, stage 1 of the lecture: generate the rays from the eye.

mod ray;
pub use ray::Ray;

mod camera;
pub use camera::Camera;

mod colour;
mod render;
pub use render::render;

mod picture;
pub use picture::{direction_colour, picture};

mod aspect_ratio;
mod row;
pub use aspect_ratio::AspectRatio;
pub use row::Row;

mod program;
pub use program::run;
