//! The numbers that chapter 2 works out by hand.

use glam::DVec3;
use std::f64::consts::FRAC_PI_3;
use step02_sphere::{Camera, Ray, Roots, SPHERE};

const ALONG_THE_AXIS: Ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };

fn through_the_pixel() -> Ray {
    Camera::new(640, 360, FRAC_PI_3).ray(300.0, 150.0)
}

fn near(found: f64, printed: f64) {
    assert!((found - printed).abs() < 5e-5, "{found} is not {printed}");
}

#[test]
fn coefficients_along_the_axis() {
    assert_eq!(SPHERE.coefficients(&ALONG_THE_AXIS), (1.0, -10.0, 24.0));
}

#[test]
fn roots_along_the_axis() {
    assert_eq!(SPHERE.intersect(&ALONG_THE_AXIS), Roots::Two(4.0, 6.0));
}

#[test]
fn coefficients_of_a_pixel() {
    let (a, b, c) = SPHERE.coefficients(&through_the_pixel());
    assert_eq!([b, c], [-10.0, 24.0]);
    near(a, 1.0041);
    near(b * b - 4.0 * a * c, 3.608);
}

#[test]
fn first_hit_of_a_pixel() {
    near(SPHERE.intersect(&through_the_pixel()).first_hit().unwrap(), 4.0338);
}
