//! Reads the locked pictures, hashes a picture, describes or draws the difference between two
//! pictures, and encodes PNG files.

mod difference;
mod encode_png;
mod hash_picture;
mod locked_picture;
mod with_difference;
pub use difference::{describe_difference, largest_channel_difference};
pub use encode_png::encode_png;
pub use hash_picture::hash_picture;
pub use locked_picture::{LockedPictureError, locked_picture_path, read_locked_picture};
pub use with_difference::draw_with_difference;
