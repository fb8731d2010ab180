//! The module that looks at a reader's picture says what `check` says.

use super::MEND;
use super::module::{Code, checked_in};
use ::check::{Locked, locked};
use ::module::{NAMES, answer, draw};
use gallery::{Step, camera, mistakes};
use image::{ImageFormat, RgbImage};
use live::Answer;
use std::io::Cursor;
use tests::some;

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

/// What there is to say of a file once the pictures are drawn that it takes, as
/// book/theme/live.js asks for them; none where a module fails.
fn told(
    mut check: impl FnMut(&str, &[u8]) -> Option<Answer>,
    mut draw: impl FnMut(&str) -> Option<Answer>,
    request: &str,
    file: &[u8],
) -> Option<Answer> {
    loop {
        let answer = check(request, file)?;
        let names = answer.text.strip_prefix("{\"draw\":[\"");
        let Some(names) = names.and_then(|names| names.strip_suffix("\"]}")) else {
            return Some(answer);
        };
        for name in names.split("\",\"") {
            let Answer { pixels, .. } = draw(&format!("draw {name}"))?;
            check(&format!("drawn {name}"), &pixels)?;
        }
    }
}

/// What our own code says; what it draws is locked, as another test sees.
fn ours(request: &str, file: &[u8]) -> Answer {
    let check = |request: &str, file: &[u8]| Some(answer(request, file));
    let draw = |request: &str| {
        let picture = locked(request.strip_prefix("draw ")?).ok()?;
        Some(Answer { pixels: picture.into_raw(), ..Answer::default() })
    };
    told(check, draw, request, file).expect("it never fails")
}

#[test]
fn the_module_says_what_check_says() {
    let right = png(&locked("gradient").expect("it can be read"));
    let mistake = png(&wrong("bgr", Step::Rays));
    let cut = &right[..1000];
    let code = Code::new(&checked_in("check"));
    let mut pictures = Code::new(&checked_in("pictures")).start();
    let cases = [
        ("check * step01_rays.png", &mistake[..], "Not right yet"),
        ("check gradient a.png", &right, "Right: this is the picture"),
        ("check step01_rays notes 1.txt", b"my notes", "notes 1.txt is not a PNG"),
        ("check step01_rays a.png", b"", "it is empty"),
        ("check step01_rays a.png", cut, "a damaged PNG file"),
        ("check step01_rays a.jpg", b"\xFF\xD8\xFF\xE0", "a JPEG"),
    ];
    for (request, file, says) in some(cases, 2) {
        let ours = ours(request, file);
        assert!(ours.text.contains(says), "{request}: {}", ours.text);
        // Each time anew, as after a module that failed.
        let mut check = code.start();
        let check = |request: &str, file: &[u8]| check.answer(request, file);
        let draw = |request: &str| pictures.answer(request, b"");
        let theirs = told(check, draw, request, file);
        assert!(theirs.as_ref() == Some(&ours), "{request}: {theirs:?}\n{MEND}");
    }
}

#[test]
fn a_picture_of_another_name_is_told() {
    let many = png(&locked("many").expect("it can be read"));
    let told = ours("check step03_nearest a.png", &many).text;
    let says = "this is the picture of many, not of step03_nearest";
    assert!(told.contains(says), "{told}");
}

#[test]
fn what_it_compares_with_is_locked() {
    let locked = Locked::all().expect("the pictures can be read");
    assert_eq!(NAMES, locked.iter().map(|one| &one.name).collect::<Vec<_>>());
    for Locked { name, picture } in some(locked, 5) {
        assert!(draw(&name).pixels == *picture, "{name}");
    }
}
