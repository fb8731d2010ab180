//! The five steps, the camera for their pictures, and the steps' examples as modules. Two more
//! functions compute what no step returns: the discriminant of a sphere and a ray, and the colour
//! without step 5's test of n·l.

mod camera;
mod colour_without_highlight_gate;
mod discriminant;
mod step;
pub use camera::{
    FOV_DEGREES, PICTURE_COLUMNS, PICTURE_ROWS, camera, camera_with_fov, camera_with_size,
    primary_rays,
};
pub use colour_without_highlight_gate::colour_without_highlight_gate;
pub use discriminant::discriminant;
pub use step::Step;

pub mod examples;
pub use examples::{DrawPicture, PICTURES, find_draw_function};
