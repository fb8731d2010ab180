use image::ImageFormat;

/// First bytes of files that are no PNG files, and what such a file is.
const STARTS: [(&[u8], &str); 10] = [
    (b"%PDF", "a PDF; save the picture as PNG"),
    (b"PK\x03\x04", "a ZIP archive; unpack it first"),
    (b"\x1f\x8b", "packed by gzip; unpack it first"),
    (
        b"version https://git-lfs",
        "a pointer of Git LFS: `git lfs pull` brings the picture",
    ),
    (b"\x89PNG\n\x1a\n", LINE_ENDS),
    (b"\x89PNG\r\n\x1a\r\n", LINE_ENDS),
    (b"\x89PNG\r\r\n", LINE_ENDS),
    (b"\xEF\xBF\xBDPNG", READ_AS_TEXT),
    (b"\xC2\x89PNG", READ_AS_TEXT),
    (b"iVBORw0KGgo", "a PNG file written in letters (base64); decode it first"),
];

const LINE_ENDS: &str = "a PNG file whose line ends were changed, as by a copy in text mode: copy \
                         it as binary";
const READ_AS_TEXT: &str =
    "a PNG file that was read as text and written again; copy it as binary";

/// Half a sentence, such as `a GIF picture; save it as PNG`: the format of a file by its first
/// bytes; None for a PNG file.
pub(crate) fn other_format_clause(file: &[u8]) -> Option<String> {
    let start = &file[..file.len().min(512)];
    let text = String::from_utf8_lossy(start).to_ascii_lowercase();
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let known = STARTS.iter().find(|(start, _)| file.starts_with(start));
    let clause = match (image::guess_format(file), known) {
        (Ok(ImageFormat::Png), _) => return None,
        (Ok(ImageFormat::Jpeg), _) => {
            "a JPEG, which has lost details; draw it again as PNG".to_owned()
        }
        (Ok(format), _) => {
            let name = format.extensions_str()[0].to_ascii_uppercase();
            return Some(format!("a {name} picture; save it as PNG"));
        }
        (_, Some((_, clause))) => (*clause).to_owned(),
        _ if file.get(4..8) == Some(b"ftyp") => {
            "a HEIC picture or a film of a phone; save it as PNG".to_owned()
        }
        _ if file.is_empty() => "not a PNG file: it is empty".to_owned(),
        _ if text.starts_with("<!doctype html") || text.starts_with("<html") => {
            "a web page, not the picture on it; save the picture itself".to_owned()
        }
        _ if text.contains("<svg") => "an SVG drawing; save it as PNG".to_owned(),
        _ if text.chars().all(|c| !c.is_control() || c.is_whitespace())
            && !text.contains('\u{fffd}') =>
        {
            "not a PNG file, but text".to_owned()
        }
        _ => "not a PNG file".to_owned(),
    };
    Some(clause)
}
