//! `fast` draws the same bytes as `render` with `colour`.

use super::fast_example::draw;
use course::examples::look_at::look_at;
use course::{camera_with_size, named_scene};
use fearless_simd::Level;
use glam::DVec3;
use proptest::prelude::*;
use std::env;
use step05_phong::*;
use tests::{random_point, random_unit_vector};

/// Fails unless `fast` draws the bytes of `render`, with the fewest and with the most instructions.
fn assert_fast_draws(camera: &Camera, samples: u32, scene: &Scene<Material, Light>) {
    let expected = render(camera, samples, |ray| colour(scene, ray));
    for level in [Level::baseline(), Level::new()] {
        assert!(draw(level, camera, samples, scene) == expected, "other bytes with {level:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(match env::var_os("THOROUGH") {
        Some(_) => 250,
        None => 50,
    }))]

    #[test]
    fn fast_draws_the_bytes_of_render_for_parts_of_random_scenes(
        name in 0..10_000_u32, objects in 0..10_usize, lights in 0..3_usize,
        from in random_point(), roll in -3.0..3.0, samples in 1..4_u32
    ) {
        let mut scene = named_scene(&name.to_string());
        scene.lights.truncate(lights);
        scene.objects.truncate(objects);
        // Each sphere once more, of another material: the first is seen.
        let pairs = scene.objects.iter().zip(scene.objects.iter().rev());
        let copies: Vec<_> = pairs.map(|(one, other)| one.with_material(other.material)).collect();
        scene.objects.extend(copies);
        let camera = look_at(&camera_with_size(37, 7), from, DVec3::NEG_Z, roll);
        assert_fast_draws(&camera, samples, &scene);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    // A byte hides the last digits of the number that was rounded to it. These scenes show
    // them: one ray touches its sphere, or its colour is halfway between two bytes.
    #[test]
    fn fast_rounds_like_render(
        from in random_point(), roll in -3.0..3.0, i in 0..37_u32, j in 0..7_u32,
        unit_vector in random_unit_vector(), radius in 0.2..5.0_f64
    ) {
        let camera = look_at(&camera_with_size(37, 7), from, DVec3::NEG_Z, roll);
        let ray = camera.ray(i.into(), j.into());
        let to_centre = 9.0 * ray.direction.normalize() + 0.8 * radius * unit_vector;
        let hit_sphere = Sphere { centre: ray.start + to_centre, radius };
        let radius = to_centre.reject_from(ray.direction).length();
        let tangent_sphere = Sphere { radius, ..hit_sphere };
        let with_sphere = |sphere, ambient_light| {
            let mut scene = Scene { ambient_light, ..named_scene("rounded") };
            scene.objects.truncate(1);
            scene.objects[0].sphere = sphere;
            scene.objects[0].material.matte.ambient = DVec3::ONE;
            scene
        };
        let lit = colour(&with_sphere(hit_sphere, DVec3::ZERO), &ray);
        // The ambient light that is missing up to the middle between two bytes.
        let ambient_light = ((255.0 * lit).floor() + 1.5) / 255.0 - lit;
        for (sphere, light) in [(tangent_sphere, DVec3::ONE), (hit_sphere, ambient_light)] {
            assert_fast_draws(&camera, 1, &with_sphere(sphere, light));
        }
    }
}
