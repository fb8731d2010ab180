//! `fast` draws the same bytes as `render` with `colour`.

use super::fast_example::draw;
use fearless_simd::Level;
use glam::{DMat3, DVec3};
use proptest::{collection::vec, prelude::*};
use std::env;
use step05_phong::*;
use tests::{random_point, random_sphere, random_unit_vector};

/// The instruction sets of this machine, from old to new.
fn instruction_sets() -> Vec<Level> {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        let level = Level::new();
        let levels = [
            level.as_sse2().map(Level::Sse2),
            level.as_sse4_2().map(Level::Sse4_2),
            level.as_avx2().map(Level::Avx2),
            level.as_avx512().map(Level::Avx512),
        ];
        levels.into_iter().flatten().collect()
    }
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    vec![Level::new()]
}

type PhongScene = Scene<Material, Light>;

/// The first instruction set with which `fast` draws other bytes than `render`, and how
/// many; None if all bytes agree.
fn fast_difference(camera: &Camera, samples: u32, scene: &PhongScene) -> Option<String> {
    let expected = render(camera, samples, |ray| colour(scene, ray));
    instruction_sets().into_iter().find_map(|level| {
        let picture = draw(level, camera, samples, scene);
        let bytes = picture.iter().zip(expected.iter());
        let wrong_count = bytes.filter(|(byte, expected)| byte != expected).count();
        (wrong_count != 0).then(|| format!("{level:?}: {wrong_count} bytes of {}", expected.len()))
    })
}

/// Small cameras of any position and orientation.
fn random_camera() -> impl Strategy<Value = Camera> {
    let centre_axis_angle = (random_point(), random_unit_vector(), 0.0..6.0_f64);
    (2..40_u32, 1..7_u32, 10.0..170_f64, centre_axis_angle).prop_map(
        |(h_res, v_res, degrees, (centre, axis, angle))| {
            let camera = Camera::new(h_res, v_res, degrees.to_radians());
            let matrix = DMat3::from_axis_angle(axis, angle) * camera.matrix;
            Camera { centre, matrix, ..camera }
        },
    )
}

/// Greys, saturated colours, and black.
fn random_colour() -> impl Strategy<Value = DVec3> {
    let grey = (0.0..1.0).prop_map(DVec3::splat);
    prop_oneof![grey, random_unit_vector().prop_map(DVec3::abs), Just(DVec3::ZERO)]
}

fn random_material() -> impl Strategy<Value = Material> {
    let parts = (random_colour(), random_colour(), random_colour(), 1..400);
    parts.prop_map(|(ambient, diffuse, specular, shininess)| Material {
        matte: Matte { ambient, diffuse },
        specular,
        shininess,
    })
}

fn random_light() -> impl Strategy<Value = Light> {
    let attenuation = (0.01..1.0, 0.0..0.5, 0.0..0.1).prop_map(|(a, b, c)| Attenuation { a, b, c });
    let parts = (random_point(), random_colour(), random_colour(), attenuation);
    parts.prop_map(|(position, diffuse, specular, attenuation)| Light {
        point_light: PointLight { position, diffuse, attenuation },
        specular,
    })
}

/// Up to 24 spheres, some tiny, some as large as a ground.
fn random_objects() -> impl Strategy<Value = Vec<Object<Material>>> {
    let tiny_sphere =
        (random_point(), 1e-3..0.1).prop_map(|(centre, radius)| Sphere { centre, radius });
    let ground = (random_unit_vector(), 50.0..1e3_f64)
        .prop_map(|(n, radius)| Sphere { centre: (radius + 1.0) * n, radius });
    let sphere = prop_oneof![4 => random_sphere(), 2 => tiny_sphere, 1 => ground];
    let object = (sphere, random_material()).prop_map(|(sphere, material)| Object {
        name: "ball",
        sphere,
        material,
    });
    vec(object, 0..25)
}

fn random_scene() -> impl Strategy<Value = PhongScene> {
    let lights = vec(random_light(), 0..4);
    let parts = (random_objects(), random_colour(), lights, any::<bool>());
    parts.prop_map(|(mut objects, ambient_light, lights, has_duplicates)| {
        if has_duplicates {
            // Each sphere a second time, of another material: the first one is seen.
            let mut duplicates = objects.clone();
            let materials = objects.iter().rev().map(|object| object.material);
            for (object, material) in duplicates.iter_mut().zip(materials) {
                object.material = material;
            }
            objects.extend(duplicates);
        }
        Scene { objects, ambient_light, lights }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(match env::var_os("THOROUGH") {
        Some(_) => 250,
        None => 50,
    }))]

    #[test]
    fn fast_draws_the_bytes_of_render_for_random_scenes(
        camera in random_camera(), scene in random_scene(), samples in 1..4_u32
    ) {
        prop_assert_eq!(fast_difference(&camera, samples, &scene), None);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    // A byte hides the last digits of the number that was rounded to it. These scenes show
    // them: one ray touches its sphere, or its colour is halfway between two bytes.
    #[test]
    fn fast_rounds_like_render(
        camera in random_camera(), x in 0.0..1.0_f64, y in 0.0..1.0_f64,
        unit_vector in random_unit_vector(), radius in 0.2..5.0_f64
    ) {
        let [i_max, j_max] = [camera.h_res, camera.v_res].map(|count| f64::from(count - 1));
        let ray = camera.ray((x * i_max).round(), (y * j_max).round());
        let to_centre = 9.0 * ray.direction.normalize() + 0.8 * radius * unit_vector;
        let hit_sphere = Sphere { centre: ray.start + to_centre, radius };
        let radius = to_centre.reject_from(ray.direction).length();
        let tangent_sphere = Sphere { radius, ..hit_sphere };
        let object = [Object { name: "ball", sphere: hit_sphere, material: () }];
        let Some(point) = visible_point(&object, &ray) else { return Ok(()) };
        let light = light_at(point.p + 4.0 * point.n - ray.direction);
        let scene = |sphere, ambient_light| {
            let objects = vec![Object { name: "ball", sphere, material: MATERIAL }];
            Scene { objects, ambient_light, lights: vec![light] }
        };
        let lit = colour(&scene(hit_sphere, DVec3::ZERO), &ray);
        // The ambient light that is missing up to the middle between two bytes.
        let ambient_light = ((255.0 * lit).floor() + 1.5) / 255.0 - lit;
        for scene in [scene(tangent_sphere, DVec3::ONE), scene(hit_sphere, ambient_light)] {
            prop_assert_eq!(fast_difference(&camera, 1, &scene), None);
        }
    }
}

/// A material that reflects all ambient light, and a part of the other light.
const MATERIAL: Material = Material {
    matte: Matte { ambient: DVec3::ONE, diffuse: DVec3::new(0.3, 0.4, 0.35) },
    specular: DVec3::new(0.5, 0.6, 0.55),
    shininess: 13,
};

fn light_at(position: DVec3) -> Light {
    let attenuation = Attenuation { a: 0.9, b: 0.01, c: 0.003 };
    let diffuse = DVec3::splat(0.7);
    let point_light = PointLight { position, diffuse, attenuation };
    Light { point_light, specular: DVec3::splat(0.8) }
}
