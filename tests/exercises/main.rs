//! The exercises: each solution's picture is locked, its mathematics holds, and the
//! book has it.

#![allow(dead_code, reason = "the main of an example runs as a program only")]
#![allow(clippy::duplicate_mod, reason = "`fast` has `many` in it")]

mod fast;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

use glam::DVec3;
use image::RgbImage;
use std::{fs, thread};
use step01_rays::{Camera, Ray};
use tests::{assert_locked, camera, here};

type Picture = fn(&Camera, u32) -> RgbImage;

/// The name of each locked picture, and what draws it anew.
const PICTURES: &[(&str, Picture)] = &[
    ("gradient", |_, _| step01::gradient::picture()),
    ("step01_rays", step01::step01_starter::picture),
    ("rings", step01::rings::picture),
    ("graticule", step01::graticule::picture),
    ("look_at", step01::look_at::picture),
    ("panorama", step01::panorama::picture),
    ("step02_sphere", step02::step02_starter::picture),
    ("disc", |camera, _| step02::disc::picture(camera)),
    ("lens", step02::lens::picture),
    ("plane", step02::plane::picture),
    ("quadric", step02::quadric::picture),
    ("step03_nearest", step03::step03_starter::picture),
    ("all_hits", step03::all_hits::picture),
    ("depth", step03::depth::picture),
    ("jitter", step03::jitter::picture),
    ("many", step03::many::picture),
    ("my_scene", step03::my_scene::picture),
    ("step04_diffuse", step04::step04_starter::picture),
    ("gamma", step04::gamma::picture),
    ("shadows", step04::shadows::picture),
    ("spot", step04::spot::picture),
    ("sun", step04::sun::picture),
    ("normals", step04::normals::picture),
    ("plaster", step04::plaster::picture),
    ("snowman", step04::snowman::picture),
    ("step05_phong", step05::step05_starter::picture),
    ("step05_phong", step05::fast::picture),
    ("step05_ambient", |camera, _| step05::terms::picture(camera, |i| i.ambient)),
    ("step05_diffuse", |camera, _| step05::terms::picture(camera, |i| i.diffuse)),
    ("step05_specular", |camera, _| step05::terms::picture(camera, |i| i.specular)),
    ("marbles", step05::marbles::picture),
    ("glass", step05::glass::picture),
    ("halfway", step05::halfway::picture),
    ("mirror", step05::mirror::picture),
    ("speckled", step05::speckled),
    ("shadowed", step05::shadowed),
    ("close_up", |_, _| step05::close_up()),
    ("goodbye", |_, _| step05::goodbye()),
];

#[test]
fn each_picture_is_locked() {
    // In a thread of its own, so that one that fails does not hide another.
    thread::scope(|scope| {
        for (name, picture) in PICTURES {
            scope.spawn(|| assert_locked(name, &picture(&camera(), 1)));
        }
    });
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

/// The names of what is in the folder `path` of the workspace.
fn files(path: &str) -> impl Iterator<Item = String> {
    let files = fs::read_dir(here().join("..").join(path)).expect(path).flatten();
    let names = files.map(|file| file.file_name().to_string_lossy().into_owned());
    names.filter(|name| !name.starts_with('.'))
}

#[test]
fn no_exercise_is_forgotten() {
    let text =
        |path: &str| fs::read_to_string(here().join("..").join(path)).expect(path);
    let mut missing = vec![];
    let locked: Vec<String> = files("tests/snapshots").collect();
    let last = text("book/chapters/where_next.md");
    for step in files("steps") {
        let chapter = text(&format!("book/chapters/{step}.md")) + &last;
        let pages = text("book/chapters/solutions.md") + &chapter;
        let folder = format!("steps/{step}/examples");
        for file in files(&folder) {
            let name = file.trim_end_matches(".rs");
            let is_step = name.ends_with("_starter")
                || ["directions", "fast", "row"].contains(&name);
            let picture = match name {
                "terms" => "step05_specular",
                _ if is_step => &step,
                _ => name,
            };
            let listing = format!("{{{{#include ../../{folder}/{file}");
            for (is_there, place) in [
                (PICTURES.iter().any(|(name, _)| *name == picture), "PICTURES"),
                (locked.contains(&format!("{picture}.snap.png")), "snapshots"),
                (chapter.contains(&format!("`examples/{file}`")), "its chapter"),
                (pages.contains(&listing), "solutions.md"),
            ] {
                if !is_there {
                    missing.push(format!("{folder}/{file} is not in {place}"));
                }
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn where_our_program_looks_at_a_picture_the_page_does() {
    let mut asked = 0;
    for file in files("book/chapters").filter(|file| is_chapter(file)) {
        let path = here().join("../book/chapters").join(&file);
        let text = fs::read_to_string(path).expect("a chapter");
        let asks = text.split("cargo run --bin check -- ../ray-casting/").skip(1);
        for name in asks.filter_map(|rest| rest.split_once(".png")) {
            let form = format!("{{{{#check {}}}}}", name.0);
            assert!(name.0 == "fast" || text.contains(&form), "{file}: no {form}");
            asked += 1;
        }
    }
    assert!(15 < asked, "{asked}");
}

fn is_chapter(file: &str) -> bool {
    file.starts_with("step0") || file == "where_next.md"
}
