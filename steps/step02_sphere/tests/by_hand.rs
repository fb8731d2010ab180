//! The numbers that chapter 2 works out or shows.

use glam::DVec3;
use std::{env, process::Command};
use step02_sphere::*;

fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}

fn ahead(x: f64, z: f64) -> Ray {
    Ray { start: DVec3::new(x, 0.0, z), direction: DVec3::NEG_Z }
}

fn through_the_pixel() -> Ray {
    camera().ray(300.0, 150.0)
}

#[track_caller]
fn near(found: f64, printed: f64) {
    assert!((found - printed).abs() < 5e-5, "{found} is not {printed}");
}

#[test]
fn coefficients_along_the_axis() {
    assert_eq!(SPHERE.coefficients(&ahead(0.0, 0.0)), (1.0, -10.0, 24.0));
}

#[test]
fn quadratic_of_three_rays() {
    assert_eq!(quadratic(1.0, -10.0, 24.0), Roots::Two(4.0, 6.0));
    assert_eq!(quadratic(1.0, -10.0, 25.0), Roots::One(5.0));
    assert_eq!(quadratic(1.0, -10.0, 28.0), Roots::Zero);
}

#[test]
fn coefficients_of_a_pixel() {
    let (a, b, c) = SPHERE.coefficients(&through_the_pixel());
    assert_eq!([b, c], [-10.0, 24.0]);
    near(a, 1.0041);
    near(b * b - 4.0 * a * c, 3.608);
}

#[test]
fn intersect_at_a_pixel() {
    near(SPHERE.intersect(&through_the_pixel()).first_hit().unwrap(), 4.0338);
}

#[test]
fn intersect_near_the_edge() {
    for side in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y] {
        let roots = |x: f64| {
            let direction = DVec3::NEG_Z + x * side;
            SPHERE.intersect(&Ray { start: DVec3::ZERO, direction })
        };
        near(roots(0.2).first_hit().unwrap(), 60.0 / 13.0);
        assert_eq!(roots(0.21), Roots::Zero);
    }
}

#[test]
fn first_hit_of_five_starts() {
    let hit = |z: f64| SPHERE.intersect(&ahead(0.0, z)).first_hit();
    assert_eq!([0.0, -4.0, -5.0].map(hit), [Some(4.0), Some(2.0), Some(1.0)]);
    assert_eq!([-6.0, -10.0].map(hit), [None, None]);
}

#[test]
fn picture_of_a_disc() {
    let picture = picture(&camera(), 1);
    assert_eq!(picture[(300, 150)].0, [232, 87, 71]);
    let is_red = |&i: &u32| picture[(i, 180)].0 == [232, 87, 71];
    assert_eq!((0..640).filter(is_red).count(), 226);
    let sky = camera().ray(0.0, 0.0);
    assert_eq!(colour(&SPHERE, &sky), direction_colour(&sky));
}

#[test]
fn draw_and_save_with_samples() {
    let program = env::var("CARGO_BIN_EXE_step02_sphere").expect("set by Cargo");
    let file = format!("{program}.png");
    let options = "--width 64 --samples 2 --output";
    let run = Command::new(program).args(options.split(' ')).arg(&file).output();
    assert!(run.unwrap().status.success());
    let smooth = picture(&Camera::new(64, 36, 60_f64.to_radians()), 2);
    assert_eq!(image::open(file).unwrap().to_rgb8(), smooth);
}
