//! The module that looks at a reader's picture says what `check` says.

use super::MEND;
use super::module::{Code, checked_in};
use ::check::{camera, names};
use image::{ImageFormat, RgbImage};
use live::Answer;
use std::io::Cursor;
use std::thread;
use tests::{locked, some};
use wasm::{NAMES, answer, draw};

/// The bytes of a PNG file.
fn png(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(vec![]);
    picture.write_to(&mut bytes, ImageFormat::Png).expect("it can be encoded");
    bytes.into_inner()
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
        let pixels = locked(request.strip_prefix("draw ")?).into_raw();
        Some(Answer { pixels, ..Answer::default() })
    };
    let anew = || told(check, draw, request, file).expect("it never fails");
    thread::scope(|scope| scope.spawn(anew).join()).expect("no panic")
}

#[test]
fn the_module_says_what_check_says() {
    let right = png(&locked("gradient"));
    let small = png(&step03_nearest::picture(&camera(16, 9), 1));
    let cut = &right[..1000];
    let code = Code::new(&checked_in("check"));
    let mut pictures = Code::new(&checked_in("pictures")).start();
    let cases = [
        ("check step03_nearest a.png", &small[..], "16×9"),
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
}

#[test]
fn one_exercise_and_the_steps_are_drawn() {
    let (said, drawn) = ours("check depth a.png", &png(&locked("step03_nearest")));
    let says = "this is the picture of step03_nearest, not of depth";
    assert!(said.text.contains(says), "{}", said.text);
    assert_eq!(drawn.len(), 6, "{drawn:?}");
}

#[test]
fn what_it_compares_with_is_locked() {
    let mut known = NAMES.to_vec();
    known.sort();
    let mut locked = names();
    locked.sort();
    assert_eq!(known, locked);
    for name in some(NAMES, 5) {
        assert!(draw(name).pixels == *tests::locked(name), "{name}");
    }
}
