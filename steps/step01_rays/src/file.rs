use image::{ImageFormat, RgbImage};
use std::{error::Error, fs, io::Cursor, path::Path, process};

/// Writes the whole picture as a PNG file or, where that fails, leaves `path` alone.
///
/// The bytes go to a file beside it, which takes its name once it is complete.
pub(crate) fn save(picture: &RgbImage, path: &Path) -> Result<(), Box<dyn Error>> {
    if fs::metadata(path).is_ok_and(|file| file.permissions().readonly()) {
        return Err("it is read-only".into());
    }
    let mut png = Cursor::new(Vec::new());
    picture.write_to(&mut png, ImageFormat::Png)?;
    let part = path.with_extension(format!("{}.part", process::id()));
    let written = fs::write(&part, png.into_inner());
    written.and_then(|()| fs::rename(&part, path)).map_err(|error| {
        let _ = fs::remove_file(&part);
        error.into()
    })
}
