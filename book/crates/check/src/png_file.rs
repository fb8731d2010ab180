use crate::file_format::other_format_clause;
use image::codecs::png::PngDecoder;
use image::error::{ImageError, LimitErrorKind};
use image::metadata::Orientation;
use image::{DynamicImage, ImageDecoder, Limits, RgbImage};
use std::error::Error;
use std::io::Cursor;

/// The most bytes of a file, and the most that a chunk of it is unpacked to.
pub(crate) const FILE_BYTES: u64 = 1 << 27;

/// The most columns and the most rows of a picture that is unpacked as a whole.
const LARGEST_WHOLE: u32 = 4096;

/// The most columns and rows that a program of the course draws.
const LARGEST: (u32, u32) = (8192, 4 * 8192);

/// The most bytes that are kept of a larger picture.
const KEPT_BYTES: u64 = 3 << 22;

/// A picture that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Columns and rows.
    pub size: (u32, u32),
    /// Every so many-th row was kept: each, but for very large pictures.
    pub row_step: u32,
    /// The pixels of these rows.
    pub rows: RgbImage,
    /// How many pixels are not opaque.
    pub transparent_count: usize,
    /// Sentences about the file.
    pub notes: Vec<&'static str>,
}

impl From<RgbImage> for Picture {
    fn from(rows: RgbImage) -> Self {
        let size = rows.dimensions();
        Self { size, row_step: 1, rows, transparent_count: 0, notes: vec![] }
    }
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
    limits.max_image_width = Some(LARGEST_WHOLE);
    limits.max_image_height = Some(LARGEST_WHOLE);
    limits.max_alloc = Some(FILE_BYTES);
    let mut decoder = match PngDecoder::with_limits(Cursor::new(file), limits) {
        Err(ImageError::Limits(error)) if error.kind() == LimitErrorKind::DimensionError => {
            return read_spread_rows(file);
        }
        decoder => decoder.map_err(damage_clause)?,
    };
    let notes = viewer_notes(&mut decoder).map_err(damage_clause)?;
    let picture = DynamicImage::from_decoder(decoder).map_err(damage_clause)?;
    let alpha = picture.color().has_alpha().then(|| picture.to_luma_alpha8());
    let is_transparent = |pixel: &&image::LumaA<u8>| pixel[1] < 255;
    let transparent_count = alpha.map_or(0, |alpha| alpha.pixels().filter(is_transparent).count());
    Ok(Picture { transparent_count, notes, ..picture.into_rgb8().into() })
}

/// Reads a picture that is too large to be unpacked as a whole, as far as a program of the
/// course may have written it: some of its rows are kept.
fn read_spread_rows(file: &[u8]) -> Result<Picture, String> {
    let limits = png::Limits { bytes: KEPT_BYTES as usize };
    let decoder = png::Decoder::new_with_limits(Cursor::new(file), limits);
    let mut reader = decoder.read_info().map_err(damage_clause)?;
    let info = reader.info();
    let (columns, rows) = info.size();
    let is_as_written = (info.color_type, info.bit_depth, info.interlaced)
        == (png::ColorType::Rgb, png::BitDepth::Eight, false);
    if LARGEST.0 < columns || LARGEST.1 < rows || !is_as_written {
        return Err(format!(
            "is too large: pictures of more than {LARGEST_WHOLE} columns or rows are looked at \
             as the course writes them, RGB of up to {}×{}",
            LARGEST.0, LARGEST.1
        ));
    }
    let row_bytes = 3 * columns as usize;
    let row_step = (row_bytes as u64 * u64::from(rows)).div_ceil(KEPT_BYTES) as u32;
    let (mut row, mut kept) = (vec![0; row_bytes], vec![]);
    for j in 0..rows {
        let read = reader.read_row(&mut row);
        read.map_err(damage_clause)?;
        if j.is_multiple_of(row_step) {
            kept.extend_from_slice(&row);
        }
    }
    let kept = RgbImage::from_raw(columns, rows.div_ceil(row_step), kept);
    let kept = kept.ok_or("is a damaged PNG file: rows are missing")?;
    Ok(Picture { size: (columns, rows), row_step, ..kept.into() })
}

/// Says that a file is larger than any picture.
pub(crate) fn too_large_clause() -> String {
    format!("is too large: the limit is {} MB", FILE_BYTES >> 20)
}

/// Says what a decoder's error means for the file.
fn damage_clause(error: impl Error) -> String {
    let text = error.to_string();
    let cause = if text.contains("unexpected end") {
        "it is truncated; perhaps the copy was incomplete"
    } else if text.contains("CRC") {
        "a checksum is wrong, so some bytes have changed"
    } else {
        "its contents can't be unpacked"
    };
    format!("is a damaged PNG file: {cause}")
}

/// Sentences about what a viewer may show otherwise, and what was left out.
fn viewer_notes(decoder: &mut PngDecoder<Cursor<&[u8]>>) -> Result<Vec<&'static str>, ImageError> {
    let colour = decoder.color_type();
    let bits = colour.bytes_per_pixel() / colour.channel_count();
    let notes = [
        (!colour.has_color(), "The file is grey: one number per pixel, and ours has three."),
        (bits == 2, "The file has 16 bits per channel, here rounded to 8."),
        (
            decoder.icc_profile()?.is_some(),
            "It has a colour profile, ignored here, so a viewer may show other colours.",
        ),
        (
            decoder.orientation()? != Orientation::NoTransforms,
            "Its EXIF data, ignored here, asks a viewer to turn it.",
        ),
        (decoder.is_apng()?, "It is an animation; only its first picture was compared."),
    ];
    Ok(notes.into_iter().filter(|(is_so, _)| *is_so).map(|(_, note)| note).collect())
}
