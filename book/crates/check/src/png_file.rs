use crate::file_format::other_format_clause;
use image::RgbImage;
use image::metadata::Orientation;
use png::{BitDepth, ColorType, Info, Transformations};
use std::error::Error;
use std::io::Cursor;

/// The most bytes of a file, and the most that a chunk of it is unpacked to.
pub(crate) const FILE_BYTES: u64 = 1 << 26;

/// The columns and rows of the largest picture, as the programs draw it with `--width 8192`.
const LARGEST: (u32, u32) = (8192, 4608);

/// A picture that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The pixels, without alpha.
    pub rgb: RgbImage,
    /// How many pixels are not opaque.
    pub transparent_count: usize,
    /// Sentences about the file.
    pub notes: Vec<&'static str>,
}

/// Reads the picture in a PNG file, or says in half a sentence why it can't be read.
///
/// The size is looked at before anything is unpacked.
pub fn read_png(file: &[u8]) -> Result<Picture, String> {
    if FILE_BYTES < file.len() as u64 {
        return Err(too_large_clause(FILE_BYTES));
    }
    if let Some(format_clause) = other_format_clause(file) {
        return Err(format!("is {format_clause}"));
    }
    let limits = png::Limits { bytes: FILE_BYTES as usize };
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(file), limits);
    decoder.set_transformations(Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(damage_clause)?;
    let most_bytes = 3 * LARGEST.0 as usize * LARGEST.1 as usize;
    let size = reader.output_buffer_size().filter(|size| *size <= most_bytes).ok_or_else(|| {
        format!("is too large: a picture of {}×{} pixels is the largest", LARGEST.0, LARGEST.1)
    })?;
    let mut bytes = vec![0; size];
    reader.next_frame(&mut bytes).map_err(damage_clause)?;
    let channels = reader.output_color_type().0.samples();
    let has_alpha = channels.is_multiple_of(2);
    let alphas = bytes.chunks_exact(channels).filter_map(|pixel| pixel.last());
    let transparent_count = alphas.filter(|alpha| has_alpha && **alpha < 255).count();
    if channels != 3 {
        // A grey pixel has one channel before its alpha.
        let order = if channels < 3 { [0; 3] } else { [0, 1, 2] };
        bytes = bytes.chunks_exact(channels).flat_map(|pixel| order.map(|k| pixel[k])).collect();
    }
    let info = reader.info();
    let rgb = RgbImage::from_raw(info.width, info.height, bytes);
    let rgb = rgb.ok_or("is a damaged PNG file: rows are missing")?;
    Ok(Picture { rgb, transparent_count, notes: viewer_notes(info) })
}

/// Says that a file is larger than it may be.
pub(crate) fn too_large_clause(most_bytes: u64) -> String {
    format!("is too large: the limit is {} MB", most_bytes >> 20)
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
    // Many programs write the gamma that screens have anyway.
    let has_gamma = info.gama_chunk.is_some_and(|gamma| gamma.into_scaled() != 45_455);
    let notes = [
        (is_grey, "The file is grey: one number per pixel, and ours has three."),
        (
            info.bit_depth == BitDepth::Sixteen,
            "The file has 16 bits per channel; the upper 8 were compared.",
        ),
        (
            info.icc_profile.is_some() || has_gamma,
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
