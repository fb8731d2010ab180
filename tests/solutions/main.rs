//! The mathematics of the exercises' solutions; and that the book has each of them.

mod fast;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

use compare::{Difference, workspace};
use exercises::*;
use std::fs;
use tests::{camera, locked};

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
