//! Whatever the bytes of a file are, there is an answer, and soon.

use check::{Answer, Locked, Step, camera, check};
use fastrand::Rng;
use image::codecs::png::PngEncoder;
use image::{DynamicImage, ExtendedColorType, ImageEncoder, ImageFormat, Rgba};
use std::io::Cursor;

/// Changes a few bytes, or leaves some out, or doubles them.
fn mutate(file: &mut Vec<u8>, random: &mut Rng) {
    for _ in 0..=random.usize(..3) {
        let (at, end) = (random.usize(..file.len()), random.usize(..=file.len()));
        match random.u8(..6) {
            0 => file.truncate(at.max(1)),
            1 if at < end => drop(file.drain(at..end.min(at + 9))),
            2 => {
                let again = file[at..(at + 9).min(file.len())].to_vec();
                drop(file.splice(at..at, again));
            }
            _ => file[at] = random.u8(..),
        }
    }
}

/// Writes the checksum of each chunk anew, so that a change is not noticed at once.
fn mend(file: &mut [u8]) {
    let mut at = 8;
    while let Some(size) = file.get(at..).and_then(|rest| rest.first_chunk()) {
        let end = (at + 8).saturating_add(u32::from_be_bytes(*size) as usize);
        let Some(data) = file.get(at + 4..end) else { return };
        let sum = crc32fast::hash(data).to_be_bytes();
        let Some(place) = file.get_mut(end..end + 4) else { return };
        place.copy_from_slice(&sum);
        at = end + 4;
    }
}

#[test]
fn two_thousand_damaged_files_give_answers() {
    let picture = Step::Rays.picture(&camera(16, 9), 1);
    let mut whole = vec![];
    let encoder = PngEncoder::new(&mut whole);
    encoder
        .write_image(&picture, 16, 9, ExtendedColorType::Rgb8)
        .expect("a picture");
    let ours = [Locked::read("step01_rays").expect("a locked picture")];
    let (mut random, mut codes) = (Rng::with_seed(0x5EED), [0; 3]);
    for k in 0..2000 {
        let mut file = whole.clone();
        mutate(&mut file, &mut random);
        if k % 2 == 0 {
            mend(&mut file);
        }
        let answer = check(&file, "my.png", None, &ours);
        assert!(!answer.text.is_empty());
        codes[usize::from(answer.code)] += 1;
    }
    assert!(codes[0] == 0 && 0 < codes[1] && 0 < codes[2], "{codes:?}");
}

#[test]
fn other_kinds_of_png_are_read() {
    let ours = crate::right("step02_sphere");
    let said = |picture: DynamicImage| -> Answer {
        let mut png = Cursor::new(vec![]);
        picture.write_to(&mut png, ImageFormat::Png).expect("a picture");
        check(png.get_ref(), "my.png", Some("step02_sphere"), crate::locked())
    };
    let whole = DynamicImage::from(ours);
    let mut clear = whole.to_rgba8();
    let Rgba([r, g, b, _]) = *clear.get_pixel(9, 9);
    clear.put_pixel(9, 9, Rgba([r, g, b, 0]));
    for (picture, code, words) in [
        (whole.to_luma8().into(), 1, "The file is grey"),
        (whole.to_rgb16().into(), 0, "16 bits a channel"),
        (whole.to_rgba8().into(), 0, "Right: "),
        (clear.into(), 0, "transparent"),
    ] {
        let answer = said(picture);
        assert!(
            answer.code == code && answer.text.contains(words),
            "{}",
            answer.text
        );
    }
}
