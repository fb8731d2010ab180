//! The numbers that chapter 5 works out by hand.

use glam::DVec3;
use std::f64::consts::FRAC_PI_3;
use step05_phong::{COOL, Camera, Ray, WARM, reflect, scene, terms, visible_point};

fn through_the_pixel() -> Ray {
    Camera::new(640, 360, FRAC_PI_3).ray(470.0, 120.0)
}

fn near(found: DVec3, printed: [f64; 3]) {
    assert!(found.abs_diff_eq(printed.into(), 5e-5), "{found} is not {printed:?}");
}

#[test]
fn reflections_of_a_pixel() {
    let scene = scene();
    let point = visible_point(&scene.objects, &through_the_pixel()).unwrap();
    let (l, _) = WARM.direction_from(point.p);
    near(reflect(point.n, l), [0.8559, -0.2195, -0.4683]);
    let (l, _) = COOL.direction_from(point.p);
    near(reflect(point.n, l), [-0.3498, -0.0657, 0.9345]);
}

#[test]
fn terms_of_a_pixel() {
    let terms = terms(&scene(), &through_the_pixel()).unwrap();
    near(terms.ambient, [0.3072, 0.2112, 0.2352]);
    near(terms.diffuse, [0.3143, 0.2481, 0.2986]);
    near(terms.specular, [0.2728, 0.382, 0.5456]);
    near(terms.sum(), [0.8943, 0.8413, 1.0795]);
}
