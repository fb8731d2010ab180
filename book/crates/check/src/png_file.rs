//! Reads the picture in a PNG file, or recognises which other format the file has.

use image::RgbImage;
use png::{BitDepth, ColorType, Decoder, DecodingError, Info, Limits, Transformations};
use std::io::{Cursor, ErrorKind};
use step01_rays::MAX_PIXELS;
use thiserror::Error;

/// The signature at the start of each PNG file.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

const COPIED_AS_TEXT: &str = "a PNG file whose first bytes have changed, as if it had been copied as text; copy it as binary";
const BEHIND_MARK: &str =
    "a PNG file with a byte order mark in front, as if it were text; copy it as binary";
const IN_BASE64: &str = "a PNG file as text, in base64; decode it first";
const IN_UTF_16: &str = "text in UTF-16, as > writes it in PowerShell; have the program write the \
                         picture itself";
const WEB_PAGE: &str = "a web page, not the picture on it; save the picture itself";

/// Formats other than PNG. An entry consists of the offset of the format's signature, the
/// signature, and the words that follow "is" in the error message. The offset is counted from the
/// first byte that isn't white space. The last entries recognise PNG files whose first bytes were
/// changed by copying.
const FORMATS: [(usize, &[u8], &str); 26] = [
    (0, b"\xff\xd8\xff", "a JPEG, which has lost details; draw it again as PNG"),
    (8, b"WEBP", "a WebP picture; save it as PNG"),
    (0, b"GIF8", "a GIF, which has 256 colours at most; draw it again as PNG"),
    (0, b"II*\0", "a TIFF picture; save it as PNG"),
    (0, b"MM\0*", "a TIFF picture; save it as PNG"),
    (0, b"qoif", "a QOI picture; save it as PNG"),
    (0, b"#?RADIANCE", "an HDR picture; save it as PNG"),
    (0, b"\x76\x2f\x31\x01", "an EXR picture; save it as PNG"),
    (0, b"8BPS", "a Photoshop file; save the picture as PNG"),
    (4, b"ftyp", "a film, or a picture such as HEIC or AVIF; save it as PNG"),
    (0, b"%PDF", "a PDF; save the picture as PNG"),
    (0, b"PK\x03\x04", "a ZIP archive, or a document that is one; unpack it first"),
    (0, b"\x1f\x8b", "a gzip archive; unpack it first"),
    (0, b"version https://git-lfs", "a pointer of Git LFS: `git lfs pull` fetches the picture"),
    (0, b"<!doctype html", WEB_PAGE),
    (0, b"<html", WEB_PAGE),
    (0, b"<svg", "an SVG drawing; save it as PNG"),
    (0, b"iVBORw0KGgo", IN_BASE64),
    (0, b"data:image/png;base64,", IN_BASE64),
    (0, b"\xff\xfe", IN_UTF_16),
    (0, b"\xfe\xff", IN_UTF_16),
    (0, b"\xef\xbb\xbf\x89PNG", BEHIND_MARK),
    (0, b"\xef\xbb\xbf\xc2\x89PNG", COPIED_AS_TEXT),
    (0, b"\x89PNG", COPIED_AS_TEXT),
    (0, b"\xEF\xBF\xBDPNG", COPIED_AS_TEXT),
    (0, b"\xC2\x89PNG", COPIED_AS_TEXT),
];

/// The clauses about Netpbm files, from P1 to P7.
const NETPBM: [&str; 7] = [
    "a PBM picture, written as text (P1); save it as PNG",
    "a PGM picture, written as text (P2); save it as PNG",
    "a PPM picture, written as text (P3); save it as PNG",
    "a PBM picture (P4); save it as PNG",
    "a PGM picture (P5); save it as PNG",
    "a PPM picture (P6); save it as PNG",
    "a PAM picture (P7); save it as PNG",
];

/// The possible lengths of the second header in a BMP file, one for each version of the format.
const BMP_HEADERS: [u8; 7] = [12, 40, 52, 56, 64, 108, 124];

