use crate::support::page_module::{self, Module};
use crate::tries_all_cases;
use check::Locked;
use course::workspace;
use course::{camera_with_size, locked_names};
use figures::{FIGURES, Figure, Parameter, Reply};
use image::{ImageFormat, RgbImage};
use page::answer;
use proptest::prelude::Strategy;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use std::fs;
use std::io::Cursor;

/// Fails if the module `name` answers otherwise than our code.
#[track_caller]
pub fn assert_same(name: &str, request: &str, ours: &Reply, theirs: Option<Reply>) {
    let is_same = theirs.as_ref() == Some(ours);
    assert!(
        is_same,
        "book/crates/page/{name}.wasm is not what our code says (of {request:?}): \
         `cargo xtask` compiles it anew."
    );
}

#[test]
fn live_wasm_is_up_to_date() {
    let mut module = Module::start_checked_in("live");
    // The same numbers each time: a platform's own tangent may differ from that of the
    // module in the last place.
    let mut runner = TestRunner::deterministic();
    for live in FIGURES.iter() {
        let mut all = vec![
            format!("about {}", live.name),
            format!("show {}{}", live.name, join_words(&default_values_as_printed(live))),
            format!("tell {}{}", live.name, join_words(&default_values_as_printed(live))),
        ];
        for _ in 0..if tries_all_cases() { 2 } else { 1 } {
            let tree = random_live_requests(live).new_tree(&mut runner).expect("requests");
            all.extend(tree.current());
        }
        for request in all {
            let theirs = module.answer(&request, b"");
            assert_same("live", &request, &figures::reply(&request), theirs);
        }
    }
}

#[test]
fn check_wasm_draws_the_pictures() {
    let mut module = Module::start_checked_in("check");
    // Small ones, as a module is slow where no browser compiles it, and a thousand spheres
    // are slowest.
    for name in locked_names() {
        let columns = if name == "crowd" && !tries_all_cases() { 8 } else { 32 };
        let request = format!("draw {name} {columns}");
        let ours = answer(&request, b"");
        assert_same("check", &request, &ours, module.answer(&request, b""));
    }
    let ours = answer("draw step05_phong", b"");
    assert!(ours.pixels == *read_locked_picture("step05_phong"), "it is not the locked picture");
}

#[test]
fn check_wasm_is_up_to_date() {
    let mut module = Module::start_checked_in("check");
    // As book/theme/live.js does, keep the pictures that it asks for.
    let steps = locked_names().into_iter().filter(|name| name.starts_with("step"));
    for name in steps.chain(["gradient"]) {
        let (request, pixels) = (format!("drawn {name}"), read_locked_picture(name).into_raw());
        answer(&request, &pixels);
        module.answer(&request, &pixels);
    }
    // The modules contain these files, byte by byte.
    let lists = fs::read_dir(workspace().join("book/crates/course/mistakes")).expect("lists");
    let lists = lists.map(|file| file.expect("a list").path());
    let lists: Vec<_> =
        lists.filter(|path| path.extension().is_some_and(|end| end == "txt")).collect();
    let source_files = ["book/crates/check/sections_and_tests.txt", "book/exercises/lib.rs"];
    let source_files: Vec<_> = source_files.iter().map(|path| workspace().join(path)).collect();
    for (name, paths) in [("check", &lists), ("expressions", &lists), ("check", &source_files)] {
        let bytes = page_module::read_module(name);
        for path in paths {
            let text = fs::read(path).expect("a list");
            assert!(
                bytes.windows(text.len()).any(|part| part == text),
                "book/crates/page/{name}.wasm has another {}: `cargo xtask` compiles it \
                 anew.",
                path.display()
            );
        }
    }
    let right = encode_png(&read_locked_picture("gradient"));
    let small = encode_png(&step03_nearest::picture(&camera_with_size(16, 9), 1));
    let mut requests_with_words = vec![
        ("check step03_nearest a.png", &small[..], "16×9"),
        ("check step01_rays a.png", &right[..1000], "a damaged PNG file"),
        ("check step01_rays notes 1.txt", b"my notes", "notes 1.txt is not a PNG"),
    ];
    if tries_all_cases() {
        // A whole picture takes seconds here.
        requests_with_words.push(("check gradient a.png", &right, "Right: this is the picture"));
    }
    for (request, file, says) in requests_with_words {
        let ours = answer(request, file);
        assert!(ours.text.contains(says), "{request}: {}", ours.text);
        assert_same("check", request, &ours, module.answer(request, file));
    }
}

#[test]
fn no_path_of_a_machine_stands_in_a_module() {
    for name in ["check", "expressions", "live"] {
        let bytes = page_module::read_module(name);
        let text = String::from_utf8_lossy(&bytes);
        for path in [".cargo", "registry/src", "/home/", "/Users/"] {
            assert!(!text.contains(path), "{path} stands in {name}.wasm");
        }
    }
}

fn read_locked_picture(name: &str) -> RgbImage {
    Locked::read(name).expect("a locked picture").picture
}

fn encode_png(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(vec![]);
    picture.write_to(&mut bytes, ImageFormat::Png).expect("it can be encoded");
    bytes.into_inner()
}

fn join_words(values: &[f64]) -> String {
    values.iter().map(|value| format!(" {value}")).collect()
}

/// The values of the printed book, but for the size of a picture, which is small.
fn default_values_as_printed(live: &Figure) -> Vec<f64> {
    let value = |parameter: &Parameter| {
        if parameter.words == "columns" { 64.0 } else { parameter.default }
    };
    live.parameters.iter().map(value).collect()
}

/// Shows something, drags a handle of it and steps one, anywhere in and around what is
/// allowed.
fn random_live_requests(live: &'static Figure) -> impl Strategy<Value = Vec<String>> {
    let ranges = live.parameters.iter().map(|parameter| {
        let [min, max] = parameter.range;
        let max = if parameter.words == "columns" { 16.0 } else { max };
        min - 1.0..max + 1.0
    });
    let place = (-50.0..700.0, -50.0..400.0, -3_i32..=3, -3_i32..=3);
    let values = ranges.collect::<Vec<_>>();
    (values, place).prop_map(|(values, (x, y, dx, dy))| {
        let (name, values) = (live.name, join_words(&values));
        let mut requests = vec![format!("show {name}{values}")];
        // Many handles are alike.
        for handle in (0..live.handles.len()).step_by(1 + live.handles.len() / 5) {
            requests.push(format!("drag {name} {handle} {x} {y}{values}"));
            requests.push(format!("step {name} {handle} {dx} {dy}{values}"));
        }
        requests
    })
}
