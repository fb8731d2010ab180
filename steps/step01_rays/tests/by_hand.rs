//! The numbers that chapter 1 works out by hand.

use glam::DVec3;
use std::f64::consts::FRAC_PI_3;
use step01_rays::{AspectRatio, Camera, direction_colour};

fn near(found: DVec3, printed: [f64; 3]) {
    assert!(found.abs_diff_eq(printed.into(), 5e-5), "{found} is not {printed:?}");
}

#[test]
fn direction_of_a_pixel() {
    let camera = Camera::new(640, 360, FRAC_PI_3);
    near(camera.matrix.z_axis, [-0.5774, 0.3244, -1.0]);
    near(camera.ray(480.0, 90.0).direction, [0.29, 0.1617, -1.0]);
}

#[test]
fn colour_of_a_pixel() {
    let ray = Camera::new(640, 360, FRAC_PI_3).ray(480.0, 90.0);
    near(direction_colour(&ray), [0.787, 0.7485, 1.0]);
}

#[test]
fn rows_of_a_film() {
    let ratio = AspectRatio { width: 2.35, height: 1.0 };
    assert_eq!(ratio.v_res(640), 272);
}
