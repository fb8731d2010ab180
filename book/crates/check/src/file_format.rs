use image::ImageFormat;

/// First bytes of files that are no PNG files, and what such a file is.
const STARTS: [(&[u8], &str); 10] = [
    (b"%PDF", "a PDF; save the picture as PNG"),
    (b"PK\x03\x04", "a ZIP archive; unpack it first"),
    (b"\x1f\x8b", "packed by gzip; unpack it first"),
    (b"version https://git-lfs", "a pointer of Git LFS: `git lfs pull` brings the picture"),
    (b"\x89PNG\n\x1a\n", LINE_ENDS),
    (b"\x89PNG\r\n\x1a\r\n", LINE_ENDS),
    (b"\x89PNG\r\r\n", LINE_ENDS),
    (b"\xEF\xBF\xBDPNG", READ_AS_TEXT),
    (b"\xC2\x89PNG", READ_AS_TEXT),
    (b"iVBORw0KGgo", "a PNG file written in letters (base64); decode it first"),
];

const LINE_ENDS: &str = "a PNG file whose line ends were changed, as by a copy in text mode: copy \
                         it as binary";
const READ_AS_TEXT: &str = "a PNG file that was read as text and written again; copy it as binary";

/// Half a sentence, such as `a PDF; save the picture as PNG`: the format of a file by its
/// first bytes; None for a PNG file.
pub(crate) fn other_format_clause(file: &[u8]) -> Option<String> {
    let text = String::from_utf8_lossy(&file[..file.len().min(512)]);
    let text = text.trim_start_matches('\u{feff}').trim_start().to_lowercase();
    let is_text = text.chars().all(|c| c != '\u{fffd}' && (!c.is_control() || c.is_whitespace()));
    let is_page = ["<!doctype html", "<html"].iter().any(|one| text.starts_with(one));
    let format = image::guess_format(file).ok().filter(|format| {
        // Other words than those of a PNM picture may begin with P and a digit.
        *format != ImageFormat::Pnm || file.get(2).is_some_and(u8::is_ascii_whitespace)
    });
    let known = STARTS.iter().find(|(start, _)| file.starts_with(start));
    let clause = match format {
        Some(ImageFormat::Png) => return None,
        Some(ImageFormat::Jpeg) => "a JPEG, which has lost details; draw it again as PNG",
        Some(format) => {
            return Some(format!("a picture in another format, {format:?}; save it as PNG"));
        }
        None if known.is_some() => known?.1,
        None if file.get(4..8) == Some(b"ftyp") => {
            "a picture or a film in a format of phones, such as HEIC; save it as PNG"
        }
        None if file.is_empty() => "not a PNG file: it is empty",
        None if is_page => "a web page, not the picture on it; save the picture itself",
        None if text.contains("<svg") => "an SVG drawing; save it as PNG",
        None if is_text => "not a PNG file, but text",
        None => "not a PNG file",
    };
    Some(clause.to_owned())
}
