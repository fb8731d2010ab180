//! The mirrors, whose depth, offset and k can be set, against the example as it is listed.

use course::examples::mirror;
use figures::{Figure, Output, find};
use glam::DVec3;
use image::RgbImage;
use std::path::Path;
use step05_phong::{Camera, Ray, render};

const DEPTH: usize = 3;
const OFFSET: usize = 4;
const FIRST_K: usize = 5;

/// The picture of the mirrors, and its values with these in their places.
fn mirrors_with(changes: &[(usize, f64)]) -> (&'static Figure, Vec<f64>) {
    let figure = find("mirror").expect("a picture");
    let mut values = figure.default_values();
    for (index, value) in changes {
        values[*index] = *value;
    }
    (figure, figure.snap_if_allowed(&values).expect("allowed values"))
}

fn draw(changes: &[(usize, f64)]) -> RgbImage {
    let (figure, values) = mirrors_with(changes);
    let Output::Pixels(picture) = (figure.draw)(&values) else { panic!("a drawing") };
    picture
}

/// A small camera and the columns that ask for it.
fn small_camera() -> (Camera, (usize, f64)) {
    (Camera::new(160, 90, 60_f64.to_radians()), (2, 160.0))
}

#[test]
fn depth_and_k_draw_the_example_at_that_depth_with_that_k() {
    let (camera, columns) = small_camera();
    for (depth, k_of_ground) in [(0, 0.25), (1, 0.25), (3, 0.9), (10, 1.0)] {
        let mut scene = mirror::mirrors();
        scene.objects[1].material.k = k_of_ground;
        let colour = |ray: &Ray| mirror::colour(&scene, ray, depth, mirror::OFFSET);
        let changes = [columns, (DEPTH, f64::from(depth)), (FIRST_K + 1, k_of_ground)];
        assert!(draw(&changes) == render(&camera, 1, colour), "depth {depth}, k {k_of_ground}");
    }
}

#[test]
fn offset_0_draws_the_rash_of_rays_that_start_on_the_surface() {
    let path = "../../../tests/snapshots/speckled.snap.png";
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let speckled = image::open(path).expect("a locked picture").to_rgb8();
    assert!(draw(&[(DEPTH, 0.0), (OFFSET, 0.0)]) == speckled);
    assert!(draw(&[(DEPTH, 0.0)]) != speckled);
}

#[test]
fn table_leads_to_the_bytes_of_the_pixel() {
    for (pixel, depth, offset, count) in [
        // The white sphere, the ground, the red sphere, the ground, the green sphere.
        ([168, 295], 10, 8, 5),
        ([168, 295], 2, 8, 3),
        // A loose shadow on the ground, and the sky itself.
        ([420, 310], 10, 17, 3),
        ([600, 20], 10, 8, 1),
    ] {
        let [i, j] = pixel.map(f64::from);
        let changes = [(0, i), (1, j), (DEPTH, f64::from(depth)), (OFFSET, f64::from(offset))];
        let (figure, values) = mirrors_with(&changes);
        let numbers = (figure.numbers)(&values);
        let text = |name: &str, k: usize| &numbers[&format!("{name}{k}")];
        let rows = (0..11).take_while(|k| !text("object", *k).is_empty()).count();
        assert_eq!(rows, count, "{pixel:?}, depth {depth}, offset {offset}");
        // From the last row up, as the colours come back.
        let last = parse_vector(text("I", rows - 1));
        let colour = (0..rows - 1).rev().fold(last, |mirrored, k| {
            let [own, shine] = ["matte", "specular"].map(|name| parse_vector(text(name, k)));
            let share: f64 = text("k", k).parse().expect("k");
            let colour = (1.0 - share) * own + share * mirrored + shine;
            assert!(colour.abs_diff_eq(parse_vector(text("I", k)), 2e-4));
            colour
        });
        let Output::Pixels(picture) = (figure.draw)(&values) else { panic!() };
        let bytes = picture.get_pixel(pixel[0], pixel[1]).0.map(f64::from);
        assert_eq!(numbers["bytes"], figures::format_vector(bytes));
        let bytes = DVec3::from_array(bytes);
        assert!((255.0 * colour.min(DVec3::ONE)).abs_diff_eq(bytes, 0.6));
    }
}

fn parse_vector(text: &str) -> DVec3 {
    let entries = text.trim_matches(['(', ')']).split(", ");
    let entries: Vec<f64> = entries.filter_map(|entry| entry.parse().ok()).collect();
    DVec3::from_slice(&entries)
}
