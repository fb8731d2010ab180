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

/// Scenes, half of which have each sphere a second time, of another material: the first is seen.
fn random_scene() -> impl Strategy<Value = PhongScene> {
    let lights = vec(random_light(), 0..4);
    let parts = (random_objects(), random_colour(), lights, any::<bool>());
    parts.prop_map(|(mut objects, ambient_light, lights, has_duplicates)| {
        if has_duplicates {
            let materials: Vec<_> = objects.iter().rev().map(|object| object.material).collect();
            let spheres = objects.clone().into_iter().zip(materials);
            objects.extend(spheres.map(|(object, material)| object.with_material(material)));
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
