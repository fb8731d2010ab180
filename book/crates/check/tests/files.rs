//! Locks answers about three kinds of files: files in other formats, damaged files, and PNG files
//! with features that the course's programs don't use.

use crate::{TitledAnswer, assert_locked, encode, format_answer, locked_picture};
use check::check_png;
use course::read_locked_picture;
use course::{Step, camera_with_size};
use image::{DynamicImage, RgbImage};
use std::slice;

/// Returns a copy of a PNG file with a header that claims this size, whatever size the picture
/// really has.
fn with_size_in_header(png: &[u8], columns: u32, rows: u32) -> Vec<u8> {
    let size = [columns, rows].map(u32::to_be_bytes).concat();
    let header = [&png[12..16], &size, &png[24..29]].concat();
    let sum = crc32fast::hash(&header).to_be_bytes();
    [&png[..12], &header, &sum, &png[33..]].concat()
}

/// Returns a PNG file with 640×360 black pixels. The file has a palette and 4 bits per pixel.
fn png_with_palette() -> Vec<u8> {
    let mut file = vec![];
    let mut encoder = png::Encoder::new(&mut file, 640, 360);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Four);
    encoder.set_palette(vec![0; 3]);
    let mut writer = encoder.write_header().expect("the header can be written");
    writer.write_image_data(&[0; 320 * 360]).expect("the pixels can be written");
    drop(writer);
    file
}

/// Returns a chunk of a PNG file.
fn png_chunk(kind: &[u8; 4], contents: &[u8]) -> Vec<u8> {
    let kind_and_contents = [kind, contents].concat();
    let length = (contents.len() as u32).to_be_bytes();
    let sum = crc32fast::hash(&kind_and_contents).to_be_bytes();
    [&length[..], &kind_and_contents, &sum].concat()
}

/// Checks a file that should be step 2's picture. Returns the title, and the answer.
fn titled_answer(title: &str, file: &[u8]) -> TitledAnswer {
    let answer = check_png(file, "my.png", Some("step02_sphere"), read_locked_picture);
    (title.to_owned(), format_answer(answer))
}

#[test]
fn other_formats_and_damaged_files_are_as_locked() {
    let png = encode(locked_picture("step02_sphere"));
    let text_mode: Vec<u8> = png.iter().copied().filter(|byte| *byte != b'\r').collect();
    let as_text = String::from_utf8_lossy(&png).into_owned().into_bytes();
    let mut wrong_sum = png.clone();
    wrong_sum[100] ^= 1;
    let bmp = |header_length: u8| {
        let sizes = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, header_length, 0, 0, 0];
        [b"BM", &sizes[..]].concat()
    };
    let utf_16: Vec<u8> =
        [0xff, 0xfe].into_iter().chain(png.iter().flat_map(|b| [*b, 0])).collect();
    let deep = encode(DynamicImage::from(locked_picture("step02_sphere")).to_rgb16());
    let files: [(&str, &[u8]); 37] = [
        ("JPEG", b"\xff\xd8\xff\xe0\0\x10JFIF\0\x01"),
        ("WebP", b"RIFF\x24\0\0\0WEBPVP8 "),
        ("GIF", b"GIF89a"),
        ("BMP, version 3", &bmp(40)),
        ("BMP, version 5", &bmp(124)),
        ("PPM", b"P6\n2 2\n255\n"),
        ("PPM with a blank", b"P6 2 2 255 "),
        ("PPM with CR LF", b"P6\r\n2 2\r\n"),
        ("PPM as text", b"P3\n# a comment\n2 2\n255\n"),
        ("PGM", b"P5\n2 2\n255\n"),
        ("PAM", b"P7\nWIDTH 2\n"),
        ("P8", b"P8\n2 2\n"),
        ("a word that begins with P3", b"P30 is no picture"),
        ("HDR", b"#?RADIANCE\n"),
        ("EXR", b"\x76\x2f\x31\x01\x02\0\0\0"),
        ("QOI", b"qoif\0\0\0\x02"),
        ("UTF-16", &utf_16),
        ("base64", b"iVBORw0KGgoAAAANSUhEUgAA"),
        ("address with base64", b"data:image/png;base64,iVBORw0KGgo"),
        ("behind a mark", &[&b"\xef\xbb\xbf"[..], &png].concat()),
        ("HEIC", b"\0\0\0\x18ftypheic"),
        ("PDF", b"%PDF-1.7"),
        ("ZIP", b"PK\x03\x04"),
        ("web page", b"\n <!DOCTYPE HTML>"),
        ("pointer", b"version https://git-lfs.github.com/spec/v1"),
        ("SVG", b"<svg/>"),
        ("text", b"BM is short for bitmap"),
        ("nothing", b""),
        ("line ends changed", &text_mode),
        ("read as text", &as_text),
        ("half", &png[..png.len() / 2]),
        ("one byte changed", &wrong_sum),
        ("200000 columns", &with_size_in_header(&png, 200_000, 200_000)),
        ("a row more than the limit", &with_size_in_header(&png, 8192, 4609)),
        ("the most pixels, with 16 bits", &with_size_in_header(&deep, 8192, 4608)),
        ("no columns", &with_size_in_header(&png, 0, 0)),
        ("more bytes behind it", &[&png[..], b"more"].concat()),
    ];
    let answers = files.map(|(title, file)| titled_answer(title, file));
    assert_locked("other_formats_and_damaged_files", answers);
}

#[test]
fn other_kinds_of_png_are_as_locked() {
    let ours = DynamicImage::from(locked_picture("step02_sphere"));
    let mut invisible_pixel = ours.to_rgba8();
    invisible_pixel[(9, 9)][3] = 0;
    let still = encode(ours.clone());
    let with_chunks = |chunks: &[Vec<u8>]| [&still[..33], &chunks.concat(), &still[33..]].concat();
    let animation = png_chunk(b"acTL", &[0, 0, 0, 2, 0, 0, 0, 0]);
    // The chunk of a frame begins with a sequence number of 0, a size of 640×360 and an offset of
    // (0, 0). The delay and the drawing mode follow.
    let frame = [0, 640, 360, 0, 0].map(u32::to_be_bytes).concat();
    let first_frame = png_chunk(b"fcTL", &[&frame[..], &[0, 1, 0, 10, 0, 0]].concat());
    let one_grey = DynamicImage::new_luma16(1, 1);
    let answers = [
        ("animated, without the still image", with_chunks(slice::from_ref(&animation))),
        ("animated, from the still image on", with_chunks(&[animation, first_frame])),
        ("grey", encode(ours.to_luma8())),
        ("16 bits", encode(ours.to_rgb16())),
        ("palette", png_with_palette()),
        ("one pixel is invisible", encode(invisible_pixel)),
        ("invisible and wrong", encode(DynamicImage::new_rgba8(640, 360))),
        ("1×1, grey and 16 bits", encode(one_grey)),
        ("8192 columns", encode((Step::Sphere.draw_function())(&camera_with_size(8192, 32), 1))),
        ("1 column", encode(RgbImage::new(1, 1))),
    ];
    assert_locked("other_kinds_of_png", answers.map(|(title, file)| titled_answer(title, &file)));
}
