use crate::file_format::other_format_clause;
use image::RgbImage;
use png::{
    BitDepth, ColorType, Decoder, DecodingError, Info, Limits, Transformations,
};
use std::io::{Cursor, ErrorKind};

/// The most pixels of a picture that is kept whole: 1920×1080.
const WHOLE: u64 = 1920 * 1080;

/// How many rows are kept of a larger picture.
const ROWS: u32 = 64;

/// The most columns and rows that a program of the steps draws: `--width 8192`, with an aspect
/// ratio of 1:4.
const LARGEST: (u32, u32) = (8192, 32768);

/// The most bytes of a file, and the most that are unpacked of it.
pub(crate) const FILE_BYTES: u64 = 1 << 27;
const UNPACKED_BYTES: u64 = 1 << 30;

/// A picture that was read: all of its rows, or some that are spread over it.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Columns and rows.
    pub size: (u32, u32),
    /// The numbers of the rows that are kept.
    pub rows: Vec<u32>,
    /// The rows that are kept, one below the other.
    pub pixels: RgbImage,
    /// Sentences about the file.
    pub notes: Vec<String>,
    /// Whether alpha is 0 in every pixel.
    pub is_invisible: bool,
}

impl Picture {
    /// A picture with all of its rows.
    pub fn from_all_rows(pixels: RgbImage) -> Self {
        let size = pixels.dimensions();
        let rows = (0..size.1).collect();
        Self { size, rows, pixels, notes: vec![], is_invisible: false }
    }

    /// Whether all of its rows are kept.
    pub fn has_all_rows(&self) -> bool {
        self.rows.len() == self.size.1 as usize
    }

    /// The same picture with at most `most_pixels` pixels, in rows spread over it.
    pub fn with_spread_rows(&self, most_pixels: u32) -> Self {
        let kept = self.rows.len() as u32;
        let rows = (most_pixels / self.size.0).clamp(1, kept);
        let places: Vec<_> = spread_indices(rows, kept).collect();
        let image = RgbImage::from_fn(self.size.0, rows, |i, k| {
            *self.pixels.get_pixel(i, places[k as usize])
        });
        let rows = places.iter().map(|k| self.rows[*k as usize]).collect();
        Self { rows, pixels: image, ..self.clone_without_rows() }
    }

    fn clone_without_rows(&self) -> Self {
        let (pixels, notes) = (RgbImage::new(0, 0), self.notes.clone());
        Self { pixels, notes, rows: vec![], ..*self }
    }
}

/// `count` of the numbers below `all`, spread over them.
fn spread_indices(index_count: u32, total: u32) -> impl Iterator<Item = u32> {
    let middle = move |k| {
        (2 * u64::from(k) + 1) * u64::from(total) / (2 * u64::from(index_count))
    };
    (0..index_count).map(move |k: u32| middle(k) as u32)
}

/// Reads the picture in a PNG file, or says in half a sentence why it can't be read.
///
/// The size is looked at before anything is unpacked, colour profiles and texts are not
/// unpacked at all, and of a large picture one row at a time is in the memory.
pub fn read_png(file: &[u8]) -> Result<Picture, String> {
    if FILE_BYTES < file.len() as u64 {
        return Err(too_large_clause());
    }
    if let Some(format_clause) = other_format_clause(file) {
        return Err(format!("is {format_clause}"));
    }
    let mut decoder =
        Decoder::new_with_limits(Cursor::new(file), Limits { bytes: 1 << 24 });
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_transformations(Transformations::EXPAND);
    let header = decoder.read_header_info().map_err(damage_clause)?;
    let size @ (width, height) = (header.width, header.height);
    let too_large = format!(
        "is {width}×{height} pixels, which is too large: the programs draw up to {}×{}",
        LARGEST.0, LARGEST.1
    );
    if LARGEST.0 < width || LARGEST.1 < height {
        return Err(too_large);
    }
    let mut reader = decoder.read_info().map_err(damage_clause)?;
    let line = reader.output_line_size(width).unwrap_or(usize::MAX);
    if UNPACKED_BYTES < line as u64 * u64::from(height) {
        return Err(too_large);
    }
    let format = reader.output_color_type();
    let mut notes = viewer_notes(file, reader.info(), format);
    let mut kept = Kept { format, bytes: vec![], most: 0, least: u8::MAX };
    let rows: Vec<_> = if u64::from(width) * u64::from(height) <= WHOLE {
        let mut bytes = vec![0; line * height as usize];
        reader.next_frame(&mut bytes).map_err(damage_clause)?;
        bytes.chunks_exact(line).for_each(|row| kept.push_row_as_rgb8(row));
        (0..height).collect()
    } else if reader.info().interlaced {
        return Err(format!("{too_large} interlaced; save it without"));
    } else {
        let rows: Vec<_> = spread_indices(ROWS.min(height), height).collect();
        for j in 0..height {
            let row = reader.next_row().map_err(damage_clause)?;
            if let Some(row) = row.filter(|_| rows.binary_search(&j).is_ok()) {
                kept.push_row_as_rgb8(row.data());
            }
        }
        rows
    };
    let pixels = RgbImage::from_raw(width, rows.len() as u32, kept.bytes);
    let pixels = pixels.ok_or("is a damaged PNG file: rows are missing")?;
    let is_invisible = kept.most == 0 && has_alpha(format.0);
    if kept.least < 255 && has_alpha(format.0) && !is_invisible {
        notes.push(
            "Some of its pixels are transparent, so that a viewer may show others; \
             that was left out."
                .to_owned(),
        );
    }
    Ok(Picture { size, rows, pixels, notes, is_invisible })
}

