//! The module that looks at a reader's picture says what `check` says.

use crate::MEND;
use crate::module::{Module, checked_in};
use check::{Locked, locked};
use gallery::{Step, camera, mistakes};
use image::{ImageFormat, RgbImage};
use std::io::Cursor;

/// The bytes of a PNG file.
fn png(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(vec![]);
    picture.write_to(&mut bytes, ImageFormat::Png).expect("it can be encoded");
    bytes.into_inner()
}

/// A small picture of a step with a mistake of the gallery in it.
fn wrong(name: &str, step: Step) -> RgbImage {
    let known = mistakes().find(|mistake| mistake.name == name);
    known.expect("it is in the gallery").picture_in(step, &camera(16, 9), 1)
}

#[test]
fn the_module_says_what_check_says() {
    let right = png(&locked("gradient").expect("it can be read"));
    let mistake = png(&wrong("bgr", Step::Rays));
    let cut = &right[..1000];
    for (request, file, says) in [
        ("check gradient a.png", &right[..], "Right: this is the picture"),
        ("check * step01_rays.png", &mistake, "Not right yet"),
        ("check step01_rays notes 1.txt", b"my notes", "notes 1.txt is not a PNG"),
        ("check step01_rays a.png", b"", "it is empty"),
        ("check step01_rays a.png", cut, "a damaged PNG file"),
        ("check step01_rays a.jpg", b"\xFF\xD8\xFF\xE0", "a JPEG"),
    ] {
        let ours = module::answer(request, file);
        assert!(ours.text.contains(says), "{request}: {}", ours.text);
        // Each time anew, as after a module that failed.
        let theirs = Module::new(&checked_in("check")).answer(request, file);
        assert!(theirs.as_ref() == Some(&ours), "{request}: {theirs:?}\n{MEND}");
    }
}

#[test]
fn what_it_compares_with_is_locked() {
    let locked = Locked::all().expect("the pictures can be read");
    let ours: Vec<_> = module::locked().iter().map(|one| &one.name).collect();
    assert_eq!(ours, locked.iter().map(|one| &one.name).collect::<Vec<_>>());
    for (ours, locked) in module::locked().iter().zip(locked) {
        assert!(*ours == locked, "{}", locked.name);
    }
}
