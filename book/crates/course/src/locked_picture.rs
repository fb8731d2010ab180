//! The locked pictures, which are snapshots of insta.

use crate::workspace;
use image::{ImageError, RgbImage};
use std::fs;
use std::path::PathBuf;

/// The file of the locked picture `name`.
pub fn locked_picture_path(name: &str) -> PathBuf {
    workspace().join(format!("tests/snapshots/{name}.snap.png"))
}

/// Reads the locked picture `name`. The error says which file can't be read, and why.
pub fn read_locked_picture(name: &str) -> Result<RgbImage, String> {
    let path = locked_picture_path(name);
    let file = fs::read(&path).map_err(ImageError::from);
    // `image::open` is generic over the reader, so it would compile image's decoder once more.
    let picture = file.and_then(|file| image::load_from_memory(&file));
    let picture = picture.map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(picture.into_rgb8())
}
