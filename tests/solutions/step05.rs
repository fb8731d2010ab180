//! Tests of the solutions for step 5 and for the chapter "The ray's way back".

use course::examples::*;
use glam::DVec3;
use step05_phong::*;
use support::{primary_rays, test_law};

#[test]
fn scenes_without_mirrors_and_glass_look_like_step_5_with_shadows() {
    let (scene, mut mirrors, mut glasses) = (scene(), mirror::mirrors(), glass::glasses(1.5));
    mirrors.objects.iter_mut().for_each(|object| object.material.k = 0.0);
    glasses.objects.iter_mut().for_each(|object| object.material.index = None);
    for ray in primary_rays() {
        let Some(point) = visible_point(&scene.objects, &ray) else { continue };
        let is_hidden = |q: DVec3| shadows::hidden(&scene.objects, &point, q, shadows::OFFSET);
        let mut lights = scene.lights.clone();
        lights.retain(|light| !is_hidden(light.point_light.position));
        let expected = phong(&point, &ray, scene.ambient_light, &lights).sum();
        assert_eq!(mirror::colour(&mirrors, &ray, 10, mirror::OFFSET), expected, "{ray:?}");
        assert_eq!(glass::colour(&glasses, &ray, 10), expected, "{ray:?}");
    }
}

/// The page "A scene of your own" begins with a copy of step 5's scene. A comparison of pictures
/// wouldn't cover the whole scene, because the green sphere isn't in view.
#[test]
fn own_scene_begins_as_the_scene_of_step_5() {
    let (own_scene, step_scene) = (own_scene::my_scene(), scene());
    assert_eq!(own_scene.objects.len(), step_scene.objects.len());
    for (own_object, step_object) in own_scene.objects.iter().zip(&step_scene.objects) {
        assert_eq!(own_object, step_object, "{} in examples/own_scene.rs", step_object.name);
    }
    assert_eq!(own_scene.ambient_light, step_scene.ambient_light, "L_a in examples/own_scene.rs");
    assert_eq!(own_scene.lights, step_scene.lights, "the lights in examples/own_scene.rs");
}

#[test]
fn glass_reflects_4_percent_head_on_and_everything_along_the_surface() {
    let reflectance = |degrees: f64| {
        let v = -DVec3::Y.rotate_z(degrees.to_radians());
        let refracted = glass::refract(v, DVec3::Y, 1.0 / 1.5).expect("the light enters the glass");
        glass::fresnel(v, refracted, DVec3::Y, 1.0 / 1.5)
    };
    assert!((reflectance(0.0) - 0.04).abs() < 1e-12);
    assert!((reflectance(60.0) - 0.0892).abs() < 1e-4);
    assert!((reflectance(90.0) - 1.0).abs() < 1e-12);
}

#[test]
fn refraction_obeys_snell_and_is_reversible() {
    test_law(256, |random| {
        let (v, n, length) = (random.unit_vector(), random.unit_vector(), random.number(0.1, 5.0));
        let (n, ratio) = (if v.dot(n) < 0.0 { n } else { -n }, random.number(0.3, 3.0));
        let sine = |v: DVec3| v.cross(n).length() / v.length();
        let Some(refracted) = glass::refract(length * v, n, ratio) else {
            assert!(ratio * sine(v) > 1.0 - 1e-12);
            return;
        };
        assert!((sine(refracted) - ratio * sine(v)).abs() < 1e-12);
        assert!((refracted.length() - length).abs() < 1e-12);
        assert!(refracted.dot(n) <= 0.0);
        assert!(v.cross(n).dot(refracted).abs() < 1e-12);
        let reversed = glass::refract(-refracted, -n, 1.0 / ratio);
        assert!(reversed.is_none_or(|w| (w + length * v).length() < 1e-6));
        let part = glass::fresnel(v, refracted / length, n, ratio);
        let reversed_part = glass::fresnel(-refracted / length, -v, -n, 1.0 / ratio);
        assert!((0.0..=1.0).contains(&part) && (part - reversed_part).abs() < 1e-9);
    });
}

