use crate::apart;
use crate::view::View;
use crate::{Cause, Rest};
use image::{Rgb, RgbImage};
use png::{BitDepth, ColorType, Decoder, DecodingError, Reader, Transformations};
use std::borrow::Cow;
use std::io::{BufRead, Seek};

/// The most columns and the most rows: as many as the programs of the steps draw.
const MOST: u32 = 16384;

/// The most pixels of a file whose rows do not come one after the other.
const MOST_INTERLACED: u64 = 4096 * 2160;

/// A PNG file, of which rows have been read.
pub(crate) struct Png<R: BufRead + Seek> {
    reader: Reader<R>,
}

impl<R: BufRead + Seek> Png<R> {
    /// Reads the beginning of a file, or says in half a sentence what the file is that
    /// it can't be read.
    ///
    /// The size is looked at before anything is read, so that no file can fill the
    /// memory.
    pub fn open(mut file: R) -> Result<Self, String> {
        if let Some(other) = other_format(&mut file)? {
            return Err(format!("is {other}"));
        }
        let mut decoder = Decoder::new(file);
        decoder.set_ignore_text_chunk(true);
        decoder.set_ignore_iccp_chunk(true);
        decoder.set_transformations(Transformations::EXPAND);
        let info = decoder.read_header_info().map_err(damaged)?;
        let (width, height) = info.size();
        let all = u64::from(width) * u64::from(height);
        if MOST < width || MOST < height {
            return Err(format!(
                "is {width}×{height} pixels; allowed are {MOST}×{MOST}"
            ));
        }
        if info.interlaced && MOST_INTERLACED < all {
            return Err("is interlaced and large; save it without".to_owned());
        }
        Ok(Self { reader: decoder.read_info().map_err(damaged)? })
    }

    /// Its columns and rows.
    pub fn size(&self) -> (u32, u32) {
        self.reader.info().size()
    }

    /// What of the file, other than its pixels, is not as our programs write it.
    fn notes(&self) -> Notes {
        let info = self.reader.info();
        let lossy = match info.color_type {
            ColorType::Grayscale | ColorType::GrayscaleAlpha => {
                "The file is grey: it has one number a pixel, and ours has three.\n"
            }
            ColorType::Indexed => {
                "The file has a palette: a program has chosen at most 256 colours.\n"
            }
            _ => "",
        };
        let bits = match info.bit_depth {
            BitDepth::Sixteen => {
                "The file has 16 bits a channel; they were rounded to 8.\n"
            }
            _ => "",
        };
        Notes { text: format!("{lossy}{bits}"), is_lossy: !lossy.is_empty() }
    }

    /// Calls `see` with each row, from the top, and its pixels in red, green and blue;
    /// returns whether one of them is transparent.
    pub fn rows(
        mut self,
        mut see: impl FnMut(u32, &[[u8; 3]]),
    ) -> Result<bool, String> {
        let (colour, depth) = self.reader.output_color_type();
        let mut is_clear = false;
        let mut rgb = |row: &[u8]| {
            let bytes = bytes(row, depth);
            is_clear |= has_clear(&bytes, colour);
            rgb(&bytes, colour)
        };
        if self.reader.info().interlaced {
            let size = self.reader.output_buffer_size().ok_or("is too large")?;
            let mut all = vec![0; size];
            let line = self.reader.next_frame(&mut all).map_err(damaged)?.line_size;
            let rows = all.chunks(line.max(1)).zip(0..);
            rows.for_each(|(row, j)| see(j, &rgb(row)));
            return Ok(is_clear);
        }
        for j in 0..self.size().1 {
            let row = self.reader.next_row().map_err(damaged)?;
            see(
                j,
                &rgb(row.ok_or("is a damaged PNG file: rows are missing")?.data()),
            );
        }
        Ok(is_clear)
    }
}

/// What is to be said of a file, other than of its picture.
#[derive(Clone, Debug, Default)]
pub(crate) struct Notes {
    /// Whole lines, or nothing.
    pub text: String,
    /// Whether its colours can't be those that were drawn.
    pub is_lossy: bool,
}

/// The picture in a file, and what is to be said of the file.
pub(crate) fn read(file: impl BufRead + Seek) -> Result<(View, Notes), String> {
    let png = Png::open(file)?;
    let (mut view, mut notes) = (View::new(png.size()), png.notes());
    if png.rows(|j, row| view.fill(j, row))? {
        notes.text += "Some of its pixels are transparent; that was left out.\n";
    }
    Ok((view, notes))
}

/// The picture in a file, or what the file is that it can't be read; no picture, where
/// that is too large to be kept whole.
pub fn picture(mut file: impl BufRead + Seek) -> Result<Option<RgbImage>, String> {
    // As `check` does it: one copy of the decoder.
    let (view, _) = read(&mut file)?;
    Ok((view.stride == 1).then_some(view.kept))
}

/// What `cause` leaves unexplained of the picture in a file, of which no more than a row
/// is held at once.
pub(crate) fn rest(
    file: impl BufRead + Seek,
    cause: &Cause,
) -> Result<Rest, String> {
    let png = Png::open(file)?;
    let (width, height) = png.size();
    let parts = cause.parts((width, height));
    let mut rest = Rest::new(width as usize * height as usize);
    png.rows(|j, row| {
        for (yours, i) in row.iter().zip(0..) {
            let ours = parts.pixel(cause.step, cause.samples, i, j);
            rest.add(apart(&Rgb(*yours), &ours));
        }
    })?;
    Ok(rest)
}

/// The numbers of a row, each rounded to one byte.
fn bytes(row: &[u8], depth: BitDepth) -> Cow<'_, [u8]> {
    let rounded = |two: &[u8]| {
        let number = u32::from(two[0]) * 256 + u32::from(two[1]);
        ((number + 128) / 257) as u8
    };
    match depth {
        BitDepth::Sixteen => row.chunks_exact(2).map(rounded).collect(),
        _ => Cow::Borrowed(row),
    }
}

/// Red, green and blue of the pixels of a row; alpha does not matter.
fn rgb(bytes: &[u8], colour: ColorType) -> Vec<[u8; 3]> {
    let pixels = bytes.chunks_exact(colour.samples());
    match colour.samples() {
        1 | 2 => pixels.map(|pixel| [pixel[0]; 3]).collect(),
        _ => pixels.map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect(),
    }
}

/// Whether a pixel of a row is transparent.
fn has_clear(bytes: &[u8], colour: ColorType) -> bool {
    let has_alpha = matches!(colour, ColorType::GrayscaleAlpha | ColorType::Rgba);
    let mut pixels = bytes.chunks_exact(colour.samples());
    has_alpha && pixels.any(|pixel| pixel.last() != Some(&255))
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

fn damaged(error: DecodingError) -> String {
    format!("is a damaged PNG file: {error}")
}
