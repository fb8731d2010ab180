//! `fast` draws, to the byte, what `render` draws with `colour`.

use exercises::fast::draw;
use fearless_simd::Level;
use glam::{DMat3, DVec3};
use proptest::{collection::vec, prelude::*};
use step05_phong::*;
use tests::{is_thorough, point, sphere, unit};

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
        surface: Surface { ambient, diffuse },
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
    vec(object.prop_map(|(sphere, material)| Object { sphere, material }), 0..25)
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
    #![proptest_config(ProptestConfig::with_cases(if is_thorough() { 256 } else { 50 }))]

    #[test]
    fn it_draws_any_scene_at_any_size(
        camera in cameras(), scene in scenes(), samples in 1..4_u32
    ) {
        prop_assert_eq!(difference(&camera, samples, &scene), None);
    }
}

// A byte hides the last digits of what it was rounded from. So balance scenes on them:
// whatever rounds otherwise tips over.

/// A small camera, one of its rays, and a sphere which that ray meets.
fn aimed() -> impl Strategy<Value = (Camera, Ray, Sphere, SurfacePoint<'static, ()>)>
{
    let parts = (cameras(), 0.0..1.0_f64, 0.0..1.0_f64, unit(), 0.2..5.0_f64);
    parts.prop_filter_map("missed", |(camera, x, y, off, radius)| {
        let column = (x * f64::from(camera.h_res - 1)).round();
        let row = (y * f64::from(camera.v_res - 1)).round();
        let ray = camera.ray(column, row);
        let centre = ray.at(9.0 / ray.direction.length()) + 0.8 * radius * off;
        let sphere = Sphere { centre, radius };
        let object = [Object { sphere, material: () }];
        let SurfacePoint { p, n, .. } = visible_point(&object, &ray)?;
        Some((camera, ray, sphere, SurfacePoint { p, n, material: &() }))
    })
}

/// How many of `count` scenes, each of which one ray of one camera balances, are drawn
/// otherwise.
fn tipped(scene: impl Fn(&Ray, &Sphere, &SurfacePoint<()>) -> Lit) -> usize {
    use proptest::{strategy::ValueTree, test_runner::TestRunner};
    let mut runner = TestRunner::deterministic();
    let mut tipped = 0;
    for _ in 0..300 {
        let tree = aimed().new_tree(&mut runner).expect("rays that meet spheres");
        let (camera, ray, sphere, point) = tree.current();
        let scene = scene(&ray, &sphere, &point);
        tipped += usize::from(difference(&camera, 1, &scene).is_some());
    }
    tipped
}

fn polished(ambient: DVec3) -> Material {
    let diffuse = DVec3::new(0.3, 0.4, 0.35);
    let surface = Surface { ambient, diffuse };
    Material { surface, specular: DVec3::new(0.5, 0.6, 0.55), shininess: 13 }
}

fn lit(spheres: &[Sphere], lights: Vec<Light>) -> Lit {
    let material = |k: usize| polished(DVec3::splat([0.1, 0.9][k % 2]));
    let object = |(k, &sphere)| Object { sphere, material: material(k) };
    let objects = spheres.iter().enumerate().map(object).collect();
    Scene { objects, ambient_light: DVec3::ONE, lights }
}

fn lamp(position: DVec3) -> Light {
    let attenuation = Attenuation { a: 0.9, b: 0.01, c: 0.003 };
    let point_light =
        PointLight { position, diffuse: DVec3::splat(0.7), attenuation };
    Light { point_light, specular: DVec3::splat(0.8) }
}

#[test]
fn a_ray_that_touches_a_sphere_meets_it_or_misses_it_as_before() {
    let touched = |ray: &Ray, sphere: &Sphere, _: &SurfacePoint<()>| {
        let v = ray.direction.normalize();
        let to_centre = sphere.centre - ray.start;
        let radius = (to_centre - to_centre.dot(v) * v).length();
        lit(&[Sphere { radius, ..*sphere }], vec![])
    };
    assert_eq!(tipped(touched), 0);
}

#[test]
fn of_two_spheres_that_share_a_point_the_same_one_is_seen() {
    let nested = |_: &Ray, sphere: &Sphere, point: &SurfacePoint<()>| {
        let inner = Sphere {
            centre: point.p + 0.7 * (sphere.centre - point.p),
            radius: 0.7 * sphere.radius,
        };
        lit(&[*sphere, inner], vec![])
    };
    assert_eq!(tipped(nested), 0);
}

#[test]
fn a_light_at_the_horizon_shines_or_not_as_before() {
    let horizon = |ray: &Ray, sphere: &Sphere, point: &SurfacePoint<()>| {
        let along =
            (ray.direction - ray.direction.dot(point.n) * point.n).normalize();
        lit(&[*sphere], vec![lamp(point.p + 3.0 * along)])
    };
    assert_eq!(tipped(horizon), 0);
}

#[test]
fn a_colour_between_two_bytes_becomes_the_same_one() {
    let between = |ray: &Ray, sphere: &Sphere, point: &SurfacePoint<()>| {
        let lamps = vec![lamp(point.p + 4.0 * point.n - ray.direction)];
        let mut scene = lit(&[*sphere], lamps);
        scene.objects[0].material = polished(DVec3::ZERO);
        let rest = colour(&scene, ray);
        // The ambient term adds up to the next half of a byte.
        let half = ((255.0 * rest).floor() + 1.5) / 255.0;
        scene.objects[0].material = polished(half - rest);
        scene
    };
    assert_eq!(tipped(between), 0);
}
