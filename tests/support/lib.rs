//! What the tests share: the list of locked pictures, the pixel comparison, and random inputs.

mod compare_pixels;
mod picture_list;
mod random_inputs;

pub use compare_pixels::compare_pixels;
pub use course::{camera, primary_rays};
pub use picture_list::{LockedPicture, locked_pictures};
pub use random_inputs::{RandomInputs, test_law};
