//! The five steps, the camera that takes their pictures, and their examples as a library.

mod camera;
mod step;
mod ungated_colour;
pub use camera::{
    FOV_DEGREES, PICTURE_COLUMNS, PICTURE_ROWS, camera, camera_with_fov, camera_with_size,
    primary_rays,
};
pub use step::Step;
pub use ungated_colour::ungated_colour;

pub mod examples;
pub use examples::{DrawPicture, PICTURES, find_picture};
