//! What the tests share: the list of locked pictures, the pixel comparison, and random inputs.

mod picture_list;
mod picture_snapshot;
mod random_inputs;

pub use course::{camera, primary_rays};
pub use picture_list::{LockedPicture, locked_pictures};
pub use picture_snapshot::assert_picture_snapshot;
pub use random_inputs::{RandomInputs, test_law};
