//! The page "A scene of your own": the Rust program that it writes for a scene draws the
//! picture on the page.

use super::assert_no_faults;
use super::support::reader_workspace::ReaderWorkspace;
use super::typed_book::typed_workspace;
use course::Difference;
use figures::{ControlKind, Figure, Output, find, parse_address};
use image::RgbImage;
use std::collections::HashSet;
use step05_phong::Object;
use tests::primary_rays;

/// The scene of the page, with its parameters.
fn own_scene() -> &'static Figure {
    find("own_scene").expect("the page has it")
}

/// The program that the page writes for the scene of these values.
fn write_program(values: &[f64]) -> String {
    (own_scene().numbers)(values).remove("rust").expect("it has Rust")
}

/// The picture on the page for the scene of these values.
fn page_picture(values: &[f64]) -> RgbImage {
    match (own_scene().draw)(values) {
        Output::Pixels(picture) => picture,
        Output::Drawing(_) => panic!("the scene is a picture"),
    }
}

/// The values at an address.
fn values_at(address: &str) -> Vec<f64> {
    parse_address(own_scene(), address).expect("a scene")
}

/// Values anywhere in their ranges, the same for the same seed, of a small picture.
fn random_values(seed: usize) -> Vec<f64> {
    let values = own_scene().parameters.iter().zip(seed..).map(|(parameter, k)| {
        let [min, max] = parameter.range;
        let fraction = (1e4 * (k as f64).sin()).fract().abs();
        if parameter.words == "columns" { 160.0 } else { min + fraction * (max - min) }
    });
    own_scene().snap_if_allowed(&values.collect::<Vec<_>>()).expect("a scene")
}

/// Saves and runs a program; how it fails, or how its picture differs from this one.
fn program_fault(reader: &ReaderWorkspace, program: &str, picture: &RgbImage) -> Option<String> {
    // The second line of the program is the command that runs it, options after ` -- `.
    let command = program.lines().nth(1)?.trim_end_matches('`');
    let (command, options) = command.split_once(" -- ").unwrap_or((command, ""));
    let (_, example) = command.split_once(" --example ")?;
    let path = format!("steps/step05_phong/examples/{example}.rs");
    reader.write_if_changed(&path, program).expect("a file can be written");
    let options = format!("{options} --width {}", picture.width());
    match reader.draw_example("step05_phong", example, &options) {
        Err(error) => Some(format!("{error} in {program}")),
        Ok(example_picture) => Difference::between(picture, &example_picture)
            .map(|text| format!("It draws another picture, {text}: {program}")),
    }
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn program_of_a_scene_draws_the_picture_on_the_page() {
    let default = own_scene().default_values();
    let difference =
        Difference::between(&tests::read_snapshot("step05_phong"), &page_picture(&default));
    assert!(difference.is_none());
    let parameters = own_scene().parameters.iter();
    let without_objects = parameters.map(|parameter| match parameter.control {
        ControlKind::Switch => 0.0,
        _ => parameter.default,
    });
    let eye_in_a_sphere = "red-sphere-sideways:0,red-sphere-upwards:0,red-sphere-towards-you:0";
    let mirrors = "the-way-back-shadows-and-mirrors:1,ground-mirror-image:0.5";
    let camera = "camera-field-of-view:50,camera-position-sideways:6,camera-position-upwards:3.5,\
                  camera-target-sideways:-0.5,camera-target-backwards:-8,camera-roll:-20";
    let [random_1, random_2, random_3] = [0, 1000, 2000].map(random_values);
    let scenes = [
        default,
        without_objects.collect(),
        values_at(eye_in_a_sphere),
        values_at(mirrors),
        values_at(camera),
        values_at(&format!("{mirrors},{camera}")),
        random_1,
        random_2,
        random_3,
    ];
    let reader = typed_workspace();
    let faults = scenes
        .iter()
        .filter_map(|scene| program_fault(&reader, &write_program(scene), &page_picture(scene)));
    assert_no_faults(&faults.collect::<Vec<_>>());
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn program_of_a_named_scene_draws_its_picture() {
    let reader = typed_workspace();
    let scenes = ["ada", "Grace Hopper", "\"\n é"].map(course::draw_named_scene);
    let faults =
        scenes.iter().filter_map(|(program, picture)| program_fault(&reader, program, picture));
    assert_no_faults(&faults.collect::<Vec<_>>());
}

#[test]
fn spheres_of_a_named_scene_do_not_meet_and_no_ray_touches_one() {
    for name in ["ada", "bob", "cleo", "dan", "eve", ""] {
        let objects = course::named_scene(name).objects;
        // They touch the ground, as in the course's scene, to two digits.
        for (k, a) in objects.iter().enumerate() {
            for b in &objects[..k] {
                let distance = a.sphere.centre.distance(b.sphere.centre);
                let radii = a.sphere.radius + b.sphere.radius;
                assert!(-0.01 < distance - radii, "{name}: {}, {}", a.name, b.name);
            }
        }
        for ray in primary_rays() {
            for Object { name: ball, sphere, .. } in &objects {
                let (a, b, c) = sphere.coefficients(&ray);
                let margin = (b * b - 4.0 * a * c).abs() / (b * b + 4.0 * a * c.abs());
                assert!(1e-12 < margin, "{name}: {ball}, {ray:?}");
            }
        }
    }
}

#[test]
fn names_have_scenes_of_their_own() {
    let scene_text = |name: &str| {
        let scene = course::named_scene(name);
        let objects = scene.objects.iter();
        let parts = objects.map(|one| (one.sphere, one.material));
        format!("{:?} {:?}", parts.collect::<Vec<_>>(), scene.lights)
    };
    let names = (0..1000).map(|k| format!("student {k}"));
    let scenes: HashSet<_> = names.map(|name| scene_text(&name)).collect();
    assert_eq!(scenes.len(), 1000);
    assert_eq!(scene_text("student 7"), scene_text(" student  7\n"));
}
