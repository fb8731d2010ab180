use image::codecs::png::PngDecoder;
use image::{ImageDecoder, Limits, Rgb, RgbImage};
use std::io::Cursor;

/// The most columns and the most rows: twice as many columns as the programs of the steps draw.
const MOST: u32 = 16384;

/// The most memory that a picture may take, 16384×4096 pixels of 16 bits.
const MEMORY: u64 = 1 << 29;

/// The picture in a PNG file and what is to be said of the file, in whole lines; or half
/// a sentence that says why it can't be read.
///
/// The size is looked at before anything is read, so that no file fills the memory.
pub fn read(file: &[u8]) -> Result<(RgbImage, String), String> {
    if let Some(other) = other_format(file) {
        return Err(format!("is {other}"));
    }
    let damaged = |error| format!("is a damaged PNG file: {error}");
    let mut limits = Limits::default();
    limits.max_alloc = Some(MEMORY);
    let decoder = PngDecoder::with_limits(Cursor::new(file), limits.clone());
    let mut decoder = decoder.map_err(damaged)?;
    let ((width, height), colour) = (decoder.dimensions(), decoder.color_type());
    if MOST < width || MOST < height || MEMORY < decoder.total_bytes() {
        return Err(format!("is {width}×{height} pixels, which is too large"));
    }
    decoder.set_limits(limits).map_err(damaged)?;
    let mut bytes = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut bytes).map_err(damaged)?;
    let mut notes = String::new();
    let channels = usize::from(colour.channel_count());
    if channels < 3 {
        notes +=
            "The file is grey: it has one number a pixel, and ours has three.\n";
    }
    if 8 * u16::from(colour.channel_count()) < colour.bits_per_pixel() {
        notes += "The file has 16 bits a channel; they were rounded to 8.\n";
        let wide = bytes.chunks_exact(2).map(|two| [two[0], two[1]]);
        let byte = |two| (u32::from(u16::from_ne_bytes(two)) + 128) / 257;
        bytes = wide.map(|two| byte(two) as u8).collect();
    }
    let mut pixels = bytes.chunks_exact(channels);
    if colour.has_alpha() && pixels.clone().any(|pixel| pixel[channels - 1] != 255)
    {
        notes += "Some of its pixels are transparent; that was left out.\n";
    }
    let picture = RgbImage::from_fn(width, height, |_, _| {
        let pixel = pixels.next().unwrap_or(&[0; 4]);
        Rgb(if channels < 3 {
            [pixel[0]; 3]
        } else {
            [pixel[0], pixel[1], pixel[2]]
        })
    });
    Ok((picture, notes))
}

/// What a file is, by its first bytes, if it is not a PNG file.
fn other_format(file: &[u8]) -> Option<&'static str> {
    match file {
        [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1A, b'\n', ..] => None,
        [0xFF, 0xD8, ..] => Some("a JPEG, which has lost details; save it as PNG"),
        [b'G', b'I', b'F', ..] => {
            Some("a GIF, which has few colours; save it as PNG")
        }
        [] => Some("not a PNG file: it is empty"),
        _ => Some("not a PNG file"),
    }
}
