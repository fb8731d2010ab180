//! Whatever the bytes of a file are, there is an answer, and soon.

use check::{Answer, Locked, Step, camera, check};
use image::codecs::png::PngEncoder;
use image::{DynamicImage, ExtendedColorType, ImageEncoder, ImageFormat, Rgba};
use std::io::Cursor;

/// Numbers without any pattern, the same in each run.
struct Random(u64);

impl Random {
    /// A number below `end`.
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end as u64) as usize
    }
}

/// Changes a few bytes, or leaves some out, or doubles them.
fn mutate(file: &mut Vec<u8>, random: &mut Random) {
    for _ in 0..=random.below(3) {
        let (at, end) = (random.below(file.len()), random.below(file.len() + 1));
        match random.below(6) {
            0 => file.truncate(at.max(1)),
            1 if at < end => drop(file.drain(at..end.min(at + 9))),
            2 => {
                let again = file[at..(at + 9).min(file.len())].to_vec();
                drop(file.splice(at..at, again));
            }
            _ => file[at] = random.below(256) as u8,
        }
    }
}

/// Writes the checksum of each chunk anew, so that a change is not noticed at once.
fn mend(file: &mut [u8]) {
    let mut at = 8;
    while let Some(size) = file.get(at..at + 4) {
        let size =
            size.iter().fold(0, |size, byte| 256 * size + usize::from(*byte));
        let Some(data) = file.get(at + 4..(at + 8).saturating_add(size)) else {
            return;
        };
        let sum = checksum(data).to_be_bytes();
        let Some(place) = file.get_mut(at + 8 + size..at + 12 + size) else {
            return;
        };
        place.copy_from_slice(&sum);
        at += size + 12;
    }
}

/// The checksum of a chunk, as the PNG specification has it.
fn checksum(data: &[u8]) -> u32 {
    let bit = |sum: u32| (sum >> 1) ^ if sum & 1 == 1 { 0xEDB8_8320 } else { 0 };
    let byte =
        |sum: u32, byte: &u8| (0..8).fold(sum ^ u32::from(*byte), |s, _| bit(s));
    !data.iter().fold(!0, byte)
}

#[test]
fn two_thousand_damaged_files_give_answers() {
    let picture = Step::Rays.picture(&camera(16, 9), 1);
    let mut whole = vec![];
    let encoder = PngEncoder::new(&mut whole);
    encoder
        .write_image(&picture, 16, 9, ExtendedColorType::Rgb8)
        .expect("a picture");
    let ours = [Locked { name: Step::Rays.name().to_owned(), picture }];
    let (mut random, mut codes) = (Random(0x5EED), [0; 3]);
    for k in 0..2000 {
        let mut file = whole.clone();
        mutate(&mut file, &mut random);
        if k % 2 == 0 {
            mend(&mut file);
        }
        let answer = check(Cursor::new(file), "my.png", None, &ours);
        assert!(!answer.text.is_empty());
        codes[usize::from(answer.code)] += 1;
    }
    assert!(codes.iter().all(|count| 0 < *count), "{codes:?}");
}

#[test]
fn other_kinds_of_png_are_read() {
    let ours = crate::right("step02_sphere");
    let said = |picture: DynamicImage| -> Answer {
        let mut png = Cursor::new(vec![]);
        picture.write_to(&mut png, ImageFormat::Png).expect("a picture");
        check(
            Cursor::new(png.into_inner()),
            "my.png",
            Some("step02_sphere"),
            crate::locked(),
        )
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
