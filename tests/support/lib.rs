//! Helpers that the tests share: locked pictures, rays and random geometry.

mod picture_list;
mod picture_snapshot;
mod random_inputs;

pub use course::{camera, primary_rays};
pub use picture_list::{LockedPicture, locked_pictures};
pub use picture_snapshot::{compare_pixels, read_snapshot};
pub use random_inputs::{RandomInputs, test_law};
