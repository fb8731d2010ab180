use crate::file_format::other_format_clause;
use image::codecs::png::PngDecoder;
use image::error::{ImageError, LimitErrorKind};
use image::metadata::Orientation;
use image::{DynamicImage, ImageDecoder, Limits, RgbImage};
use std::io::{Cursor, ErrorKind};

/// The most bytes of a file, and the most that a chunk of it is unpacked to.
pub(crate) const FILE_BYTES: u64 = 1 << 27;

/// The most columns and the most rows of a picture: it is unpacked as a whole.
const LARGEST: u32 = 4096;

/// A picture that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Its pixels.
    pub pixels: RgbImage,
    /// Sentences about the file.
    pub notes: Vec<&'static str>,
    /// Whether alpha is 0 in every pixel.
    pub is_invisible: bool,
}

/// Reads the picture in a PNG file, or says in half a sentence why it can't be read.
///
/// The size is looked at before anything is unpacked.
pub fn read_png(file: &[u8]) -> Result<Picture, String> {
    if FILE_BYTES < file.len() as u64 {
        return Err(too_large_clause());
    }
    if let Some(format_clause) = other_format_clause(file) {
        return Err(format!("is {format_clause}"));
    }
    let mut limits = Limits::default();
    limits.max_image_width = Some(LARGEST);
    limits.max_image_height = Some(LARGEST);
    limits.max_alloc = Some(FILE_BYTES);
    let mut decoder = PngDecoder::with_limits(Cursor::new(file), limits).map_err(damage_clause)?;
    let mut notes = viewer_notes(&mut decoder).map_err(damage_clause)?;
    let picture = DynamicImage::from_decoder(decoder).map_err(damage_clause)?;
    let alpha = picture.color().has_alpha().then(|| picture.to_rgba8());
    let is_each = |alpha_value: u8| {
        alpha.as_ref().map(|one| one.pixels().all(|pixel| pixel[3] == alpha_value))
    };
    let is_invisible = is_each(0) == Some(true);
    if is_each(255) == Some(false) && !is_invisible {
        notes.push(
            "Some of its pixels are transparent, so that a viewer may show others; that was \
             left out.",
        );
    }
    Ok(Picture { pixels: picture.into_rgb8(), notes, is_invisible })
}

/// Says that a file is larger than any picture.
pub(crate) fn too_large_clause() -> String {
    format!("is too large: a picture has at most {} MB", FILE_BYTES >> 20)
}

/// Says what a decoder's error means for the file.
fn damage_clause(error: ImageError) -> String {
    let cause = match error {
        ImageError::Limits(error) if error.kind() == LimitErrorKind::DimensionError => {
            return format!(
                "is too large: pictures of up to {LARGEST}×{LARGEST} pixels are looked at"
            );
        }
        ImageError::IoError(error) if error.kind() == ErrorKind::UnexpectedEof => {
            "it ends too early, as where it was not copied whole"
        }
        error if error.to_string().contains("CRC") => {
            "a checksum is wrong, so some of its bytes are not those that were written"
        }
        _ => "what is in it can't be unpacked",
    };
    format!("is a damaged PNG file: {cause}")
}

/// Sentences about what a viewer may show otherwise, and what was left out.
fn viewer_notes(decoder: &mut PngDecoder<Cursor<&[u8]>>) -> Result<Vec<&'static str>, ImageError> {
    let colour = decoder.color_type();
    let bits = colour.bytes_per_pixel() / colour.channel_count();
    let notes = [
        (!colour.has_color(), "The file is grey: it has one number a pixel, and ours has three."),
        (bits == 2, "The file has 16 bits a channel; they were rounded to 8."),
        (
            decoder.icc_profile()?.is_some(),
            "It has a colour profile, with which a viewer may show other colours; it was left \
             out.",
        ),
        (
            decoder.orientation()? != Orientation::NoTransforms,
            "Its EXIF data asks a viewer to turn it; that was left out.",
        ),
        (decoder.is_apng()?, "It is an animation: only its first picture was looked at."),
    ];
    Ok(notes.into_iter().filter(|(is_so, _)| *is_so).map(|(_, note)| note).collect())
}
