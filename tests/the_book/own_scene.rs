//! A scene of one's own: the Rust program that a page writes for it draws its picture.

use super::assert_no_faults;
use super::reader_workspace::ReaderWorkspace;
use course::{describe_difference, named_scene};
use figures::{Figure, Output, find, parse_address};
use image::RgbImage;
use std::collections::HashSet;
use tests::primary_rays;

/// Scenes of the page, by their addresses.
const ADDRESSES: [&str; 5] = [
    "",
    "red-sphere-sideways:0,red-sphere-upwards:0,red-sphere-towards-you:0",
    "the-way-back-shadows-and-mirrors:1,ground-mirror-image:0.5",
    "camera-field-of-view:50,camera-position-sideways:6,camera-position-upwards:3.5,\
     camera-target-sideways:-0.5,camera-target-backwards:-8,camera-roll:-20",
    "the-way-back-shadows-and-mirrors:1,camera-position-upwards:3.5,camera-roll:-20",
];

/// The program that the page writes for a scene of these values, and the picture that it shows.
fn program_and_picture(page: &Figure, values: &[f64]) -> (String, RgbImage) {
    let program = (page.numbers)(values).remove("rust").expect("it has Rust");
    let Output::Pixels(picture) = (page.draw)(values) else { panic!("the scene is a picture") };
    (program, picture)
}

/// Saves and runs a program; how it fails, or how its picture differs from this one.
fn program_fault(reader: &ReaderWorkspace, program: &str, picture: &RgbImage) -> Option<String> {
    // The second line of the program is the command that runs it.
    let command = program.lines().nth(1)?.split('`').nth(1)?;
    let (_, example) = command.split_once(" --example ")?;
    let example = example.split(' ').next()?;
    let path = format!("steps/step05_phong/examples/{example}.rs");
    reader.write_if_changed(&path, program).expect("a file can be written");
    let options = if command.contains(" -- ") { "" } else { "-- " };
    let line = format!("{command} {options}--width {}", picture.width());
    let (code, text) = reader.run(&line, "1").expect("a shell");
    if code != Some(0) || text.contains("warning") {
        return Some(format!("{text} in {program}"));
    }
    let drawn = image::open(reader.folder.join(format!("{example}.png"))).expect("its picture");
    describe_difference(picture, &drawn.to_rgb8())
        .map(|text| format!("It draws another picture, {text}: {program}"))
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn program_of_a_scene_draws_its_picture() {
    let page = find("own_scene").expect("the page has it");
    let values = ADDRESSES.map(|address| parse_address(page, address).expect("a scene"));
    let scenes = values.into_iter().map(|values| program_and_picture(page, &values));
    let reader = ReaderWorkspace::typed();
    let faults = scenes.filter_map(|(program, picture)| program_fault(&reader, &program, &picture));
    assert_no_faults(&faults.collect::<Vec<_>>());
}

#[test]
fn spheres_of_a_named_scene_do_not_meet_and_no_ray_touches_one() {
    for name in ["ada", "bob", ""] {
        let objects = named_scene(name).objects;
        // They touch the ground, as in the course's scene, to two digits.
        for (k, a) in objects.iter().enumerate() {
            for b in &objects[..k] {
                let distance = a.sphere.centre.distance(b.sphere.centre);
                let radii = a.sphere.radius + b.sphere.radius;
                assert!(-0.01 < distance - radii, "{name}: {}, {}", a.name, b.name);
            }
        }
        for ray in primary_rays() {
            for object in &objects {
                let (a, b, c) = object.sphere.coefficients(&ray);
                let margin = (b * b - 4.0 * a * c).abs() / (b * b + 4.0 * a * c.abs());
                assert!(1e-12 < margin, "{name}: {}, {ray:?}", object.name);
            }
        }
    }
}

#[test]
fn names_have_scenes_of_their_own() {
    let scene_text = |name: &str| format!("{:?}", named_scene(name));
    let names = (0..1000).map(|k| format!("student {k}"));
    let scenes: HashSet<_> = names.map(|name| scene_text(&name)).collect();
    assert_eq!(scenes.len(), 1000);
    assert_eq!(scene_text("student 7"), scene_text(" student  7\n"));
}