/// Says that a file is larger than any picture.
pub(crate) fn too_large_clause() -> String {
    format!("is too large: a picture has at most {} MB", FILE_BYTES >> 20)
}

fn has_alpha(colour: ColorType) -> bool {
    matches!(colour, ColorType::GrayscaleAlpha | ColorType::Rgba)
}

/// The bytes of the rows that are kept, and the range of their alpha.
struct Kept {
    format: (ColorType, BitDepth),
    bytes: Vec<u8>,
    most: u8,
    least: u8,
}

impl Kept {
    /// Keeps red, green and blue of a row.
    fn push_row_as_rgb8(&mut self, row: &[u8]) {
        let (colour, depth) = self.format;
        let narrow: Vec<u8>;
        let row = match depth {
            BitDepth::Sixteen => {
                let wide = row.as_chunks().0.iter();
                let byte = |two| (u32::from(u16::from_be_bytes(two)) + 128) / 257;
                narrow = wide.map(|two| byte(*two) as u8).collect();
                &narrow
            }
            _ => row,
        };
        for pixel in row.chunks_exact(colour.samples()) {
            match *pixel {
                [grey] => self.bytes.extend([grey; 3]),
                [grey, alpha] => {
                    self.bytes.extend([grey; 3]);
                    self.widen_alpha_range(alpha);
                }
                [r, g, b, alpha] => {
                    self.bytes.extend([r, g, b]);
                    self.widen_alpha_range(alpha);
                }
                _ => self.bytes.extend(pixel),
            }
        }
    }

    fn widen_alpha_range(&mut self, alpha: u8) {
        self.most = self.most.max(alpha);
        self.least = self.least.min(alpha);
    }
}

/// Says what a decoder's error means for the file.
fn damage_clause(error: DecodingError) -> String {
    let cause = match error {
        DecodingError::IoError(error)
            if error.kind() == ErrorKind::UnexpectedEof =>
        {
            "it ends too early, as where it was not copied whole"
        }
        DecodingError::LimitsExceeded => {
            "it asks for more memory than a picture needs"
        }
        error if error.to_string().contains("CRC") => {
            "a checksum is wrong, so some of its bytes are not those that were written"
        }
        _ => "what is in it can't be unpacked",
    };
    format!("is a damaged PNG file: {cause}")
}

/// Sentences about what a viewer may show otherwise, and what was left out.
fn viewer_notes(
    file: &[u8],
    info: &Info,
    (colour, depth): (ColorType, BitDepth),
) -> Vec<String> {
    let mut notes = vec![];
    let mut note = |is_so: bool, text: &str| {
        if is_so {
            notes.push(text.to_owned());
        }
    };
    note(
        colour.samples() < 3,
        "The file is grey: it has one number a pixel, and ours has three.",
    );
    note(
        depth == BitDepth::Sixteen,
        "The file has 16 bits a channel; they were rounded to 8.",
    );
    let gamma = info.gama_chunk.map(|gamma| gamma.into_scaled());
    note(
        gamma.is_some_and(|gamma| gamma.abs_diff(45455) > 500),
        "Its gAMA chunk asks a viewer for other colours; it was left out.",
    );
    let is_srgb = |code: png::CodingIndependentCodePoints| {
        (code.color_primaries, code.transfer_function) == (1, 13)
    };
    note(
        info.coding_independent_code_points.is_some_and(|code| !is_srgb(code)),
        "Its cICP chunk asks a viewer for other colours; it was left out.",
    );
    note(
        has_chunk(file, b"iCCP"),
        "It has a colour profile, with which a viewer may show other colours; it was left \
         out.",
    );
    let exif = info.exif_metadata.as_deref();
    note(
        exif.is_some_and(|exif| !matches!(exif_orientation(exif), None | Some(1))),
        "Its EXIF data asks a viewer to turn it; that was left out.",
    );
    note(
        info.animation_control.is_some(),
        "It is an animation: only its first picture was looked at.",
    );
    notes
}

/// Whether there is a chunk of this name in a PNG file.
fn has_chunk(file: &[u8], name: &[u8; 4]) -> bool {
    let mut chunks = file.get(8..).unwrap_or_default();
    while let [a, b, c, d, chunk_name_on @ ..] = chunks {
        if chunk_name_on.starts_with(name) {
            return true;
        }
        let end = u32::from_be_bytes([*a, *b, *c, *d]) as usize;
        chunks = chunks.get(end.saturating_add(12)..).unwrap_or_default();
    }
    false
}

/// The orientation in EXIF data, from 1, which is upright, to 8.
fn exif_orientation(exif: &[u8]) -> Option<u16> {
    let is_little = exif.starts_with(b"II");
    let short = |offset: usize| {
        let bytes = *exif.get(offset..)?.first_chunk()?;
        Some(if is_little {
            u16::from_le_bytes(bytes)
        } else {
            u16::from_be_bytes(bytes)
        })
    };
    let [high, low] = if is_little { [6, 4] } else { [4, 6] };
    let start = usize::from(short(high)?) << 16 | usize::from(short(low)?);
    let entries = (0..usize::from(short(start)?)).map(|k| start + 2 + 12 * k);
    let mut entries = entries.take_while(|offset| *offset < exif.len());
    short(entries.find(|offset| short(*offset) == Some(0x0112))? + 8)
}
