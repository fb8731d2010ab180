//! Whatever the bytes of a file are, there is an answer, and soon.

use check::{Answer, Locked, check_png};
use course::{Step, camera_with_size};
use fastrand::Rng;
use image::codecs::png::PngEncoder;
use image::{DynamicImage, ExtendedColorType, ImageEncoder, ImageFormat, Rgb, RgbImage, Rgba};
use std::io::Cursor;

/// Changes a few bytes, or leaves some out, or doubles them.
fn damage_bytes(file: &mut Vec<u8>, random: &mut Rng) {
    for _ in 0..=random.usize(..3) {
        let (offset, end) = (random.usize(..file.len()), random.usize(..=file.len()));
        match random.u8(..6) {
            0 => file.truncate(offset.max(1)),
            1 if offset < end => drop(file.drain(offset..end.min(offset + 9))),
            2 => {
                let repeated = file[offset..(offset + 9).min(file.len())].to_vec();
                drop(file.splice(offset..offset, repeated));
            }
            _ => file[offset] = random.u8(..),
        }
    }
}

/// Writes the checksum of each chunk anew, so that a change is not noticed at once.
fn correct_checksums(file: &mut [u8]) {
    let mut offset = 8;
    while let Some(size) = file.get(offset..).and_then(|rest| rest.first_chunk()) {
        let end = (offset + 8).saturating_add(u32::from_be_bytes(*size) as usize);
        let Some(data) = file.get(offset + 4..end) else { return };
        let sum = crc32fast::hash(data).to_be_bytes();
        let Some(checksum_bytes) = file.get_mut(end..end + 4) else { return };
        checksum_bytes.copy_from_slice(&sum);
        offset = end + 4;
    }
}

#[test]
fn damaged_files_give_answers_without_panic() {
    let picture = (Step::Rays.picture())(&camera_with_size(16, 9), 1);
    let mut undamaged = vec![];
    let encoder = PngEncoder::new(&mut undamaged);
    encoder.write_image(&picture, 16, 9, ExtendedColorType::Rgb8).expect("a picture");
    let ours = [Locked::read("step01_rays").expect("a locked picture")];
    let (mut random, mut codes) = (Rng::with_seed(0x5EED), [0; 3]);
    for k in 0..2000 {
        let mut file = undamaged.clone();
        damage_bytes(&mut file, &mut random);
        if k % 2 == 0 {
            correct_checksums(&mut file);
        }
        let answer = check_png(&file, "my.png", None, &ours);
        assert!(!answer.text.is_empty());
        codes[usize::from(answer.code)] += 1;
    }
    assert!(codes[0] == 0 && 0 < codes[1] && 0 < codes[2], "{codes:?}");
}

#[test]
fn grey_16_bit_and_transparent_png_are_read() {
    let ours = crate::locked_picture("step02_sphere");
    let check_as_png = |picture: DynamicImage| -> Answer {
        let mut png = Cursor::new(vec![]);
        picture.write_to(&mut png, ImageFormat::Png).expect("a picture");
        check_png(png.get_ref(), "my.png", Some("step02_sphere"), crate::locked())
    };
    let undamaged = DynamicImage::from(ours);
    let mut clear = undamaged.to_rgba8();
    let Rgba([r, g, b, _]) = *clear.get_pixel(9, 9);
    clear.put_pixel(9, 9, Rgba([r, g, b, 0]));
    for (picture, code, words) in [
        (undamaged.to_luma8().into(), 1, "The file is grey"),
        (undamaged.to_rgb16().into(), 0, "16 bits a channel"),
        (undamaged.to_rgba8().into(), 0, "Right: "),
        (clear.into(), 0, "transparent"),
    ] {
        let answer = check_as_png(picture);
        assert!(answer.code == code && answer.text.contains(words), "{}", answer.text);
    }
}

