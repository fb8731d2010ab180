use course::examples::*;
use glam::DVec3;
use step05_phong::*;
use tests::{primary_rays, test_law};

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

#[test]
fn glass_reflects_4_percent_head_on_and_everything_along_the_surface() {
    let reflectance = |degrees: f64| {
        let v = -DVec3::Y.rotate_z(degrees.to_radians());
        let refracted = glass::refract(v, DVec3::Y, 1.0 / 1.5).expect("light goes in");
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
            assert!(1.0 - 1e-12 < ratio * sine(v));
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
