//! `fast` draws the same bytes as `render` with `colour`.

use super::fast::draw;
use course::examples::look_at::look_at;
use course::{camera_with_size, named_scene};
use fearless_simd::Level;
use glam::DVec3;
use std::env;
use step05_phong::*;
use tests::{RandomInputs, test_law};

/// Fails unless `fast` draws the bytes of `render`, with the fewest and with the most instructions.
fn assert_fast_draws(camera: &Camera, samples: u32, scene: &Scene<Material, Light>) {
    let expected = render(camera, samples, |ray| colour(scene, ray));
    for level in [Level::baseline(), Level::new()] {
        assert!(draw(level, camera, samples, scene) == expected, "other bytes with {level:?}");
    }
}

#[test]
fn fast_draws_the_bytes_of_render_for_parts_of_random_scenes() {
    test_law(if env::var_os("THOROUGH").is_some() { 250 } else { 50 }, |random| {
        let mut scene = named_scene(&random.index(10_000).to_string());
        scene.lights.truncate(random.index(3));
        scene.objects.truncate(random.index(10));
        // Each sphere once more, of another material: the first is seen.
        let pairs = scene.objects.iter().zip(scene.objects.iter().rev());
        let copies: Vec<_> = pairs.map(|(one, other)| one.with_material(other.material)).collect();
        scene.objects.extend(copies);
        assert_fast_draws(&small_camera(random), 1 + random.index(3) as u32, &scene);
    });
}

// A byte hides the last digits of the number that was rounded to it. These scenes show
// them: one ray touches its sphere, or its colour is halfway between two bytes.
#[test]
fn fast_rounds_like_render() {
    test_law(400, |random| {
        let camera = small_camera(random);
        let ray = camera.ray(random.index(37) as f64, random.index(7) as f64);
        let offset = 0.8 * random.number(0.2, 5.0) * random.unit_vector();
        let to_centre = 9.0 * ray.direction.normalize() + offset;
        let hit_sphere = Sphere { centre: ray.start + to_centre, radius: offset.length() / 0.8 };
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
    });
}

/// A camera anywhere, of few pixels.
fn small_camera(random: &mut RandomInputs) -> Camera {
    let roll = random.number(-3.0, 3.0);
    look_at(&camera_with_size(37, 7), random.point(), DVec3::NEG_Z, roll)
}
