//! The numbers that the two chapters of step 1 work out or show.

use glam::{DMat3, DVec3};
use std::{env, process::Command};
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
    // A camera that took 1.78 for 639/359 would be right in the four digits above, and
    // wrong at the edges in the picture of step 3.
    let six_digits = DVec3::new(0.290030, 0.161730, -1.0);
    assert!(ray.direction.abs_diff_eq(six_digits, 5e-7), "{}", ray.direction);
}

#[test]
fn rgb8_of_intensities() {
    assert_eq!(rgb8(DVec3::new(0.33, 0.1, 1.5)).0, [84, 26, 255]);
}

#[test]
fn render_of_offsets() {
    // With the identity, V is (i, j, 1), the place in the picture. Of the four rays
    // of the last pixel, one sees the lamp.
    let camera = Camera { matrix: DMat3::IDENTITY, ..Camera::new(3, 2, 1.0) };
    let image = render(&camera, 2, |ray| {
        let v = ray.direction;
        assert_eq!((v - v.round()).abs(), DVec3::new(0.25, 0.25, 0.0));
        let lamp = if v.x > 2.0 && v.y > 1.0 { 2.0 } else { 0.0 };
        DVec3::new(0.2 * v.x, 0.4 * v.y, lamp)
    });
    assert_eq!(image[(1, 0)].0, [51, 0, 0]);
    assert_eq!(image[(2, 1)].0, [102, 102, 128]);
}

#[test]
fn picture_of_a_pixel() {
    near(direction_colour(&camera().ray(480.0, 90.0)), [0.787, 0.7485, 1.0]);
    let picture = picture(&camera(), 1);
    assert_eq!(picture[(480, 90)].0, [201, 191, 255]);
    assert_eq!(picture[(159, 269)].0, [156, 166, 255]);
    assert!(picture.pixels().all(|pixel| pixel.0[2] == 255));
}

#[test]
fn v_res_of_a_film() {
    let film = AspectRatio { width: 2.35, height: 1.0 };
    assert_eq!(film.v_res(640), 272);
}

#[test]
fn draw_and_save_with_options() {
    let program = env::var("CARGO_BIN_EXE_step01_rays").expect("set by Cargo");
    let file = format!("{program}.png");
    let options = "--width 32 --aspect 4:3 --fov 90 --samples 2 --output";
    let run = Command::new(program).args(options.split(' ')).arg(&file).output();
    assert!(run.unwrap().status.success());
    let small = picture(&Camera::new(32, 24, 90_f64.to_radians()), 2);
    assert_eq!(image::open(file).unwrap().to_rgb8(), small);
}