/// The picture doesn't test total reflection, because a ray that enters a ball from outside is
/// never totally reflected inside the ball.
#[test]
fn glass_reflects_all_light_from_inside_beyond_42_degrees() {
    let scene = glass::glasses(1.5);
    let hit = Hit { t: 1.0, object: &scene.objects[0] };
    let point = SurfacePoint { hit, p: DVec3::new(0.0, 1.0, 0.0), n: DVec3::Y };
    // A ray that reaches the surface from inside, at an angle of `degrees` to the normal.
    let ray_at = |degrees: f64| {
        let direction = DVec3::Y.rotate_z(degrees.to_radians());
        Ray { start: point.p - direction, direction }
    };
    let next_direction =
        |degrees| glass::through_glass(&ray_at(degrees), &point, 1.5, |next| next.direction);
    for degrees in [42.0, 60.0, 89.0] {
        let mirrored_direction = DVec3::NEG_Y.rotate_z(-f64::to_radians(degrees));
        assert!(
            next_direction(degrees).abs_diff_eq(mirrored_direction, 1e-12),
            "{degrees}°: {}",
            next_direction(degrees)
        );
    }
    // At a slightly smaller angle, most of the light leaves the glass.
    assert!(next_direction(41.0).y > -0.5, "{}", next_direction(41.0));
    // With an index below 1, as for an air bubble in glass, rays from outside may be totally
    // reflected, too.
    let from_outside =
        Ray { start: DVec3::new(-2.0, 2.0, 0.0), direction: DVec3::new(2.0, -1.0, 0.0) };
    let direction = glass::through_glass(&from_outside, &point, 1.0 / 1.5, |next| next.direction);
    assert_eq!(direction, DVec3::new(2.0, 1.0, 0.0));
}

/// The tenth mirror image is too faint to change any byte, so the picture doesn't test what the
/// last mirror shows.
#[test]
fn last_mirror_shows_its_own_colour_and_the_last_glass_is_black() {
    let scene = mirror::mirrors();
    let mut paint = mirror::mirrors();
    paint.objects.iter_mut().for_each(|object| object.material.k = 0.0);
    let glasses = glass::glasses(1.5);
    let mut counts = [0; 2];
    for ray in primary_rays().step_by(97) {
        let last_colour = mirror::colour(&scene, &ray, 0, mirror::OFFSET);
        assert_eq!(last_colour, mirror::colour(&paint, &ray, 0, mirror::OFFSET), "{ray:?}");
        let Some(point) = visible_point(&scene.objects, &ray) else { continue };
        let mirror::Mirror { material, k } = point.material();
        if *k > 0.0 {
            // With a depth of 1, a ray sees a mixture of two colours: the mirror's own colour, and
            // the colour of the mirror image. The mirror image is traced with a depth of 0.
            let start = point.p + mirror::OFFSET * point.n;
            let mirrored_ray = Ray { start, direction: reflect(point.n, -ray.direction) };
            let is_hidden = |light: &Light| {
                let q = light.point_light.position;
                mirror::hidden(&scene.objects, &point, q, mirror::OFFSET)
            };
            let terms = mirror::shadowed_phong(&point, &ray, material, &scene, is_hidden);
            let own_colour = (1.0 - k) * (terms.ambient + terms.diffuse) + terms.specular;
            let expected =
                own_colour + k * mirror::colour(&scene, &mirrored_ray, 0, mirror::OFFSET);
            let colour = mirror::colour(&scene, &ray, 1, mirror::OFFSET);
            assert!(colour.abs_diff_eq(expected, 1e-12), "{ray:?}");
            counts[0] += 1;
        }
        if visible_point(&glasses.objects, &ray)
            .is_some_and(|point| point.material().index.is_some())
        {
            assert_eq!(glass::colour(&glasses, &ray, 0), DVec3::ZERO, "{ray:?}");
            counts[1] += 1;
        }
    }
    assert!(counts.into_iter().all(|count| count > 100), "{counts:?}");
}