/// The maximum size of a file in bytes. It is also the maximum amount of memory that the decoder
/// may allocate for itself, for instance to unpack a chunk.
pub(crate) const MAX_FILE_BYTES: u64 = 1 << 26;

/// The maximum size of the decoded pixels in bytes: enough for the largest picture with alpha and 8
/// bits per channel.
const MAX_BYTES: u64 = 4 * MAX_PIXELS;

/// The contents of a PNG file.
pub(crate) struct DecodedPng {
    /// The pixels, without alpha.
    pub rgb: RgbImage,
    /// Whether some pixels are not opaque.
    pub is_transparent: bool,
    /// One sentence for each unusual property of the file, such as a palette or transparent pixels.
    pub notes: Vec<String>,
}

/// Why the picture in a file can't be read. Each message is a clause to follow the file name.
#[derive(Debug, Error)]
pub enum PngError {
    /// The file isn't a PNG file, or is only the beginning of a PNG file.
    #[error("is {0}")]
    OtherFormat(&'static str),
    /// The file is larger than the limit.
    #[error("is too large: the limit is {} MB", MAX_FILE_BYTES >> 20)]
    TooManyBytes,
    /// The picture has more pixels than the course's programs would draw.
    #[error(
        "is too large: it has {columns}×{rows} pixels, and the limit is 8192×4608 or as many in a \
         different shape"
    )]
    TooManyPixels {
        /// The number of columns in the picture.
        columns: u32,
        /// The number of rows in the picture.
        rows: u32,
    },
    /// The pixels would take too much memory.
    #[error(
        "is too large: with 16 bits per channel, {columns}×{rows} pixels take up more than {} MB",
        MAX_BYTES >> 20
    )]
    TooMuchMemory {
        /// The number of columns in the picture.
        columns: u32,
        /// The number of rows in the picture.
        rows: u32,
    },
    /// The decoder rejected the file.
    #[error("is a damaged PNG file: {}", damage_clause(.0))]
    Damaged(#[source] DecodingError),
    /// The decoder returned too few pixels.
    #[error("contains fewer pixels than its header says")]
    MissingPixels,
}

/// Reads the picture in a PNG file. Checks the size before unpacking anything.
pub(crate) fn read_png(file: &[u8]) -> Result<DecodedPng, PngError> {
    if file.len() as u64 > MAX_FILE_BYTES {
        return Err(PngError::TooManyBytes);
    }
    if let Some(clause) = clause_unless_png(file) {
        return Err(PngError::OtherFormat(clause));
    }
    let limits = Limits { bytes: MAX_FILE_BYTES as usize };
    let mut decoder = Decoder::new_with_limits(Cursor::new(file), limits);
    // Expand palettes to colours, transparent colours to an alpha channel, and samples of fewer
    // than 8 bits to samples of 8 bits.
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_text_chunk(true);
    let mut reader = decoder.read_info().map_err(PngError::Damaged)?;
    let (columns, rows) = reader.info().size();
    if u64::from(columns) * u64::from(rows) > MAX_PIXELS {
        return Err(PngError::TooManyPixels { columns, rows });
    }
    // None means that the size doesn't fit in a usize.
    let byte_count = reader.output_buffer_size().unwrap_or(usize::MAX);
    if byte_count as u64 > MAX_BYTES {
        return Err(PngError::TooMuchMemory { columns, rows });
    }
    let mut notes = describe_unusual_features(reader.info());
    let mut bytes = vec![0; byte_count];
    reader.next_frame(&mut bytes).map_err(PngError::Damaged)?;
    let (colour_type, depth) = reader.output_color_type();
    let samples = if depth == BitDepth::Sixteen { round_samples(&bytes) } else { bytes };
    let (rgb, transparent) = split_alpha(samples, colour_type);
    if let Some(first) = transparent.first {
        let (count, pixel_count) = (transparent.count, columns as usize * rows as usize);
        let (i, j) = (first % columns as usize, first / columns as usize);
        notes.push(format!(
            "In {count} of {pixel_count} pixels the file is not opaque, first in column {i}, row \
             {j}: a viewer may show other colours there."
        ));
    }
    let rgb = RgbImage::from_raw(columns, rows, rgb).ok_or(PngError::MissingPixels)?;
    Ok(DecodedPng { rgb, is_transparent: transparent.count > 0, notes })
}

