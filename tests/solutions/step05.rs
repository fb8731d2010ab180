use course::examples::glass::Glass;
use course::examples::mirror::Mirror;
use course::examples::*;
use glam::DVec3;
use proptest::prelude::*;
use step05_phong::*;
use tests::{camera, primary_rays, random_unit_vector, read_snapshot};

/// The scene of the exercise `mirror`, in which nothing reflects.
fn scene_without_mirrors() -> Scene<Mirror, Light> {
    let mut scene = mirror::mirrors();
    scene.objects.iter_mut().for_each(|object| object.material.k = 0.0);
    scene
}

/// The scene of the exercise `glass`, in which everything is opaque.
fn scene_with_opaque_spheres() -> Scene<Glass, Light> {
    let mut scene = glass::glasses(1.5);
    scene.objects.iter_mut().for_each(|object| object.material.index = None);
    scene
}

#[test]
fn scenes_without_mirrors_and_glass_look_like_step_5_with_shadows() {
    let (scene, opaque_mirrors, opaque_glass) =
        (scene(), scene_without_mirrors(), scene_with_opaque_spheres());
    for ray in primary_rays() {
        let Some(point) = visible_point(&scene.objects, &ray) else { continue };
        let is_hidden = |q: DVec3| shadows::hidden(&scene.objects, &point, q, shadows::OFFSET);
        let mut lights = scene.lights.clone();
        lights.retain(|light| !is_hidden(light.point_light.position));
        let expected = phong(&point, &ray, scene.ambient_light, &lights).sum();
        assert_eq!(mirror::colour(&opaque_mirrors, &ray, 10, mirror::OFFSET), expected, "{ray:?}");
        assert_eq!(glass::colour(&opaque_glass, &ray, 10), expected, "{ray:?}");
    }
}

// mirror

#[test]
fn mirror_with_depth_100_draws_the_locked_picture() {
    let scene = mirror::mirrors();
    let picture = render(&camera(), 1, |ray| mirror::colour(&scene, ray, 100, mirror::OFFSET));
    assert!(picture == read_snapshot("mirror"));
}

#[test]
fn mirror_does_not_reflect_itself() {
    for mut object in mirror::mirrors().objects {
        object.material.k = 1.0;
        let (ambient_light, objects) = (DVec3::ONE, vec![object]);
        let scene = Scene { objects, ambient_light, lights: vec![] };
        for ray in primary_rays().step_by(7) {
            let Some(point) = visible_point(&scene.objects, &ray) else { continue };
            let direction = reflect(point.n, -ray.direction);
            let sky = direction_colour(&Ray { direction, ..ray });
            assert_eq!(mirror::colour(&scene, &ray, 1, mirror::OFFSET), sky, "{ray:?}");
        }
    }
}

// glass

/// The unit vector in the xy plane at `angle` from the y axis.
fn unit_vector_at(angle: f64) -> DVec3 {
    DVec3::new(angle.sin(), angle.cos(), 0.0)
}

/// The colour of a ray along `v` that meets glass with the normal `n`; `trace` gives the
/// colour of a ray that goes on from there.
fn glass_colour(v: DVec3, n: DVec3, index: f64, trace: impl Fn(&Ray) -> DVec3) -> DVec3 {
    let point = SurfacePoint { p: DVec3::ONE, n, material: &() };
    let ray = Ray { start: DVec3::ONE - v, direction: v };
    glass::through_glass(&ray, &point, index, trace)
}

#[test]
fn glass_refracts_to_the_normal_inside_and_away_outside() {
    // Sines of 0.6 outside and 0.4 inside: an index of 1.5.
    let outside = DVec3::new(0.6, -0.8, 0.0);
    let inside = DVec3::new(0.4, -(0.84_f64.sqrt()), 0.0);
    // The colour of the refracted ray is its direction; the reflected one is black.
    let trace = |ray: &Ray| match ray.direction {
        v if v.y < 0.0 => v,
        _ => DVec3::ZERO,
    };
    let refracted = |v, n| glass_colour(v, n, 1.5, trace).normalize();
    assert!(refracted(outside, DVec3::Y).distance(inside) < 1e-12);
    assert!(refracted(inside, DVec3::NEG_Y).distance(outside) < 1e-12);
}

#[test]
fn glass_reflects_4_percent_head_on_and_everything_along_the_surface() {
    let reflectance = |degrees: f64| {
        let v = -unit_vector_at(degrees.to_radians());
        let refracted = glass::refract(v, DVec3::Y, 1.0 / 1.5).expect("light goes in");
        glass::fresnel(v, refracted, DVec3::Y, 1.0 / 1.5)
    };
    assert!((reflectance(0.0) - 0.04).abs() < 1e-12);
    assert!((reflectance(60.0) - 0.0892).abs() < 1e-4);
    assert!((reflectance(90.0) - 1.0).abs() < 1e-12);
}

#[test]
fn glass_casts_no_shadow() {
    let is_hidden = |scene: Scene<Glass, Light>| {
        let Object { sphere, material, .. } = &scene.objects[0];
        let n = (sphere.centre - WARM.position).normalize();
        let point = SurfacePoint { p: sphere.centre + 1.01 * sphere.radius * n, n, material };
        glass::hidden_by_opaque(&scene.objects, &point, WARM.position)
    };
    assert!(is_hidden(scene_with_opaque_spheres()));
    assert!(!is_hidden(glass::glasses(1.5)));
}

proptest! {
    #[test]
    fn normal_is_halfway_between_l_and_its_reflection(l in random_unit_vector(), n in random_unit_vector()) {
        prop_assume!(0.01 < n.dot(l));
        prop_assert!(halfway::halfway(l, reflect(n, l)).distance(n) < 1e-12);
    }

    #[test]
    fn refraction_obeys_snell_and_is_reversible(
        v in random_unit_vector(), n in random_unit_vector(), length in 0.1..5.0_f64, ratio in 0.3..3.0
    ) {
        let n = if v.dot(n) < 0.0 { n } else { -n };
        prop_assume!(v.dot(n) < -0.01);
        let sine = |v: DVec3| v.cross(n).length() / v.length();
        match glass::refract(length * v, n, ratio) {
            None => prop_assert!(1.0 - 1e-12 < ratio * sine(v)),
            Some(refracted) => {
                prop_assert!((sine(refracted) - ratio * sine(v)).abs() < 1e-12);
                prop_assert!((refracted.length() - length).abs() < 1e-12);
                prop_assert!(refracted.dot(n) <= 0.0);
                prop_assert!(v.cross(n).dot(refracted).abs() < 1e-12);
                let reversed = glass::refract(-refracted, -n, 1.0 / ratio);
                let is_reversible = reversed.is_none_or(|w| (w + length * v).length() < 1e-6);
                prop_assert!(is_reversible);
                let part = glass::fresnel(v, refracted / length, n, ratio);
                let reversed_part = glass::fresnel(-refracted / length, -v, -n, 1.0 / ratio);
                prop_assert!((0.0..=1.0).contains(&part));
                prop_assert!((part - reversed_part).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn glass_in_uniform_light_has_the_colour_of_the_light(v in random_unit_vector(), n in random_unit_vector(), index in 1.0..2.5) {
        let colour = glass_colour(v, n, index, |_| DVec3::ONE);
        prop_assert!(colour.distance(DVec3::ONE) < 1e-12);
    }
}
