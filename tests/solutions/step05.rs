use exercises::glass::Glass;
use exercises::mirror::Mirror;
use exercises::*;
use glam::DVec3;
use proptest::prelude::*;
use step05_phong::*;
use tests::{camera, locked, rays_of_camera, unit};

fn without_mirrors() -> Scene<Mirror, Light> {
    let mut scene = mirror::mirrors();
    scene.objects.iter_mut().for_each(|object| object.material.k = 0.0);
    scene
}

fn without_glass() -> Scene<Glass, Light> {
    let mut scene = glass::glasses(1.5);
    scene.objects.iter_mut().for_each(|object| object.material.index = None);
    scene
}

#[test]
fn without_mirrors_and_glass_it_is_step_5_with_the_shadows_of_step_4() {
    let (scene, mirrors, glass) = (scene(), without_mirrors(), without_glass());
    for ray in rays_of_camera() {
        let Some(point) = visible_point(&scene.objects, &ray) else { continue };
        let hides = |q: DVec3| shadows::hidden(&scene.objects, &point, q);
        let mut lights = scene.lights.clone();
        lights.retain(|light| !hides(light.point_light.position));
        let lit = phong(&point, &ray, scene.ambient_light, &lights).sum();
        assert_eq!(mirror::colour(&mirrors, &ray, 10), lit, "{ray:?}");
        assert_eq!(glass::colour(&glass, &ray, 10), lit, "{ray:?}");
    }
}

// mirror

#[test]
fn more_than_ten_mirrors_change_no_pixel() {
    let scene = mirror::mirrors();
    let more = render(&camera(), 1, |ray| mirror::colour(&scene, ray, 100));
    assert!(more == locked("mirror"));
}

#[test]
fn nothing_mirrors_itself() {
    for mut perfect in mirror::mirrors().objects {
        perfect.material.k = 1.0;
        let (ambient_light, objects) = (DVec3::ONE, vec![perfect]);
        let alone = Scene { objects, ambient_light, lights: vec![] };
        for ray in rays_of_camera().step_by(7) {
            let Some(point) = visible_point(&alone.objects, &ray) else { continue };
            let direction = reflect(point.n, -ray.direction);
            let sky = direction_colour(&Ray { direction, ..ray });
            assert_eq!(mirror::colour(&alone, &ray, 1), sky, "{ray:?}");
        }
    }
}

// glass

/// The unit vector at `angle` from the y axis.
fn from_angle(angle: f64) -> DVec3 {
    DVec3::new(angle.sin(), angle.cos(), 0.0)
}

/// What a ray along `v` sees in glass with the normal `n`, where `next` is the colour
/// that a ray from there sees.
fn through(v: DVec3, n: DVec3, index: f64, next: impl Fn(&Ray) -> DVec3) -> DVec3 {
    let point = SurfacePoint { p: DVec3::ONE, n, material: &() };
    let ray = Ray { start: DVec3::ONE - v, direction: v };
    glass::through_glass(&ray, &point, index, next)
}

#[test]
fn glass_bends_light_to_the_normal_and_back() {
    // Sines of 0.6 outside and 0.4 inside: an index of 1.5.
    let outside = DVec3::new(0.6, -0.8, 0.0);
    let inside = DVec3::new(0.4, -(0.84_f64.sqrt()), 0.0);
    // Only the ray that goes on has a colour: its direction.
    let goes_on = |ray: &Ray| match ray.direction {
        down if down.y < 0.0 => down,
        _ => DVec3::ZERO,
    };
    let bent = |v, n| through(v, n, 1.5, goes_on).normalize();
    assert!(bent(outside, DVec3::Y).distance(inside) < 1e-12);
    assert!(bent(inside, DVec3::NEG_Y).distance(outside) < 1e-12);
}

#[test]
fn glass_mirrors_a_25th_of_the_light_head_on_and_all_of_it_along_the_surface() {
    let part = |degrees: f64| {
        let v = -from_angle(degrees.to_radians());
        let bent = glass::refract(v, DVec3::Y, 1.0 / 1.5).expect("it goes in");
        glass::fresnel(v, bent, DVec3::Y, 1.0 / 1.5)
    };
    assert!((part(0.0) - 0.04).abs() < 1e-12);
    assert!((part(60.0) - 0.0892).abs() < 1e-4);
    assert!((part(90.0) - 1.0).abs() < 1e-12);
}

#[test]
fn glass_throws_no_shadow() {
    let hidden = |scene: Scene<Glass, Light>| {
        let Object { sphere, material, .. } = &scene.objects[0];
        let n = (sphere.centre - WARM.position).normalize();
        let point = SurfacePoint {
            p: sphere.centre + 1.01 * sphere.radius * n,
            n,
            material,
        };
        glass::hidden_by_opaque(&scene.objects, &point, WARM.position)
    };
    assert!(hidden(without_glass()));
    assert!(!hidden(glass::glasses(1.5)));
}

proptest! {
    #[test]
    fn n_is_halfway_between_l_and_its_reflection(l in unit(), n in unit()) {
        prop_assume!(0.01 < n.dot(l));
        prop_assert!(halfway::halfway(l, reflect(n, l)).distance(n) < 1e-12);
    }

    #[test]
    fn refraction_obeys_snell_and_can_be_walked_back(
        v in unit(), n in unit(), length in 0.1..5.0_f64, ratio in 0.3..3.0
    ) {
        let n = if v.dot(n) < 0.0 { n } else { -n };
        prop_assume!(v.dot(n) < -0.01);
        let sine = |v: DVec3| v.cross(n).length() / v.length();
        match glass::refract(length * v, n, ratio) {
            None => prop_assert!(1.0 - 1e-12 < ratio * sine(v)),
            Some(bent) => {
                prop_assert!((sine(bent) - ratio * sine(v)).abs() < 1e-12);
                prop_assert!((bent.length() - length).abs() < 1e-12);
                prop_assert!(bent.dot(n) <= 0.0);
                prop_assert!(v.cross(n).dot(bent).abs() < 1e-12);
                let back = glass::refract(-bent, -n, 1.0 / ratio);
                let there = |back: DVec3| (back + length * v).length() < 1e-6;
                prop_assert!(back.is_none_or(there));
                let part = glass::fresnel(v, bent / length, n, ratio);
                let again = glass::fresnel(-bent / length, -v, -n, 1.0 / ratio);
                prop_assert!((0.0..=1.0).contains(&part));
                prop_assert!((part - again).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn glass_in_even_light_is_not_seen(v in unit(), n in unit(), index in 1.0..2.5) {
        let seen = through(v, n, index, |_| DVec3::ONE);
        prop_assert!(seen.distance(DVec3::ONE) < 1e-12);
    }
}
