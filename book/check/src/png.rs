use image::codecs::png::PngDecoder;
use image::{ImageDecoder, Limits, RgbImage};
use std::io::{BufRead, Seek};

/// The most columns and the most rows: as many as the programs of the steps draw.
const MOST: u32 = 16384;

/// The most memory that a picture may take, 16384×4096 pixels of 16 bits.
const MEMORY: u64 = 1 << 29;

/// The picture in a PNG file and what is to be said of the file, in whole lines; or half
/// a sentence that says why it can't be read.
///
/// The size is looked at before anything is read, so that no file fills the memory.
pub fn read(mut file: impl BufRead + Seek) -> Result<(RgbImage, String), String> {
    if let Some(other) = other_format(&mut file)? {
        return Err(format!("is {other}"));
    }
    let damaged = |error| format!("is a damaged PNG file: {error}");
    let mut limits = Limits::default();
    limits.max_alloc = Some(MEMORY);
    let mut decoder =
        PngDecoder::with_limits(file, limits.clone()).map_err(damaged)?;
    let ((width, height), colour) = (decoder.dimensions(), decoder.color_type());
    if MOST < width || MOST < height || MEMORY < decoder.total_bytes() {
        return Err(format!("is {width}×{height} pixels, which is too large"));
    }
    decoder.set_limits(limits).map_err(damaged)?;
    let channels = usize::from(colour.channel_count());
    let size = usize::from(colour.bytes_per_pixel()) / channels;
    let mut bytes = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut bytes).map_err(damaged)?;
    // Two bytes are rounded to one.
    let byte = |number: &[u8]| match number {
        [low, high] => {
            ((u32::from(u16::from_ne_bytes([*low, *high])) + 128) / 257) as u8
        }
        _ => number[0],
    };
    let channel = |pixel: &[u8], k: usize| byte(&pixel[size * k..][..size]);
    let (mut picture, mut is_clear) = (RgbImage::new(width, height), false);
    let places = picture.pixels_mut().zip(bytes.chunks_exact(size * channels));
    for (place, pixel) in places {
        place.0 = match channels {
            1 | 2 => [channel(pixel, 0); 3],
            _ => [0, 1, 2].map(|k| channel(pixel, k)),
        };
        is_clear |= channels % 2 == 0 && channel(pixel, channels - 1) != 255;
    }
    let notes = [
        (
            channels < 3,
            "The file is grey: it has one number a pixel, and ours has three.",
        ),
        (size == 2, "The file has 16 bits a channel; they were rounded to 8."),
        (is_clear, "Some of its pixels are transparent; that was left out."),
    ];
    let notes = notes.into_iter().filter(|(is, _)| *is).map(|(_, note)| note);
    Ok((picture, notes.collect::<Vec<_>>().join("\n")))
}

/// What a file is, by its first bytes, if it is not a PNG file.
fn other_format(file: &mut impl BufRead) -> Result<Option<&'static str>, String> {
    let start =
        file.fill_buf().map_err(|error| format!("can't be read: {error}"))?;
    Ok(match start {
        [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1A, b'\n', ..] => None,
        [0xFF, 0xD8, ..] => Some("a JPEG, which has lost details; save it as PNG"),
        [b'G', b'I', b'F', ..] => {
            Some("a GIF, which has few colours; save it as PNG")
        }
        [] => Some("not a PNG file: it is empty"),
        _ => Some("not a PNG file"),
    })
}
