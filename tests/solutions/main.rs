//! The mathematics of the exercises' solutions; and that the book has each of them.

mod fast;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

use compare::{Difference, workspace};
use exercises::*;
use glam::DMat3;
use std::fs;
use step01_rays::Camera;
use tests::{camera, locked, locked_pictures};

/// The names of what is in the folder `path` of the workspace.
fn files(path: &str) -> impl Iterator<Item = String> {
    let files = fs::read_dir(workspace().join(path)).expect(path).flatten();
    let names = files.map(|file| file.file_name().to_string_lossy().into_owned());
    names.filter(|name| !name.starts_with('.'))
}

#[test]
fn what_draws_a_step_in_another_way_draws_its_picture() {
    let ways: [(_, Picture); 6] = [
        ("step01_rays", step01_starter::picture),
        ("step02_sphere", step02_starter::picture),
        ("step03_nearest", step03_starter::picture),
        ("step04_diffuse", step04_starter::picture),
        ("step05_phong", step05_starter::picture),
        ("step05_phong", exercises::fast::picture),
    ];
    for (name, picture) in ways {
        let difference = Difference::between(&locked(name), &picture(&camera(), 1));
        assert!(difference.is_none(), "{name}: {}", difference.unwrap());
    }
}

/// The camera with each number of its matrix moved to the next f64, but for the whole
/// numbers: no way to write the formulas makes others of these.
fn nudged(camera: &Camera, next: fn(f64) -> f64) -> Camera {
    let nudge = |x: f64| if x.fract() == 0.0 { x } else { next(x) };
    let matrix = camera.matrix.to_cols_array().map(nudge);
    Camera { matrix: DMat3::from_cols_array(&matrix), ..*camera }
}

/// The pictures that take longest.
const SLOW: [&str; 5] = ["cover", "goodbye", "crowd", "close_up", "jitter"];

#[test]
fn no_picture_depends_on_the_last_bit_of_its_camera() {
    assert_stable(|name| !SLOW.contains(&name));
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn no_slow_picture_depends_on_the_last_bit_of_its_camera() {
    assert_stable(|name| SLOW.contains(&name));
}

/// Fails if the last bit of a camera changes one of the locked pictures that are chosen.
///
/// The tangent of another platform may differ in its last bit, and so may a formula that
/// is written in another order. `speckled` shows how numbers are rounded: its picture is
/// the same wherever its camera is, which takes no tangent.
#[track_caller]
fn assert_stable(is_chosen: fn(&str) -> bool) {
    let mut changed = vec![];
    for (name, camera, draw) in locked_pictures() {
        if name == "speckled" || !is_chosen(name) {
            continue;
        }
        let ours = draw(&camera, 1);
        for next in [f64::next_up, f64::next_down] {
            let theirs = draw(&nudged(&camera, next), 1);
            if let Some(how) = Difference::between(&ours, &theirs) {
                changed.push(format!("{name}: {how}"));
            }
        }
    }
    assert!(changed.is_empty(), "{changed:#?}");
}

#[test]
fn no_exercise_is_forgotten() {
    let text = |path: &str| fs::read_to_string(workspace().join(path)).expect(path);
    let mut missing = vec![];
    let after = ["way_back", "faster"];
    let after =
        after.map(|page| text(&format!("book/chapters/{page}.md"))).concat();
    for step in files("steps") {
        let chapter = text(&format!("book/chapters/{step}.md")) + &after;
        let pages = text("book/chapters/solutions.md") + &chapter;
        let folder = format!("steps/{step}/examples");
        for file in files(&folder) {
            let name = file.trim_end_matches(".rs");
            // These draw a picture of the step, or part of it, or print.
            let is_drawn = name.ends_with("_starter")
                || ["directions", "fast", "row", "terms"].contains(&name)
                || exercises::PICTURES.iter().any(|(known, _)| *known == name);
            let listing = format!("{{{{#include ../../{folder}/{file}");
            for (is_there, place) in [
                (is_drawn, "book/exercises"),
                (pages.contains(&listing), "the book"),
            ] {
                if !is_there {
                    missing.push(format!("{folder}/{file} is not in {place}"));
                }
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
