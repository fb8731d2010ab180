//! Whatever the bytes of a file are, there is an answer, and soon.

use super::locked;
use ::check::{Locked, check};
use gallery::{Step, camera};
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, RgbImage};
use std::io::Cursor;
use std::time::{Duration, Instant};
use tests::{is_thorough, some};

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

/// A file with a small picture, and where each of its chunks begins.
fn file(picture: &RgbImage) -> (Vec<u8>, Vec<usize>) {
    let mut file = vec![];
    let (width, height) = picture.dimensions();
    PngEncoder::new(&mut file)
        .write_image(picture, width, height, ExtendedColorType::Rgb8)
        .expect("a picture");
    let mut chunks = vec![8];
    while let Some(size) = chunks.last().and_then(|at| file.get(*at..at + 4)) {
        let size =
            size.iter().fold(0, |size, byte| 256 * size + usize::from(*byte));
        chunks.push(chunks[chunks.len() - 1] + size + 12);
    }
    chunks.pop();
    (file, chunks)
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

/// Writes every checksum anew, so that a change is not noticed at once.
fn mend(file: &mut [u8], chunks: &[usize]) {
    for &at in chunks {
        let Some(size) = file.get(at..at + 4) else { return };
        let size =
            size.iter().fold(0, |size, byte| 256 * size + usize::from(*byte));
        let Some(data) = file.get(at + 4..(at + 8).saturating_add(size)) else {
            return;
        };
        let sum = checksum(data).to_be_bytes();
        if let Some(place) = file.get_mut(at + 8 + size..at + 12 + size) {
            place.copy_from_slice(&sum);
        }
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
fn damaged_files_give_answers() {
    let one = |step: Step| Locked {
        name: step.name().to_owned(),
        picture: step.picture(&camera(16, 9), 1),
    };
    let ours = [one(Step::Rays), one(Step::Nearest)];
    // A few are of step 3, and compared with both: that has many more causes, and takes long.
    let files = [(file(&ours[0].picture), 1), (file(&ours[1].picture), 2)];
    let mut random = Random(0x5EED);
    let mut codes = [0; 3];
    let start = Instant::now();
    let count = if is_thorough() { 2000 } else { 500 };
    for k in 0..count {
        // So that some of either are mended.
        let ((whole, chunks), count) = &files[usize::from(k / 8 % 40 == 0)];
        let mut file = whole.clone();
        mutate(&mut file, &mut random);
        // Few, as those that are read are measured, and that takes longer.
        if k % 8 == 0 {
            mend(&mut file, chunks);
        }
        let answer = check(Cursor::new(file), "my.png", None, &ours[..*count]);
        assert!(!answer.text.is_empty());
        codes[usize::from(answer.code)] += 1;
    }
    // Some are read nevertheless, and some of these are wrong pictures.
    assert!(codes.iter().all(|&count| 10 < count), "{codes:?}");
    assert!(start.elapsed() < Duration::from_secs(300), "{:?}", start.elapsed());
}

#[test]
fn no_size_is_too_small_or_too_odd() {
    let sizes = [(1, 1), (1, 9), (2, 1), (3, 2), (9, 1), (16384, 1), (17, 700)];
    for (width, height) in some(sizes, 2) {
        let picture = RgbImage::from_fn(width, height, |i, j| {
            image::Rgb([i as u8, j as u8, (i ^ j) as u8])
        });
        for name in some([Some("step05_phong"), None, Some("glass")], 3) {
            let (file, _) = file(&picture);
            let answer = check(Cursor::new(file), "my.png", name, locked());
            assert_eq!(answer.code, 1, "{}", answer.text);
        }
    }
}
