//! The locked pictures, which are insta snapshots.

use crate::workspace;
use image::{ImageError, RgbImage};
use std::fs;
use std::path::PathBuf;
use thiserror::Error;

/// The error if a locked picture can't be read.
#[derive(Debug, Error)]
#[error("{}: {source}", .path.display())]
pub struct LockedPictureError {
    /// The picture's file.
    pub path: PathBuf,
    /// What went wrong.
    pub source: ImageError,
}

/// The path of the locked picture called `name`.
pub fn locked_picture_path(name: &str) -> PathBuf {
    workspace().join(format!("tests/snapshots/{name}.snap.png"))
}

/// Reads the locked picture called `name`.
pub fn read_locked_picture(name: &str) -> Result<RgbImage, LockedPictureError> {
    let path = locked_picture_path(name);
    let file = fs::read(&path).map_err(ImageError::from);
    // Don't use `image::open`. It reads from a `BufReader<File>`, so the generic decoders of the
    // crate `image` would be compiled for that type as well as for bytes in memory.
    let picture = file.and_then(|file| image::load_from_memory(&file));
    match picture {
        Ok(picture) => Ok(picture.into_rgb8()),
        Err(source) => Err(LockedPictureError { path, source }),
    }
}
