//! The numbers that chapter 4 works out by hand.

use glam::DVec3;
use std::f64::consts::FRAC_PI_3;
use step04_diffuse::{
    COOL, Camera, Ray, WARM, colour, diffuse, scene, visible_point,
};

fn through_the_pixel() -> Ray {
    Camera::new(640, 360, FRAC_PI_3).ray(470.0, 120.0)
}

fn near(found: DVec3, printed: [f64; 3]) {
    assert!(found.abs_diff_eq(printed.into(), 5e-5), "{found} is not {printed:?}");
}

#[test]
fn normal_of_a_pixel() {
    let scene = scene();
    let point = visible_point(&scene.objects, &through_the_pixel()).unwrap();
    near(point.p, [2.6493, 1.0474, -9.7415]);
    near(point.n, [0.6662, 0.3802, 0.6415]);
}

#[test]
fn lights_of_a_pixel() {
    let scene = scene();
    let point = visible_point(&scene.objects, &through_the_pixel()).unwrap();
    let (l, d) = WARM.direction_from(point.p);
    near(l, [-0.6076, 0.3612, 0.7074]);
    near(diffuse(point.n, l, d, point.material, &WARM), [0.1179, 0.0681, 0.044]);
    let (l, d) = COOL.direction_from(point.p);
    near(l, [0.8048, 0.3254, -0.4964]);
    near(diffuse(point.n, l, d, point.material, &COOL), [0.1964, 0.18, 0.2546]);
}

#[test]
fn sum_of_a_pixel() {
    near(colour(&scene(), &through_the_pixel()), [0.6215, 0.4593, 0.5338]);
}
