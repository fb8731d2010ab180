//! The locked pictures, which are snapshots of insta.

use crate::workspace;
use image::{ImageError, RgbImage};
use std::fs;
use std::path::PathBuf;
use thiserror::Error;

/// Why a locked picture can't be read.
#[derive(Debug, Error)]
#[error("{}: {source}", .path.display())]
pub struct LockedPictureError {
    /// The file of the picture.
    pub path: PathBuf,
    /// What went wrong.
    pub source: ImageError,
}

/// The file of the locked picture `name`.
pub fn locked_picture_path(name: &str) -> PathBuf {
    workspace().join(format!("tests/snapshots/{name}.snap.png"))
}

/// Reads the locked picture `name`.
pub fn read_locked_picture(name: &str) -> Result<RgbImage, LockedPictureError> {
    let path = locked_picture_path(name);
    let file = fs::read(&path).map_err(ImageError::from);
    // `image::open` is generic over the reader, so it would compile image's decoder once more.
    let picture = file.and_then(|file| image::load_from_memory(&file));
    match picture {
        Ok(picture) => Ok(picture.into_rgb8()),
        Err(source) => Err(LockedPictureError { path, source }),
    }
}
