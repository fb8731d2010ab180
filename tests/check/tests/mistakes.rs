//! Every mistake gives a picture of its own.

use super::{folder, named, opened};
use gallery::{Mistake, Parts, Step, camera, mistakes, workspace};
use image::RgbImage;
use std::collections::HashSet;
use std::fs;
use std::time::SystemTime;
use tests::is_thorough;

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
        let camera = camera(320, 180);
        let picture = mistake.picture(&camera, 1);
        let right = mistake.step.picture(&camera, 1);
        assert!(picture != right, "{} gives the right picture", mistake.name);
        for (other, theirs) in &drawn {
            assert!(*theirs != picture, "{} and {}", mistake.name, other.name);
        }
        drawn.push((mistake, picture));
    }
}

#[test]
fn a_mistake_does_not_show_before_its_step() {
    for mistake in mistakes() {
        for step in Step::ALL.into_iter().filter(|&step| step < mistake.step) {
            let picture = mistake.picture_in(step, &camera(320, 180), 1);
            let drawn = mistakes().filter(|other| other.step == step);
            let mut others = drawn.map(|other| other.picture(&camera(320, 180), 1));
            // Where it does, it is not to be told from another one.
            assert!(
                picture == step.picture(&camera(320, 180), 1)
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
        assert!(workspace().join(&file).is_file(), "{name}: no file {file}");
        assert!(!when.ends_with('.') && !when.is_empty(), "{name}");
        assert!(sees.ends_with('.') && says.ends_with('.'), "{name}");
        assert!(section.anchor().chars().all(plain), "{name}");
    }
}

#[test]
fn the_slides_own_matrix_gives_its_locked_picture() {
    let slide = named("slide-matrix");
    let picture = slide.picture_in(Step::Phong, &camera(640, 360), 1);
    assert!(picture == ::check::locked("slide_matrix").expect("a picture"));
}

#[test]
fn the_appendix_of_the_book_shows_the_gallery() {
    let path = workspace().join("book/chapters/mistakes.md");
    let chapter = fs::read_to_string(path).expect("a chapter");
    assert!(
        chapter == ::check::appendix(),
        "write it anew: cargo run --bin appendix > book/chapters/mistakes.md"
    );
    for (_, name) in mistakes().flat_map(Mistake::shown) {
        assert!(chapter.contains(&format!("(pictures/{name}.png ")), "{name}");
    }
}

#[test]
fn the_gallery_is_drawn_unless_its_pictures_are_newer_than_the_program() {
    let folder = folder("drawn");
    let draw = |built| gallery::draw(&folder, built).expect("pictures");
    let path = |name: &str| folder.join(name).with_extension("png");
    let all = mistakes().flat_map(|one| one.shown().map(move |show| (one, show)));
    let all: Vec<_> = all.collect();
    let stale = RgbImage::new(1, 1);
    for (_, (_, name)) in &all {
        stale.save(path(name)).expect("a file");
    }
    let (first, rest) = all.split_at(9);
    for (_, (_, name)) in first {
        fs::remove_file(path(name)).expect("it was saved");
    }
    assert_eq!(draw(Some(SystemTime::UNIX_EPOCH)).len(), all.len());
    for (mistake, (step, name)) in first {
        assert!(opened(&path(name)) == mistake.show(*step), "{name}");
    }
    assert!(rest.iter().all(|(_, (_, name))| opened(&path(name)) == stale));
    // Where the time is unknown, nothing is new enough.
    if is_thorough() {
        draw(None);
        for (_, (_, name)) in &all {
            assert!(opened(&path(name)) != stale, "{name}");
        }
    }
}
