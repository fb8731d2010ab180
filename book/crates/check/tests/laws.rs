//! What holds of all pictures and all bytes.

use crate::{check, encode, locked_file, map_locked};
use check::{Verdict, check_png};
use course::{Step, camera_with_size, locked_names, read_locked_picture};
use fastrand::Rng;

#[test]
fn damaged_files_give_answers_without_panic() {
    let undamaged = encode((Step::Rays.picture())(&camera_with_size(16, 9), 1));
    let mut random = Rng::with_seed(0x5EED);
    for k in 0..300 {
        let mut file = undamaged.clone();
        let offset = random.usize(..file.len() - 12);
        file[offset] ^= random.u8(1..);
        file.truncate(if k % 2 == 0 { offset + 1 } else { file.len() });
        let answer = check_png(&file, "my.png", Some("step01_rays"), read_locked_picture);
        assert_eq!(answer.verdict, Verdict::Unreadable, "{}", answer.text);
    }
}

#[test]
fn only_equal_pictures_are_right() {
    let mut random = Rng::with_seed(0x5EED);
    for name in locked_names().into_iter().step_by(11) {
        let answer = check_png(&locked_file(name), "my.png", Some(name), read_locked_picture);
        assert_eq!(answer.verdict, Verdict::Right, "{name}");
        let (place, bit) = ((random.u32(..640), random.u32(..360)), 1 << random.u8(..8));
        let change = |i, j, [r, g, b]: [u8; 3]| [r, if (i, j) == place { g ^ bit } else { g }, b];
        let answer = check(map_locked(name, change), name);
        assert_eq!(answer.verdict, Verdict::NotRight, "{name} in {place:?}");
    }
}
