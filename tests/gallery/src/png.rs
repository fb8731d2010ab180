use crate::view::View;
use png::{BitDepth, ColorType, Decoder, DecodingError, Reader, Transformations};
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
    pub fn kind(&self) -> Vec<&'static str> {
        let info = self.reader.info();
        let colours = match info.color_type {
            ColorType::Grayscale | ColorType::GrayscaleAlpha => {
                "The file is grey: it has one number a pixel, and ours has three."
            }
            ColorType::Indexed => {
                "The file has a palette: a program has chosen at most 256 colours for it."
            }
            _ => "",
        };
        let bits = match info.bit_depth {
            BitDepth::Sixteen => {
                "The file has 16 bits a channel, and ours has 8; they were rounded."
            }
            _ => "",
        };
        [colours, bits].into_iter().filter(|told| !told.is_empty()).collect()
    }

    /// Calls `see` with each row, from the top, and its pixels in red, green and blue.
    pub fn rows(
        mut self,
        mut see: impl FnMut(u32, &[[u8; 3]]),
    ) -> Result<(), String> {
        let (colour, depth) = self.reader.output_color_type();
        let rgb = |row: &[u8]| rgb(row, colour, depth);
        if self.reader.info().interlaced {
            let size = self.reader.output_buffer_size().ok_or("is too large")?;
            let mut all = vec![0; size];
            let line = self.reader.next_frame(&mut all).map_err(damaged)?.line_size;
            let rows = all.chunks(line.max(1)).zip(0..);
            rows.for_each(|(row, j)| see(j, &rgb(row)));
            return Ok(());
        }
        for j in 0..self.size().1 {
            let row = self.reader.next_row().map_err(damaged)?;
            see(
                j,
                &rgb(row.ok_or("is a damaged PNG file: rows are missing")?.data()),
            );
        }
        Ok(())
    }
}

/// The picture in a file, and what is to be said of the file.
pub(crate) fn read<R: BufRead + Seek>(
    file: R,
) -> Result<(View, Vec<&'static str>), String> {
    let png = Png::open(file)?;
    let (mut view, kind) = (View::new(png.size()), png.kind());
    png.rows(|j, row| view.fill(j, row.iter().copied()))?;
    Ok((view, kind))
}

/// Red, green and blue of the pixels of a row; alpha does not matter.
fn rgb(row: &[u8], colour: ColorType, depth: BitDepth) -> Vec<[u8; 3]> {
    let bytes: Vec<u8> = match depth {
        BitDepth::Sixteen => {
            let rounded = |two: &[u8]| {
                ((u32::from(two[0]) * 256 + u32::from(two[1]) + 128) / 257) as u8
            };
            row.chunks_exact(2).map(rounded).collect()
        }
        _ => row.to_vec(),
    };
    let pixels = bytes.chunks_exact(colour.samples());
    match colour.samples() {
        1 | 2 => pixels.map(|pixel| [pixel[0]; 3]).collect(),
        _ => pixels.map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect(),
    }
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
