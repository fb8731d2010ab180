//! What holds whatever the bytes of a file are.

use crate::{LOCKED, check, encode, locked_picture, map_locked};
use check::{Verdict, check_png, find_name_in_file_name};
use course::{Step, camera_with_size, locked_names};
use fastrand::Rng;

/// Writes the checksum of each chunk again, so that a change is not noticed at once.
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
    let undamaged = encode((Step::Rays.picture())(&camera_with_size(16, 9), 1));
    let (mut random, mut counts) = (Rng::with_seed(0x5EED), [0; 2]);
    for k in 0..1000 {
        let mut file = undamaged.clone();
        let offset = random.usize(..file.len());
        file[offset] = random.u8(..);
        if k % 10 == 0 {
            file.truncate(offset + 1);
        } else if k % 2 == 0 {
            correct_checksums(&mut file);
        }
        let answer = check_png(&file, "my.png", Some("step01_rays"), &LOCKED);
        assert!(!answer.text.is_empty() && answer.verdict != Verdict::Right);
        counts[usize::from(answer.verdict == Verdict::Unreadable)] += 1;
    }
    assert!(counts.iter().all(|count| 0 < *count), "{counts:?}");
}

#[test]
fn only_equal_pictures_are_right() {
    let mut random = Rng::with_seed(0x5EED);
    for (n, name) in locked_names().into_iter().enumerate() {
        assert_eq!(check(locked_picture(name), name).verdict, Verdict::Right, "{name}");
        if 1 < n && n % 8 != 0 {
            continue;
        }
        let (k, l, bit) = (random.u32(..640), random.u32(..360), 1 << random.u8(..8));
        let wrong =
            map_locked(name, |i, j, [r, g, b]| [r, if (i, j) == (k, l) { g ^ bit } else { g }, b]);
        assert_eq!(check(wrong, name).verdict, Verdict::NotRight, "{name} in {k}, {l}");
    }
}

#[test]
fn name_of_the_file_tells_whose_picture_it_is() {
    let names = || ["step01_rays", "step02_sphere", "glass"].into_iter();
    for (file, name) in [
        ("my-step02_sphere.png", Some("step02_sphere")),
        ("step2.png", Some("step02_sphere")),
        ("STEP02 (1).png", Some("step02_sphere")),
        ("Step 2 final.png", Some("step02_sphere")),
        ("Step01Rays.png", Some("step01_rays")),
        ("step12.png", None),
        ("glass/step1.png", Some("step01_rays")),
        ("hourglass.png", None),
        ("my.png", None),
    ] {
        assert_eq!(find_name_in_file_name(file, names()), name, "{file}");
    }
}
