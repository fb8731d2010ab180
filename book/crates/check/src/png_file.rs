use image::codecs::png::PngDecoder;
use image::{DynamicImage, ImageDecoder, ImageError, Limits, Pixel, RgbImage};
use std::io::Cursor;

/// How PNG files begin.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

const COPIED_AS_TEXT: &str =
    "a PNG file whose first bytes have changed, as by a copy as text; copy it as binary";
const WEB_PAGE: &str = "a web page, not the picture on it; save the picture itself";

/// Bytes of files that are no PNG files, from which byte on, and what such a file is; at the end
/// the beginnings of PNG files that a copy has damaged.
const FORMATS: [(usize, &[u8], &str); 18] = [
    (0, b"\xff\xd8\xff", "a JPEG, which has lost details; draw it again as PNG"),
    (8, b"WEBP", "a WebP picture; save it as PNG"),
    (0, b"GIF8", "a GIF, which has 256 colours at most; draw it again as PNG"),
    (10, b"\x36\0\0\0\x28\0\0\0", "a BMP picture; save it as PNG"),
    (0, b"P6\n", "a PPM picture; save it as PNG"),
    (0, b"II*\0", "a TIFF picture; save it as PNG"),
    (0, b"MM\0*", "a TIFF picture; save it as PNG"),
    (4, b"ftyp", "a film, or a picture such as HEIC or AVIF; save it as PNG"),
    (0, b"%PDF", "a PDF; save the picture as PNG"),
    (0, b"PK\x03\x04", "a ZIP archive, or a document that is one; unpack it first"),
    (0, b"\x1f\x8b", "a gzip archive; unpack it first"),
    (0, b"version https://git-lfs", "a pointer of Git LFS: `git lfs pull` fetches the picture"),
    (0, b"<!doctype html", WEB_PAGE),
    (0, b"<html", WEB_PAGE),
    (0, b"<svg", "an SVG drawing; save it as PNG"),
    (0, b"\x89PNG", COPIED_AS_TEXT),
    (0, b"\xEF\xBF\xBDPNG", COPIED_AS_TEXT),
    (0, b"\xC2\x89PNG", COPIED_AS_TEXT),
];

/// The most bytes of a file, and the most that a chunk of it is unpacked to.
pub(crate) const FILE_BYTES: u64 = 1 << 26;

/// The columns and rows of the largest picture, as the programs draw it with `--width 8192`.
const LARGEST: (u32, u32) = (8192, 4608);

pub(crate) struct Picture {
    /// The pixels, without alpha.
    pub rgb: RgbImage,
    /// How many pixels are not opaque.
    pub transparent_count: usize,
    /// Sentences about what the file hasn't, and what was left out.
    pub notes: Vec<&'static str>,
}

/// Reads the picture in a PNG file, or says in half a sentence why it can't be read.
///
/// The size is looked at before anything is unpacked.
pub(crate) fn read_png(file: &[u8]) -> Result<Picture, String> {
    if FILE_BYTES < file.len() as u64 {
        return Err(too_large_clause(FILE_BYTES));
    }
    if let Some(format_clause) = other_format_clause(file) {
        return Err(format!("is {format_clause}"));
    }
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(FILE_BYTES);
    let decoder = PngDecoder::with_limits(Cursor::new(file), limits);
    let decoder = decoder.map_err(damage_clause)?;
    let (columns, rows) = LARGEST;
    if 3 * u64::from(columns) * u64::from(rows) < decoder.total_bytes() {
        return Err(format!(
            "is too large: unpacked, it has more bytes than {columns}×{rows} pixels"
        ));
    }
    let colour = decoder.color_type();
    let has_16_bits = colour.bytes_per_pixel() == 2 * colour.channel_count();
    let is_animated = decoder.is_apng().is_ok_and(|is_so| is_so);
    let notes = [
        (is_animated, "The file is animated; its first picture was looked at."),
        (!colour.has_color(), "The file is grey and holds no colours."),
        (has_16_bits, "The file has 16 bits per channel, which were rounded to 8."),
    ];
    let notes = notes.into_iter().filter(|(is_so, _)| *is_so).map(|(_, note)| note).collect();
    let picture = DynamicImage::from_decoder(decoder).map_err(damage_clause)?;
    if !picture.color().has_alpha() {
        return Ok(Picture { rgb: picture.into_rgb8(), transparent_count: 0, notes });
    }
    let rgba = picture.into_rgba8();
    let transparent_count = rgba.pixels().filter(|pixel| pixel[3] < 255).count();
    let rgb = RgbImage::from_fn(rgba.width(), rgba.height(), |i, j| rgba[(i, j)].to_rgb());
    Ok(Picture { rgb, transparent_count, notes })
}

pub(crate) fn too_large_clause(most_bytes: u64) -> String {
    format!("is too large: the limit is {} MB", most_bytes >> 20)
}

/// Half a sentence, such as `a PDF; save the picture as PNG`: the format of a file by its
/// first bytes, behind blanks and in any case; None for a PNG file.
fn other_format_clause(file: &[u8]) -> Option<&'static str> {
    if file.starts_with(PNG) {
        return None;
    }
    let start = file.trim_ascii_start();
    let is_format = |(first, bytes, _): &&(usize, &[u8], &str)| {
        let found = start.get(*first..first + bytes.len());
        found.is_some_and(|found| found.eq_ignore_ascii_case(bytes))
    };
    let clause = FORMATS.iter().find(is_format).map(|(_, _, clause)| *clause);
    match file {
        [] => Some("empty"),
        _ if PNG.starts_with(file) => Some("the beginning of a PNG file, and no more"),
        _ => Some(clause.unwrap_or("not a PNG file")),
    }
}

/// Says what a decoder's error means for the file.
fn damage_clause(error: ImageError) -> String {
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
