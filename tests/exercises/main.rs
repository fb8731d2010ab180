//! The exercises: each solution's picture is locked, its mathematics holds, and the
//! book has it.

#![allow(dead_code, reason = "the main of an example runs as a program only")]

mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

use glam::DVec3;
use image::RgbImage;
use std::{fs, path::Path};
use step01_rays::{Camera, Ray};
use tests::{assert_locked, camera};

/// A locked picture's name, and what draws it anew.
type Locked = (&'static str, fn(&Camera, u32) -> RgbImage);

fn assert_all_locked(pictures: &[Locked]) {
    for (name, picture) in pictures {
        assert_locked(name, &picture(&camera(), 1));
    }
}

/// The rays through all pixels of the camera.
fn rays_of_camera() -> impl Iterator<Item = Ray> {
    let pixels = (0..360).flat_map(|j| (0..640).map(move |i| (i, j)));
    pixels.map(|(i, j)| camera().ray(i.into(), j.into()))
}

/// The unit vector at `angle` from the y axis.
fn from_angle(angle: f64) -> DVec3 {
    DVec3::new(angle.sin(), angle.cos(), 0.0)
}

#[test]
fn no_exercise_is_forgotten() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let text = |path: &str| fs::read_to_string(root.join(path)).expect(path);
    let solutions = text("book/chapters/solutions.md");
    let mut missing = vec![];
    for (step, pictures) in [
        ("step01_rays", step01::PICTURES),
        ("step02_sphere", step02::PICTURES),
        ("step03_nearest", step03::PICTURES),
        ("step04_diffuse", step04::PICTURES),
        ("step05_phong", step05::PICTURES),
    ] {
        let chapter = text(&format!("book/chapters/{step}.md"));
        let examples = format!("steps/{step}/examples");
        for entry in fs::read_dir(root.join(&examples)).expect("a folder").flatten()
        {
            let file = entry.file_name().to_string_lossy().into_owned();
            let Some(name) = file.strip_suffix(".rs") else { continue };
            if name.ends_with("_starter") || name == "my_scene" {
                continue;
            }
            let locked = root.join(format!("tests/snapshots/{name}.snap.png"));
            let listing = format!("{{{{#include ../../{examples}/{file}}}}}");
            let places = [
                ("PICTURES", pictures.iter().any(|(locked, _)| *locked == name)),
                ("tests/snapshots", locked.exists()),
                ("its chapter", chapter.contains(&format!("`examples/{file}`"))),
                ("solutions.md", solutions.contains(&listing)),
            ];
            let places = places.into_iter().filter(|(_, is_there)| !is_there);
            missing
                .extend(places.map(|(place, _)| {
                    format!("{examples}/{file}: not in {place}")
                }));
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
