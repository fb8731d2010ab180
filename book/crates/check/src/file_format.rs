const LINE_ENDS: &str = "a PNG file whose line ends were changed, as by a copy in text mode: copy \
                         it as binary";
const READ_AS_TEXT: &str = "a PNG file that was read as text and written again; copy it as binary";

/// Bytes of files that are no PNG files, from which byte on, and what such a file is; at the end
/// the beginnings of PNG files that a copy has damaged.
const FORMATS: [(usize, &[u8], &str); 17] = [
    (0, b"\xff\xd8\xff", "a JPEG, which has lost details; draw it again as PNG"),
    (8, b"WEBP", "a WebP picture; save it as PNG"),
    (0, b"GIF8", "a GIF, which has 256 colours at most; draw it again as PNG"),
    (0, b"BM", "a BMP picture; save it as PNG"),
    (0, b"P6\n", "a PPM picture; save it as PNG"),
    (0, b"II*\0", "a TIFF picture; save it as PNG"),
    (0, b"MM\0*", "a TIFF picture; save it as PNG"),
    (4, b"ftyp", "a phone's picture or film, such as HEIC; save it as PNG"),
    (0, b"%PDF", "a PDF; save the picture as PNG"),
    (0, b"PK\x03\x04", "a ZIP archive, or a document that is one; unpack it first"),
    (0, b"\x1f\x8b", "a gzip archive; unpack it first"),
    (0, b"version https://git-lfs", "a pointer of Git LFS: `git lfs pull` fetches the picture"),
    (0, b"\x89PNG\n\x1a\n", LINE_ENDS),
    (0, b"\x89PNG\r\n\x1a\r\n", LINE_ENDS),
    (0, b"\x89PNG\r\r\n", LINE_ENDS),
    (0, b"\xEF\xBF\xBDPNG", READ_AS_TEXT),
    (0, b"\xC2\x89PNG", READ_AS_TEXT),
];

/// Half a sentence, such as `a PDF; save the picture as PNG`: the format of a file by its
/// first bytes; None for a PNG file.
pub(crate) fn other_format_clause(file: &[u8]) -> Option<&'static str> {
    if file.starts_with(b"\x89PNG\r\n\x1a\n") {
        return None;
    }
    let text = first_text(file);
    let has = |start: usize, bytes: &[u8]| file.get(start..).is_some_and(|f| f.starts_with(bytes));
    // A text may begin with the two letters of a BMP.
    let is_told = |bytes: &[u8]| bytes != b"BM" || !is_text(&text);
    let format = FORMATS.iter().find(|(start, bytes, _)| has(*start, bytes) && is_told(bytes));
    if let Some((_, _, clause)) = format {
        return Some(clause);
    }
    Some(match text.trim_matches(['\u{feff}', '\u{fffd}', ' ', '\n', '\r', '\t']) {
        _ if file.is_empty() => "not a PNG file: it is empty",
        text if text.starts_with("<!doctype html") || text.starts_with("<html") => {
            "a web page, not the picture on it; save the picture itself"
        }
        text if text.contains("<svg") => "an SVG drawing; save it as PNG",
        text if is_text(text) => "not a PNG file, but text",
        _ => "not a PNG file",
    })
}

/// The first letters of a file, in lower case, of 8 or 16 bits each.
fn first_text(file: &[u8]) -> String {
    let start = &file[..file.len().min(512)];
    let is_utf16 = start.starts_with(b"\xff\xfe") || start.starts_with(b"\xfe\xff");
    let letters = start.iter().copied().filter(|byte| !is_utf16 || *byte != 0);
    String::from_utf8_lossy(&letters.collect::<Vec<_>>()).to_lowercase()
}

/// Whether a text has no other letters than one that is written for people.
fn is_text(text: &str) -> bool {
    text.chars().all(|c| c != '\u{fffd}' && (!c.is_control() || c.is_whitespace()))
}
