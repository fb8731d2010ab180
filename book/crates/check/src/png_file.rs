use crate::file_format::other_format_clause;
use image::RgbImage;
use image::metadata::Orientation;
use png::{BitDepth, ColorType, Info, Transformations};
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
/// The size is looked at before anything is unpacked. Of a picture that is too large to be
/// unpacked as a whole, some rows are kept, if a program of the course may have written it.
pub fn read_png(file: &[u8]) -> Result<Picture, String> {
    if FILE_BYTES < file.len() as u64 {
        return Err(too_large_clause());
    }
    if let Some(format_clause) = other_format_clause(file) {
        return Err(format!("is {format_clause}"));
    }
    let limits = png::Limits { bytes: FILE_BYTES as usize };
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(file), limits);
    decoder.set_transformations(Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(damage_clause)?;
    let info = reader.info();
    let (columns, rows) = info.size();
    let is_whole = columns.max(rows) <= LARGEST_WHOLE;
    let is_as_written = (info.color_type, info.bit_depth, info.interlaced)
        == (ColorType::Rgb, BitDepth::Eight, false);
    if !is_whole && (LARGEST.0 < columns || LARGEST.1 < rows || !is_as_written) {
        return Err(format!(
            "is too large: pictures of more than {LARGEST_WHOLE} columns or rows are looked at \
             as the course writes them, RGB of up to {}×{}",
            LARGEST.0, LARGEST.1
        ));
    }
    let notes = viewer_notes(info);
    let kept_rows = if is_whole { rows } else { (KEPT_BYTES / 3) as u32 / columns };
    let row_step = rows.div_ceil(kept_rows);
    let row_bytes = reader.output_line_size(columns).unwrap_or(0);
    let channels = reader.output_color_type().0.samples();
    let mut bytes = vec![0; row_bytes * if is_whole { rows as usize } else { 1 }];
    if is_whole {
        reader.next_frame(&mut bytes).map_err(damage_clause)?;
    }
    let (mut kept, mut transparent_count) = (vec![], 0);
    for j in 0..rows {
        if !is_whole {
            reader.read_row(&mut bytes).map_err(damage_clause)?;
        }
        let start = if is_whole { j as usize * row_bytes } else { 0 };
        let row = &bytes[start..start + row_bytes];
        for pixel in row.chunks_exact(channels).filter(|_| j.is_multiple_of(row_step)) {
            match *pixel {
                [grey] | [grey, _] => kept.extend([grey; 3]),
                _ => kept.extend(&pixel[..3]),
            }
            let alpha = if channels % 2 == 0 { pixel[channels - 1] } else { 255 };
            transparent_count += usize::from(alpha < 255);
        }
    }
    let kept = RgbImage::from_raw(columns, rows.div_ceil(row_step), kept);
    let rows_kept = kept.ok_or("is a damaged PNG file: rows are missing")?;
    Ok(Picture { size: (columns, rows), row_step, rows: rows_kept, transparent_count, notes })
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
fn viewer_notes(info: &Info) -> Vec<&'static str> {
    let exif = info.exif_metadata.as_deref();
    let orientation = exif.and_then(Orientation::from_exif_chunk);
    let is_grey = matches!(info.color_type, ColorType::Grayscale | ColorType::GrayscaleAlpha);
    let has_profile = info.icc_profile.is_some() || info.gama_chunk.is_some();
    let notes = [
        (is_grey, "The file is grey: one number per pixel, and ours has three."),
        (
            info.bit_depth == BitDepth::Sixteen,
            "The file has 16 bits per channel; the upper 8 were compared.",
        ),
        (
            has_profile,
            "It has a colour profile or a gamma, ignored here, so a viewer may show other colours.",
        ),
        (
            orientation.is_some_and(|one| one != Orientation::NoTransforms),
            "Its EXIF data, ignored here, asks a viewer to turn it.",
        ),
        (
            info.animation_control.is_some(),
            "It is an animation; only its first picture was compared.",
        ),
    ];
    notes.into_iter().filter(|(is_so, _)| *is_so).map(|(_, note)| note).collect()
}
