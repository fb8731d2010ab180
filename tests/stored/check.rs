//! The module that looks at a reader's picture says what `check` says.

use super::MEND;
use super::module::{Code, checked_in};
use ::check::{Locked, locked};
use ::module::{NAMES, SUMS, answer, draw, sum};
use gallery::{Step, camera, mistakes};
use image::{ImageFormat, RgbImage};
use live::Answer;
use std::io::Cursor;
use std::thread;
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
/// book/theme/live.js asks for them, and their names; none where a module fails.
fn told(
    mut check: impl FnMut(&str, &[u8]) -> Option<Answer>,
    mut draw: impl FnMut(&str) -> Option<Answer>,
    request: &str,
    file: &[u8],
) -> Option<(Answer, Vec<String>)> {
    let mut drawn = vec![];
    loop {
        let answer = check(request, file)?;
        let names = answer.text.strip_prefix("{\"draw\":[\"");
        let Some(names) = names.and_then(|names| names.strip_suffix("\"]}")) else {
            return Some((answer, drawn));
        };
        for name in names.split("\",\"") {
            let Answer { pixels, .. } = draw(&format!("draw {name}"))?;
            check(&format!("drawn {name}"), &pixels)?;
            drawn.push(name.to_owned());
        }
    }
}

/// What our own code says; what it draws is locked, as another test sees. Each time anew:
/// what it keeps, it keeps for a thread.
fn ours(request: &str, file: &[u8]) -> (Answer, Vec<String>) {
    let check = |request: &str, file: &[u8]| Some(answer(request, file));
    let draw = |request: &str| {
        let picture = locked(request.strip_prefix("draw ")?).ok()?;
        Some(Answer { pixels: picture.into_raw(), ..Answer::default() })
    };
    let anew = || told(check, draw, request, file).expect("it never fails");
    thread::scope(|scope| scope.spawn(anew).join()).expect("no panic")
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
        assert!(ours.0.text.contains(says), "{request}: {}", ours.0.text);
        // Each time anew, as after a module that failed.
        let mut check = code.start();
        let check = |request: &str, file: &[u8]| check.answer(request, file);
        let draw = |request: &str| pictures.answer(request, b"");
        let theirs = told(check, draw, request, file);
        let text = theirs.as_ref().map(|(answer, _)| &answer.text);
        assert!(theirs.as_ref() == Some(&ours), "{request}: {text:?}\n{MEND}");
    }
    // Of all pictures it asks for the one that this may be.
    let mut check = code.start();
    let rays = locked("step01_rays").expect("it can be read");
    check.answer("drawn step01_rays", &rays);
    let asks = check.answer("check step01_rays a.png", &right);
    let asks = asks.map(|answer| answer.text);
    assert_eq!(asks.as_deref(), Some(r#"{"draw":["gradient"]}"#), "{MEND}");
}

#[test]
fn a_picture_of_another_name_is_told_and_no_more_are_drawn() {
    let mut picture = locked("many").expect("it can be read");
    let (said, drawn) = ours("check depth a.png", &png(&picture));
    let says = "this is the picture of many, not of depth";
    assert!(said.text.contains(says), "{}", said.text);
    assert_eq!(drawn, ["depth", "many"]);

    picture.put_pixel(7, 0, [1, 2, 3].into());
    let (said, drawn) = ours("check depth a.png", &png(&picture));
    let says = "this is not the picture of depth";
    assert!(said.text.contains(says), "{}", said.text);
    assert_eq!(drawn, ["depth"]);
}

#[test]
fn what_it_compares_with_is_locked() {
    let locked = Locked::all().expect("the pictures can be read");
    assert_eq!(NAMES, locked.iter().map(|one| &one.name).collect::<Vec<_>>());
    for (Locked { name, picture }, told) in locked.iter().zip(SUMS) {
        let its = sum(picture.as_raw());
        assert_eq!(its, *told, "pictures.rs has to tell {its} of {name}");
    }
    for Locked { name, picture } in some(locked, 5) {
        assert!(draw(&name).pixels == *picture, "{name}");
    }
}
