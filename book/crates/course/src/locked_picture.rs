use crate::workspace;
use image::RgbImage;
use std::path::PathBuf;

/// The file of the locked picture `name`, a snapshot of insta.
pub fn locked_picture_path(name: &str) -> PathBuf {
    workspace().join(format!("tests/snapshots/{name}.snap.png"))
}

/// Reads the locked picture `name`, or says why it can't be read.
pub fn read_locked_picture(name: &str) -> Result<RgbImage, String> {
    let path = locked_picture_path(name);
    let picture = image::open(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(picture.into_rgb8())
}
