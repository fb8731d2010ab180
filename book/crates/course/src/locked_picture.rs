use crate::workspace;
use image::{ImageError, RgbImage};
use std::fs;
use std::path::PathBuf;

/// The file of the locked picture `name`, a snapshot of insta.
pub fn locked_picture_path(name: &str) -> PathBuf {
    workspace().join(format!("tests/snapshots/{name}.snap.png"))
}

/// Reads the locked picture `name`, or says why it can't be read.
pub fn read_locked_picture(name: &str) -> Result<RgbImage, String> {
    let path = locked_picture_path(name);
    let file = fs::read(&path).map_err(ImageError::from);
    // To read it from the file itself would compile image's decoder here once more.
    let picture = file.and_then(|file| image::load_from_memory(&file));
    let picture = picture.map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(picture.into_rgb8())
}
