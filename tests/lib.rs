//! What the tests share: locked pictures, programs to run, rays, random input.

mod locked;
mod locked_pictures;
mod program;
mod rays;
mod refusals;

pub use exercises::camera;
pub use locked::{assert_locked, locked};
pub use locked_pictures::{LockedPicture, locked_pictures};
pub use program::{Program, assert_program};
pub use rays::{point, rays, rays_of_camera, sphere, unit};
