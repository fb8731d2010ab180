//! The mathematics of the exercises' solutions, and their places in the book.

mod fast;
#[allow(dead_code, reason = "it is a program of its own, too")]
#[rustfmt::skip]
#[path = "../../steps/step05_phong/examples/fast.rs"]
mod fast_example;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

use course::examples::*;
use course::{Difference, Picture, workspace};
use glam::DMat3;
use std::fs;
use step01_rays::Camera;
use tests::{camera, locked_pictures, read_snapshot};

/// The names of the files and folders in `folder` of the workspace, but for hidden ones.
fn file_names(folder: &str) -> impl Iterator<Item = String> {
    let files = fs::read_dir(workspace().join(folder)).expect(folder).flatten();
    let names = files.map(|file| file.file_name().to_string_lossy().into_owned());
    names.filter(|name| !name.starts_with('.'))
}

#[test]
fn starters_and_fast_draw_the_pictures_of_their_steps() {
    let pictures: [(_, Picture); 6] = [
        ("step01_rays", step01_starter::picture),
        ("step02_sphere", step02_starter::picture),
        ("step03_nearest", step03_starter::picture),
        ("step04_diffuse", step04_starter::picture),
        ("step05_phong", step05_starter::picture),
        ("step05_phong", fast_example::picture),
    ];
    for (name, draw) in pictures {
        let difference = Difference::between(&read_snapshot(name), &draw(&camera(), 1));
        assert!(difference.is_none(), "{name}: {}", difference.unwrap());
    }
}

/// Replaces each number in the matrix of the camera by `neighbour`, the next or the
/// previous f64; integers stay, as every way to write the formulas gives these exactly.
fn perturb_camera(camera: &Camera, neighbour: fn(f64) -> f64) -> Camera {
    let perturb = |x: f64| if x.fract() == 0.0 { x } else { neighbour(x) };
    let matrix = camera.matrix.to_cols_array().map(perturb);
    Camera { matrix: DMat3::from_cols_array(&matrix), ..*camera }
}

/// The pictures that take longest.
const SLOW_PICTURES: [&str; 5] = ["cover", "goodbye", "crowd", "close_up", "jitter"];

#[test]
fn pictures_do_not_depend_on_the_last_bit_of_the_camera() {
    assert_pictures_survive_perturbed_cameras(|name| !SLOW_PICTURES.contains(&name));
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn slow_pictures_do_not_depend_on_the_last_bit_of_the_camera() {
    assert_pictures_survive_perturbed_cameras(|name| SLOW_PICTURES.contains(&name));
}

/// Fails if the last bit of its camera changes a locked picture whose name `is_selected`.
///
/// The tangent of another platform may differ in its last bit, and so may a formula that
/// is written in another order. `speckled` is left out: it shows rounding errors, and its
/// camera takes no tangent.
#[track_caller]
fn assert_pictures_survive_perturbed_cameras(is_selected: fn(&str) -> bool) {
    let mut faults = vec![];
    for (name, camera, draw) in locked_pictures() {
        if name == "speckled" || !is_selected(name) {
            continue;
        }
        let picture = draw(&camera, 1);
        for neighbour in [f64::next_up, f64::next_down] {
            let perturbed_picture = draw(&perturb_camera(&camera, neighbour), 1);
            let difference = Difference::between(&picture, &perturbed_picture);
            faults.extend(difference.map(|text| format!("{name}: {text}")));
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn every_example_is_an_exercise_and_is_listed_in_the_book() {
    let read = |path: &str| fs::read_to_string(workspace().join(path)).expect(path);
    let chapter = |name: &str| read(&format!("book/src/{name}.md"));
    let pages_of_all_steps =
        ["step01_program", "way_back", "faster", "own_scene", "solutions"].map(chapter).concat();
    let mut faults = vec![];
    for step in file_names("steps") {
        let pages = chapter(&step) + &pages_of_all_steps;
        let folder = format!("steps/{step}/examples");
        for file in file_names(&folder) {
            let name = file.trim_end_matches(".rs");
            // The others draw the picture of a step or a part of it, or print.
            let is_exercise = name.ends_with("_starter")
                || ["directions", "fast", "own_scene", "row", "terms"].contains(&name)
                || course::PICTURES.iter().any(|(exercise, _)| *exercise == name);
            if !is_exercise {
                faults.push(format!("{folder}/{file} is not in book/exercises"));
            }
            let directive = format!("{folder}/{file}");
            if !pages.contains(&directive) {
                faults.push(format!("{folder}/{file} is not in the book"));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
