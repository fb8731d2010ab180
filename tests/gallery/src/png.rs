use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, RgbImage};
use std::fs::{self, File};
use std::{io::BufReader, path::Path};

/// The most pixels a picture may have: those of 8K, twice over.
const MOST: u64 = 2 * 7680 * 4320;

/// The picture in a PNG file, or one sentence that says why there is none.
///
/// Its size is read first, so that no file can fill the memory.
pub(crate) fn read(path: &Path) -> Result<RgbImage, String> {
    let name = path.display();
    let metadata = fs::metadata(path)
        .map_err(|error| format!("can't read {name}: {error}"))?;
    if !metadata.is_file() {
        return Err(format!("{name} is not a file"));
    }
    let unread = |error| format!("can't read {name}: {error}");
    // Whatever the file is called, its first bytes tell what it is.
    let file = BufReader::new(File::open(path).map_err(unread)?);
    let reader = ImageReader::new(file).with_guessed_format().map_err(unread)?;
    if reader.format() != Some(ImageFormat::Png) {
        return Err(format!("{name} is not a PNG file"));
    }
    let damaged = |error| format!("{name} is a damaged PNG file: {error}");
    let decoder = reader.into_decoder().map_err(damaged)?;
    let (width, height) = decoder.dimensions();
    if MOST < u64::from(width) * u64::from(height) {
        return Err(format!(
            "{name} is {width}×{height} pixels; allowed are {MOST} pixels in all"
        ));
    }
    Ok(DynamicImage::from_decoder(decoder).map_err(damaged)?.to_rgb8())
}
