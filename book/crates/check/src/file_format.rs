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

/// Half a sentence, such as `a PDF; save the picture as PNG`: the format of a file by its
/// first bytes, behind blanks and in any case; None for a PNG file.
pub(crate) fn other_format_clause(file: &[u8]) -> Option<&'static str> {
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
