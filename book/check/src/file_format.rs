const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// First bytes of files that are no PNG files, and what such a file is.
const STARTS: [(&[u8], &str); 24] = [
    (b"\xFF\xD8", "a JPEG, which has lost details; save it as PNG"),
    (b"GIF8", "a GIF, which has few colours; save it as PNG"),
    (b"BM", "a BMP picture; save it as PNG"),
    (b"II*\0", "a TIFF picture; save it as PNG"),
    (b"MM\0*", "a TIFF picture; save it as PNG"),
    (b"\0\0\x01\0", "an icon; save the picture as PNG"),
    (b"qoif", "a QOI picture; save it as PNG"),
    (b"farbfeld", "a farbfeld picture; save it as PNG"),
    (b"\x76\x2f\x31\x01", "an OpenEXR picture; save it as PNG"),
    (b"#?RADIANCE", "an HDR picture; save it as PNG"),
    (b"8BPS", "a Photoshop file; save the picture as PNG"),
    (b"gimp xcf", "a file of GIMP; export the picture as PNG"),
    (b"%PDF", "a PDF; save the picture as PNG"),
    (b"PK\x03\x04", "a ZIP archive; unpack it first"),
    (b"\x1f\x8b", "packed by gzip; unpack it first"),
    (b"\x8aMNG", "an MNG animation; save a picture as PNG"),
    (
        b"version https://git-lfs",
        "a pointer of Git LFS, not the picture itself: `git lfs pull` brings it",
    ),
    (
        b"\x89PNG\n\x1a\n",
        "a PNG file whose line ends were changed, as by a copy in text \
                          mode: copy it as binary",
    ),
    (
        b"\x89PNG\r\n\x1a\r\n",
        "a PNG file whose line ends were changed, as by a copy in \
                              text mode: copy it as binary",
    ),
    (
        b"\x89PNG\r\r\n",
        "a PNG file whose line ends were changed, as by a copy in text \
                        mode: copy it as binary",
    ),
    (
        b"\xEF\xBF\xBDPNG",
        "a PNG file that was read as text and written again; copy it as \
                          binary",
    ),
    (
        b"\xC2\x89PNG",
        "a PNG file that was read as text and written again; copy it as binary",
    ),
    (b"PNG\r\n\x1a\n", "a PNG file without its first byte"),
    (
        b"\tPNG\r\n\x1a\n",
        "a PNG file that lost the highest bit of its bytes, as in a mail",
    ),
];

/// Half a sentence, such as `a JPEG; save it as PNG`: the format of a file by its first
/// bytes; None for a PNG file that can be read.
pub(crate) fn other_format_clause(file: &[u8]) -> Option<&'static str> {
    if file.starts_with(PNG) {
        let is_apples = file.get(12..16) == Some(b"CgBI");
        return is_apples.then_some(
            "a PNG file as Apple packs it into an app (CgBI), which no other program \
             reads; save it as PNG",
        );
    }
    if file.is_empty() {
        return Some("not a PNG file: it is empty");
    }
    if let Some((_, what)) =
        STARTS.iter().find(|(start, _)| file.starts_with(start))
    {
        return Some(what);
    }
    match file {
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => {
            Some("a WebP picture; save it as PNG")
        }
        [_, _, _, _, b'f', b't', b'y', b'p', ..] => Some(
            "a picture or a film in a format of phones, such as HEIC or AVIF; save it \
                  as PNG",
        ),
        [b'P', b'1'..=b'7', b' ' | b'\t' | b'\r' | b'\n', ..] => {
            Some("a PPM picture (or PGM, PBM, PAM); save it as PNG")
        }
        [0, 0 | 1, 2 | 3 | 10 | 11, ..] => {
            Some("a TGA picture, it seems; save it as PNG")
        }
        _ => Some(text_or_unknown_clause(file)),
    }
}

/// Half a sentence on a file whose first bytes tell no format: text of a kind, or unknown.
fn text_or_unknown_clause(file: &[u8]) -> &'static str {
    let start = &file[..file.len().min(512)];
    let start = String::from_utf8_lossy(start).to_ascii_lowercase();
    let start = start.trim_start_matches('\u{feff}').trim_start();
    let is_like =
        |start_of: &[&str]| start_of.iter().any(|word| start.starts_with(word));
    if is_like(&["<!doctype html", "<html", "<head", "<body"]) {
        "a web page, not the picture on it; save the picture itself"
    } else if start.contains("<svg") {
        "an SVG drawing; save it as PNG"
    } else if is_like(&["data:image/", "ivborw0kggo"]) {
        "a PNG file written in letters (base64); decode it first"
    } else if file.iter().all(|byte| *byte == 0) {
        "not a PNG file: all of its bytes are 0"
    } else if start.chars().all(|c| !c.is_control() || c.is_whitespace())
        && !start.contains('\u{fffd}')
    {
        "not a PNG file, but text"
    } else {
        "not a PNG file"
    }
}
