//! `fast` draws, to the byte, what `render` draws with `colour`.

use exercises::fast::draw;
use fearless_simd::Level;
use glam::{DMat3, DVec3};
use proptest::{collection::vec, prelude::*};
use step05_phong::*;
use tests::{point, sphere, unit};

/// The sets of instructions that this machine has.
fn levels() -> Vec<Level> {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        let level = Level::new();
        let better = [
            level.as_sse2().map(Level::Sse2),
            level.as_sse4_2().map(Level::Sse4_2),
            level.as_avx2().map(Level::Avx2),
            level.as_avx512().map(Level::Avx512),
        ];
        better.into_iter().flatten().collect()
    }
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    vec![Level::new()]
}

type Lit = Scene<Material, Light>;

/// The first level at which `fast` draws something else, and how many bytes differ.
fn difference(camera: &Camera, samples: u32, scene: &Lit) -> Option<String> {
    let clear = render(camera, samples, |ray| colour(scene, ray));
    levels().into_iter().find_map(|level| {
        let fast = draw(level, camera, samples, scene);
        let bytes = clear.iter().zip(fast.iter());
        let wrong = bytes.filter(|(one, other)| one != other).count();
        (wrong != 0).then(|| format!("{level:?}: {wrong} bytes of {}", clear.len()))
    })
}

/// A camera anywhere, that looks anywhere.
fn cameras() -> impl Strategy<Value = Camera> {
    let parts = (2..40_u32, 1..7_u32, 10.0..170_f64, point(), unit(), 0.0..6.0_f64);
    parts.prop_map(|(h_res, v_res, field, centre, axis, angle)| {
        let camera = Camera::new(h_res, v_res, field.to_radians());
        let turned = DMat3::from_axis_angle(axis, angle) * camera.matrix;
        Camera { centre, matrix: turned, ..camera }
    })
}

fn colours() -> impl Strategy<Value = DVec3> {
    let grey = (0.0..1.0).prop_map(DVec3::splat);
    prop_oneof![grey, unit().prop_map(DVec3::abs), Just(DVec3::ZERO)]
}

fn materials() -> impl Strategy<Value = Material> {
    let parts = (colours(), colours(), colours(), 1..400);
    parts.prop_map(|(ambient, diffuse, specular, shininess)| Material {
        matte: Matte { ambient, diffuse },
        specular,
        shininess,
    })
}

fn lights() -> impl Strategy<Value = Light> {
    let parts = (point(), colours(), colours(), 0.01..1.0, 0.0..0.5, 0.0..0.1);
    parts.prop_map(|(position, diffuse, specular, a, b, c)| {
        let attenuation = Attenuation { a, b, c };
        Light {
            point_light: PointLight { position, diffuse, attenuation },
            specular,
        }
    })
}

fn objects() -> impl Strategy<Value = Vec<Object<Material>>> {
    let large = sphere();
    let small =
        (point(), 1e-3..0.1).prop_map(|(centre, radius)| Sphere { centre, radius });
    let vast = (unit(), 50.0..1e3_f64)
        .prop_map(|(n, radius)| Sphere { centre: (radius + 1.0) * n, radius });
    let spheres = prop_oneof![4 => large, 2 => small, 1 => vast];
    let object = (spheres, materials());
    vec(
        object.prop_map(|(sphere, material)| Object {
            name: "ball",
            sphere,
            material,
        }),
        0..25,
    )
}

fn scenes() -> impl Strategy<Value = Lit> {
    let parts = (objects(), colours(), vec(lights(), 0..4), any::<bool>());
    parts.prop_map(|(mut objects, ambient_light, lights, twice)| {
        if twice {
            // Each again in the same place, of another material: the first one counts.
            let mut again = objects.clone();
            let count = again.len();
            for (k, object) in again.iter_mut().enumerate() {
                object.material = objects[count - 1 - k].material;
            }
            objects.extend(again);
        }
        Scene { objects, ambient_light, lights }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(50))]

    #[test]
    fn it_draws_any_scene_at_any_size(
        camera in cameras(), scene in scenes(), samples in 1..4_u32
    ) {
        prop_assert_eq!(difference(&camera, samples, &scene), None);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    #[ignore = "takes a minute: cargo test -- --include-ignored"]
    fn it_draws_many_scenes_at_any_size(
        camera in cameras(), scene in scenes(), samples in 1..4_u32
    ) {
        prop_assert_eq!(difference(&camera, samples, &scene), None);
    }
}

// A byte hides the last digits of what it was rounded from. So balance scenes on them:
// whatever rounds otherwise tips over.

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn it_rounds_as_before(
        camera in cameras(), u in 0.0..1.0_f64, v in 0.0..1.0_f64, off in unit(), radius in 0.2..5.0_f64
    ) {
        let last = [camera.h_res, camera.v_res].map(|count| f64::from(count - 1));
        let ray = camera.ray((u * last[0]).round(), (v * last[1]).round());
        let to_centre = 9.0 * ray.direction.normalize() + 0.8 * radius * off;
        let met = Sphere { centre: ray.start + to_centre, radius };
        // A second one, which the ray touches.
        let radius = to_centre.reject_from(ray.direction).length();
        let touched = Sphere { radius, ..met };
        let object = [Object { name: "ball", sphere: met, material: () }];
        let Some(point) = visible_point(&object, &ray) else { return Ok(()) };
        let light = lamp(point.p + 4.0 * point.n - ray.direction);
        let scene = |sphere, ambient_light| {
            let objects = vec![Object { name: "ball", sphere, material: BRIGHT }];
            Scene { objects, ambient_light, lights: vec![light] }
        };
        let rest = colour(&scene(met, DVec3::ZERO), &ray);
        // The ambient term adds up to the next half of a byte.
        let half = ((255.0 * rest).floor() + 1.5) / 255.0 - rest;
        for scene in [scene(touched, DVec3::ONE), scene(met, half)] {
            prop_assert_eq!(difference(&camera, 1, &scene), None);
        }
    }
}

/// What leaves no zero anywhere, and reflects all ambient light.
const BRIGHT: Material = Material {
    matte: Matte { ambient: DVec3::ONE, diffuse: DVec3::new(0.3, 0.4, 0.35) },
    specular: DVec3::new(0.5, 0.6, 0.55),
    shininess: 13,
};

fn lamp(position: DVec3) -> Light {
    let attenuation = Attenuation { a: 0.9, b: 0.01, c: 0.003 };
    let diffuse = DVec3::splat(0.7);
    let point_light = PointLight { position, diffuse, attenuation };
    Light { point_light, specular: DVec3::splat(0.8) }
}
