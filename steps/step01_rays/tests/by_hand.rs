//! The numbers that the two chapters of step 1 work out or show.

use glam::{DMat3, DVec3};
use std::process::Command;
use step01_rays::*;

fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}

#[track_caller]
fn near(found: DVec3, printed: [f64; 3]) {
    assert!(found.abs_diff_eq(printed.into(), 5e-5), "{found} is not {printed:?}");
}

#[test]
fn ray_at() {
    let ray = Ray { start: DVec3::X, direction: DVec3::new(0.0, 0.0, -2.0) };
    near(ray.at(1.5), [1.0, 0.0, -3.0]);
}

#[test]
fn camera_ray_of_a_pixel() {
    let ray = camera().ray(480.0, 90.0);
    near(ray.direction, [0.29, 0.1617, -1.0]);
}

#[test]
fn rgb8_of_intensities() {
    assert_eq!(rgb8(DVec3::new(0.33, 0.5, 1.5)).0, [84, 128, 255]);
}

#[test]
fn render_of_places() {
    let camera = Camera { matrix: DMat3::IDENTITY, ..Camera::new(3, 2, 1.0) };
    let image = render(&camera, 2, |ray| {
        let offset = (ray.direction - ray.direction.round()).abs();
        assert_eq!(offset, DVec3::new(0.25, 0.25, 0.0));
        DVec3::new(0.2, 0.4, 1.0) * ray.direction
    });
    assert_eq!(image[(2, 1)].0, [102, 102, 255]);
}

#[test]
fn picture_of_a_pixel() {
    near(direction_colour(&camera().ray(480.0, 90.0)), [0.787, 0.7485, 1.0]);
    assert_eq!(picture(&camera(), 1)[(480, 90)].0, [201, 191, 255]);
}

#[test]
fn v_res_of_a_film() {
    let film: AspectRatio = "2.35:1".parse().unwrap();
    assert_eq!(film.v_res(640), 272);
}

#[test]
fn run_with_options() {
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/small.png");
    let options = "--width 32 --aspect 4:3 --fov 90 --samples 2 --output";
    let mut program = Command::new(env!("CARGO_BIN_EXE_step01_rays"));
    program.args(options.split(' ')).arg(file).output().unwrap();
    let small = picture(&Camera::new(32, 24, 90_f64.to_radians()), 2);
    assert_eq!(image::open(file).unwrap().to_rgb8(), small);
}
