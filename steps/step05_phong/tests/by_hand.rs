//! The numbers that chapter 5 works out or shows.

use glam::DVec3;
use step05_phong::*;

fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}

fn terms_at(i: u32, j: u32) -> Terms {
    let ray = camera().ray(i.into(), j.into());
    let mut scene = scene();
    scene.lights.reverse(); // the order of the lights makes no difference
    terms(&scene, &ray).unwrap()
}

#[track_caller]
fn near(found: DVec3, printed: [f64; 3]) {
    assert!(found.abs_diff_eq(printed.into(), 5e-5), "{found} is not {printed:?}");
}

#[test]
fn reflect_at_a_pixel() {
    let ray = camera().ray(470.0, 120.0);
    let SurfacePoint { p, n, .. } = visible_point(&OBJECTS, &ray).unwrap();
    near(reflect(n, WARM_LIGHT.direction_from(p).0), [0.8559, -0.2195, -0.4683]);
    near(reflect(n, COOL_LIGHT.direction_from(p).0), [-0.3498, -0.0657, 0.9345]);
}

#[test]
fn phong_at_the_gate() {
    near(terms_at(605, 165).specular, [0.1079, 0.1511, 0.2158]);
    near(terms_at(605, 166).specular, [0.0, 0.0, 0.0]);
}

#[test]
fn specular_at_a_teal_pixel() {
    near(terms_at(583, 215).specular, [0.4475, 0.4027, 0.358]);
    let (teal, warm) = (scene().objects[5].material, scene().lights[0]);
    assert_eq!(specular(-DVec3::Z, DVec3::Z, 7.0, &teal, &warm), DVec3::ZERO);
}

#[test]
fn materials_add_up() {
    let (mut r_s, mut n, scene) = (DVec3::ZERO, 0, scene());
    for (k, (object, flat)) in (1..).zip(scene.objects.iter().zip(OBJECTS)) {
        r_s += f64::from(k) * object.material.specular;
        n += k * object.material.shininess;
        assert_eq!(object.sphere, flat.sphere);
    }
    near(r_s, [25.0, 25.0, 25.0]);
    assert_eq!(n, 3476);
}

#[test]
fn terms_of_white_and_of_the_ground() {
    near(terms_at(123, 254).sum(), [1.4221, 1.2353, 1.109]);
    near(terms_at(480, 255).specular, [0.0009, 0.0012, 0.0017]);
}

#[test]
fn terms_of_a_pixel() {
    let terms = terms_at(470, 120);
    near(terms.ambient, [0.3072, 0.2112, 0.2352]);
    near(terms.diffuse, [0.3143, 0.2481, 0.2986]);
    near(terms.specular, [0.2728, 0.382, 0.5456]);
    near(terms.sum(), [0.8943, 0.8413, 1.0795]);
    let picture = picture(&camera(), 1);
    assert_eq!(picture[(470, 120)].0, [228, 215, 255]);
    let sky = camera().ray(0.0, 0.0);
    assert_eq!(colour(&scene(), &sky), direction_colour(&sky));
}