/// Returns a sentence for each feature of a PNG file that the course's programs don't use.
fn describe_unusual_features(info: &Info) -> Vec<String> {
    let mut notes = vec![];
    if info.color_type == ColorType::Indexed {
        let max_colours = 1_u32 << info.bit_depth as u8;
        notes.push(format!("The file has a palette, with at most {max_colours} colours."));
    }
    if matches!(info.color_type, ColorType::Grayscale | ColorType::GrayscaleAlpha) {
        notes.push("The file is grey and holds no colours.".to_owned());
    }
    if info.bit_depth == BitDepth::Sixteen {
        notes.push("The file has 16 bits per channel, which were rounded to 8.".to_owned());
    }
    if info.animation_control().is_some() {
        notes.push(
            "The file is animated; the answer is about its still image, which programs without \
             animation show."
                .to_owned(),
        );
    }
    notes
}

/// Rounds 16-bit samples to 8 bits.
fn round_samples(bytes: &[u8]) -> Vec<u8> {
    let round = |pair: &[u8]| {
        let sample = u32::from(pair[0]) << 8 | u32::from(pair[1]);
        ((sample + 128) / 257) as u8
    };
    bytes.chunks_exact(2).map(round).collect()
}

/// How many pixels aren't opaque, and which of them comes first.
#[derive(Default)]
struct TransparentPixels {
    count: usize,
    /// The index of the first pixel that isn't opaque, counted row by row.
    first: Option<usize>,
}

/// Splits off the alpha channel. Returns the red, green and blue of all pixels, and a summary of
/// the pixels that aren't opaque.
fn split_alpha(samples: Vec<u8>, colour_type: ColorType) -> (Vec<u8>, TransparentPixels) {
    let mut transparent = TransparentPixels::default();
    let mut note_alpha = |index: usize, alpha: u8| {
        if alpha < 255 {
            transparent.count += 1;
            transparent.first.get_or_insert(index);
        }
    };
    let rgb = match colour_type {
        ColorType::Rgb | ColorType::Indexed => samples,
        ColorType::Grayscale => samples.iter().flat_map(|grey| [*grey; 3]).collect(),
        ColorType::GrayscaleAlpha => {
            let pixels = samples.chunks_exact(2).enumerate();
            let rgb = pixels.flat_map(|(index, pixel)| {
                note_alpha(index, pixel[1]);
                [pixel[0]; 3]
            });
            rgb.collect()
        }
        ColorType::Rgba => {
            let pixels = samples.chunks_exact(4).enumerate();
            let rgb = pixels.flat_map(|(index, pixel)| {
                note_alpha(index, pixel[3]);
                [pixel[0], pixel[1], pixel[2]]
            });
            rgb.collect()
        }
    };
    (rgb, transparent)
}

/// Recognises the format of a file by its first bytes, ignoring case and leading whitespace.
/// Returns a clause such as `a PDF; save the picture as PNG`, or None for a PNG file.
fn clause_unless_png(file: &[u8]) -> Option<&'static str> {
    if file.starts_with(PNG) {
        return None;
    }
    let start = file.trim_ascii_start();
    let is_format = |(offset, signature, _): &&(usize, &[u8], &str)| {
        let bytes = start.get(*offset..offset + signature.len());
        bytes.is_some_and(|bytes| bytes.eq_ignore_ascii_case(signature))
    };
    let format = FORMATS.iter().find(is_format).map(|(_, _, clause)| *clause);
    let clause = format.or_else(|| netpbm_clause(start)).or_else(|| bmp_clause(start));
    match file {
        [] => Some("empty"),
        _ if PNG.starts_with(file) => Some("the beginning of a PNG file, and no more"),
        _ => Some(clause.unwrap_or("not a PNG file")),
    }
}

