//! The numbers that chapter 4 works out or shows.

use glam::DVec3;
use step04_diffuse::*;

fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}

fn ray(i: u32, j: u32) -> Ray {
    camera().ray(i.into(), j.into())
}

#[track_caller]
fn near(found: impl Into<DVec3>, printed: [f64; 3]) {
    let found: DVec3 = found.into();
    assert!(found.abs_diff_eq(printed.into(), 5e-5), "{found} is not {printed:?}");
}

#[test]
fn visible_point_of_a_pixel() {
    let scene = scene();
    let point = visible_point(&scene.objects, &ray(470, 120)).unwrap();
    near(point.p, [2.6493, 1.0474, -9.7415]);
    near(point.n, [0.6662, 0.3802, 0.6415]);
}

#[test]
fn diffuse_from_behind() {
    let scene = scene();
    let point = visible_point(&scene.objects, &ray(380, 136)).unwrap();
    let (p, n, material) = (point.p, point.n, point.material());
    assert_eq!(diffuse_at(p, n, material, &COOL_LIGHT), DVec3::ZERO);
}

#[test]
fn lights_of_a_pixel() {
    let scene = scene();
    let point = visible_point(&scene.objects, &ray(470, 120)).unwrap();
    let (p, n, material) = (point.p, point.n, point.material());
    let (l, d) = WARM_LIGHT.direction_from(p);
    near(l, [-0.6076, 0.3612, 0.7074]);
    near(
        [d, WARM_LIGHT.attenuation.divisor(d), n.dot(l)],
        [10.9438, 1.5177, 0.1863],
    );
    near(diffuse(n, l, d, material, &WARM_LIGHT), [0.1179, 0.0681, 0.044]);
    near(diffuse_at(p, n, material, &WARM_LIGHT), [0.1179, 0.0681, 0.044]);
    let (l, d) = COOL_LIGHT.direction_from(p);
    near(l, [0.8048, 0.3254, -0.4964]);
    near(
        [d, COOL_LIGHT.attenuation.divisor(d), n.dot(l)],
        [3.5422, 0.7509, 0.3414],
    );
    near(diffuse(n, l, d, material, &COOL_LIGHT), [0.1964, 0.18, 0.2546]);
}

#[test]
fn colour_of_a_pixel() {
    near(colour(&scene(), &ray(470, 120)), [0.6215, 0.4593, 0.5338]);
    assert_eq!(colour(&scene(), &ray(0, 0)), direction_colour(&ray(0, 0)));
}

#[test]
fn colour_where_one_light_could_end_the_loop() {
    near(colour(&scene(), &ray(358, 206)), [0.4121, 0.169, 0.2003]);
    near(colour(&scene(), &ray(135, 233)), [1.1141, 0.973, 0.9103]);
    near(colour(&scene(), &ray(480, 255)), [0.7829, 0.7973, 1.1523]);
}

#[test]
fn picture_of_a_pixel() {
    let picture = picture(&camera(), 1);
    assert_eq!(picture[(470, 120)].0, [158, 117, 136]);
}