#[test]
fn other_formats_are_named_by_their_first_bytes() {
    let mut png = Cursor::new(vec![]);
    let picture = DynamicImage::from(crate::locked_picture("step02_sphere"));
    picture.write_to(&mut png, ImageFormat::Png).expect("a picture");
    let png = png.into_inner();
    let text_mode: Vec<u8> = png.iter().copied().filter(|byte| *byte != b'\r').collect();
    let as_text = String::from_utf8_lossy(&png).into_owned().into_bytes();
    for (file, words) in [
        (&b"P3\n2 2\n255\n0 0 0"[..], "in another format, Pnm"),
        (b"P6 2 2 255 ", "in another format, Pnm"),
        (b"BM\x36\0\0\0", "in another format, Bmp"),
        (b"RIFF\x24\0\0\0WEBPVP8 ", "in another format, WebP"),
        (b"II*\0\x08\0\0\0", "in another format, Tiff"),
        (b"MM\0*\0\0\0\x08", "in another format, Tiff"),
        (b"\0\0\0\x1cftypavif", "in another format, Avif"),
        (b"\n <!DOCTYPE HTML>", "is a web page"),
        (b"version https://git-lfs.github.com/spec/v1", "`git lfs pull`"),
        (b"<?xml version='1.0'?><svg/>", "is an SVG drawing"),
        (b"iVBORw0KGgoAAAANSUhEUg", "base64"),
        (b"\x1f\x8b\x08", "is packed by gzip"),
        (&text_mode, "a copy in text mode"),
        (&as_text, "read as text"),
        (&png[..png.len() / 2], "ends too early"),
    ] {
        let answer = check_png(file, "my.png", None, crate::locked());
        assert_eq!(answer.code, 2, "{words}");
        assert!(answer.text.contains(words), "{words}: {}", answer.text);
    }
}

/// A PNG file with a chunk of this name and these bytes before its pixels.
fn insert_chunk(png: &[u8], name: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let mut chunk = u32::try_from(data.len()).expect("a size").to_be_bytes().to_vec();
    chunk.extend(name);
    chunk.extend(data);
    chunk.extend(crc32fast::hash(&chunk[4..]).to_be_bytes());
    [&png[..33], &chunk, &png[33..]].concat()
}

#[test]
fn chunks_that_change_colours_in_a_viewer_are_noted() {
    let ours = crate::locked_picture("step02_sphere");
    let encode = |picture: DynamicImage| {
        let mut png = Cursor::new(vec![]);
        picture.write_to(&mut png, ImageFormat::Png).expect("a picture");
        png.into_inner()
    };
    let png = encode(ours.clone().into());
    let mut clear = DynamicImage::from(ours).into_rgba8();
    clear.pixels_mut().for_each(|pixel| pixel[3] = 0);
    let exif_turned = b"MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0";
    for (file, code, words) in [
        (png.clone(), 0, ""),
        (
            insert_chunk(&png, b"iCCP", b"profile\0\0\x78\x01\x01\x01\0\xfe\xffx\0\x79\0\x79"),
            0,
            "colour profile",
        ),
        (insert_chunk(&png, b"eXIf", exif_turned), 0, "asks a viewer to turn it"),
        (insert_chunk(&png, b"acTL", &[0, 0, 0, 1, 0, 0, 0, 0]), 0, "an animation"),
        (encode(clear.into()), 1, "Not right: alpha is 0 in every pixel"),
    ] {
        let answer = check_png(&file, "my.png", Some("step02_sphere"), crate::locked());
        assert_eq!(answer.code, code, "{}", answer.text);
        let is_noted = answer.text.contains(words) && answer.text.contains("Right: ");
        assert!(is_noted, "{words}: {}", answer.text);
        let lines = answer.text.lines().count();
        assert_eq!(lines, if words.is_empty() { 1 } else { 2 }, "{}", answer.text);
    }
}

#[test]
fn small_file_of_a_large_picture_is_not_unpacked() {
    let large = RgbImage::from_pixel(8192, 8192, Rgb([77; 3]));
    let mut png = Cursor::new(vec![]);
    large.write_to(&mut png, ImageFormat::Png).expect("a picture");
    let answer = check_png(png.get_ref(), "my.png", Some("glass"), crate::locked());
    assert_eq!(answer.code, 2, "{}", answer.text);
    assert!(answer.text.contains("up to 4096×4096"), "{}", answer.text);
}
