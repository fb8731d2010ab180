//! The five steps, the camera that takes their pictures, and their examples as a library.

mod camera;
mod colour_without_gate;
mod step;
pub use camera::{
    FOV_DEGREES, PICTURE_COLUMNS, PICTURE_ROWS, camera, camera_with_fov, camera_with_size,
    primary_rays,
};
pub use colour_without_gate::colour_without_gate;
pub use step::Step;

pub mod examples;
pub use examples::{DrawPicture, PICTURES, find_picture};
