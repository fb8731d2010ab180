//! Every mistake gives a picture of its own.

use gallery::{Mistake, Parts, Step, appendix, locked, mistakes};
use image::RgbImage;
use std::collections::HashSet;
use std::fs;
use std::path::Path;
use step01_rays::Camera;

fn camera(width: u32, height: u32) -> Camera {
    Camera::new(width, height, 60_f64.to_radians())
}

fn folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .and_then(Path::parent)
        .expect("a root")
}

#[test]
fn the_right_parts_draw_the_pictures_of_the_steps() {
    for (width, height, samples) in [(640, 360, 1), (95, 71, 2), (64, 36, 3)] {
        let camera = camera(width, height);
        for step in Step::ALL {
            let ours = Parts::right(&camera).picture(step, samples);
            assert!(
                ours == step.picture(&camera, samples),
                "{step:?}, {samples} samples"
            );
        }
    }
}

#[test]
fn no_mistake_gives_the_right_picture_or_that_of_another() {
    let mut drawn: Vec<(&Mistake, RgbImage)> = vec![];
    for mistake in mistakes() {
        let picture = mistake.picture(&camera(640, 360), 1);
        let right = locked(mistake.step.name()).expect("a locked picture");
        assert!(picture != right, "{} gives the right picture", mistake.name);
        for (other, theirs) in &drawn {
            assert!(*theirs != picture, "{} and {}", mistake.name, other.name);
        }
        drawn.push((mistake, picture));
    }
    assert!(30 <= drawn.len());
}

#[test]
fn a_mistake_does_not_show_before_its_step() {
    for mistake in mistakes() {
        for step in Step::ALL.into_iter().filter(|&step| step < mistake.step) {
            let picture = mistake.picture_in(step, &camera(640, 360), 1);
            let drawn = mistakes().filter(|other| other.step == step);
            let mut others = drawn.map(|other| other.picture(&camera(640, 360), 1));
            // Where it does, it is not to be told from another one.
            assert!(
                picture == step.picture(&camera(640, 360), 1)
                    || others.any(|other| other == picture),
                "{} shows in {step:?}",
                mistake.name
            );
        }
    }
}

#[test]
fn every_mistake_is_told_in_full() {
    let mut names = HashSet::new();
    for Mistake { name, when, sees, says, section, .. } in mistakes() {
        assert!(names.insert(*name), "{name} stands there twice");
        let plain =
            |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        assert!(name.chars().all(plain), "{name}");
        let file = section.path();
        assert!(folder().join(&file).is_file(), "{name}: no file {file}");
        assert!(!when.ends_with('.') && !when.is_empty(), "{name}");
        assert!(sees.ends_with('.') && says.ends_with('.'), "{name}");
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-';
        assert!(section.anchor().chars().all(plain), "{name}");
    }
}

#[test]
fn the_slides_own_matrix_gives_its_locked_picture() {
    let slide = mistakes().find(|mistake| mistake.name == "slide-matrix");
    let picture =
        slide.expect("it is there").picture_in(Step::Phong, &camera(640, 360), 1);
    let path = folder().join("tests/snapshots/slide_matrix.snap.png");
    assert!(picture == image::open(path).expect("a PNG").to_rgb8());
}

#[test]
fn the_appendix_of_the_book_shows_the_gallery() {
    let path = folder().join("book/chapters/mistakes.md");
    let chapter = fs::read_to_string(path).expect("a chapter");
    assert!(
        chapter == appendix(),
        "write it anew: cargo run -p gallery --example appendix > book/chapters/mistakes.md"
    );
    for (_, name) in mistakes().flat_map(Mistake::shown) {
        assert!(chapter.contains(&format!("(pictures/{name}.png ")), "{name}");
    }
}