/// Recognises a Netpbm file, which starts with `P`, a digit, and whitespace or a comment.
fn netpbm_clause(file: &[u8]) -> Option<&'static str> {
    let [b'P', digit, next, ..] = file else { return None };
    let number = digit.checked_sub(b'1')?;
    let is_separate = next.is_ascii_whitespace() || *next == b'#';
    NETPBM.get(usize::from(number)).copied().filter(|_| is_separate)
}

fn bmp_clause(file: &[u8]) -> Option<&'static str> {
    let header_bytes: [u8; 4] = file.get(14..18)?.try_into().ok()?;
    let header_length = u32::from_le_bytes(header_bytes);
    let is_bmp = file.starts_with(b"BM")
        && BMP_HEADERS.iter().any(|length| u32::from(*length) == header_length);
    is_bmp.then_some("a BMP picture; save it as PNG")
}

/// Explains what a decoder's error says about the file.
fn damage_clause(error: &DecodingError) -> &'static str {
    match error {
        DecodingError::IoError(error) if error.kind() == ErrorKind::UnexpectedEof => {
            "it is truncated; perhaps the copy was incomplete"
        }
        DecodingError::Format(_) => "some of its bytes are wrong; copy it again",
        _ => "its contents can't be unpacked",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_of_16_bits_are_rounded_to_8() {
        let samples = [0, 128, 129, 257, 0x8000, 65_406, 65_407, 65_535];
        let bytes: Vec<_> = samples.into_iter().flat_map(u16::to_be_bytes).collect();
        assert_eq!(round_samples(&bytes), [0, 0, 1, 1, 128, 254, 255, 255]);
    }

    #[test]
    fn alpha_is_split_off_and_counted() {
        let (rgb, transparent) = split_alpha(vec![1, 2, 3, 255, 4, 5, 6, 254], ColorType::Rgba);
        assert_eq!(rgb, [1, 2, 3, 4, 5, 6]);
        assert_eq!((transparent.count, transparent.first), (1, Some(1)));
        let (rgb, transparent) = split_alpha(vec![7, 0, 8, 0], ColorType::GrayscaleAlpha);
        assert_eq!(rgb, [7, 7, 7, 8, 8, 8]);
        assert_eq!((transparent.count, transparent.first), (2, Some(0)));
        let (rgb, transparent) = split_alpha(vec![7, 8], ColorType::Grayscale);
        assert_eq!(rgb, [7, 7, 7, 8, 8, 8]);
        assert_eq!((transparent.count, transparent.first), (0, None));
    }

    #[test]
    fn format_is_recognised_by_its_first_bytes() {
        assert_eq!(clause_unless_png(b"\x89PNG\r\n\x1a\n..."), None);
        assert_eq!(
            clause_unless_png(b"\x89PNG\r\n"),
            Some("the beginning of a PNG file, and no more")
        );
        assert_eq!(clause_unless_png(b"\n %pdf-1.7"), Some("a PDF; save the picture as PNG"));
        assert_eq!(clause_unless_png(b"P"), Some("not a PNG file"));
        assert_eq!(netpbm_clause(b"P6#"), Some("a PPM picture (P6); save it as PNG"));
        assert_eq!(netpbm_clause(b"P0 1"), None);
        assert_eq!(netpbm_clause(b"P8 1"), None);
        assert_eq!(netpbm_clause(b"P6"), None);
    }

    #[test]
    fn file_with_too_many_bytes_is_rejected_before_its_format_is_recognised() {
        let mut file = vec![b' '; MAX_FILE_BYTES as usize];
        assert!(matches!(read_png(&file), Err(PngError::OtherFormat(_))));
        file.push(b' ');
        assert!(matches!(read_png(&file), Err(PngError::TooManyBytes)));
    }
}
