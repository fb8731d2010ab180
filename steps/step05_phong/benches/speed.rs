//! How fast the picture is drawn, at 1920×1080: `cargo bench`.

use divan::{Bencher, counter::ItemsCount};
use glam::DVec3;
use image::{RgbImage, codecs::png::PngEncoder};
use rayon::ThreadPoolBuilder;
use step05_phong::*;

fn main() {
    divan::main();
}

/// A scene by its name, and the number of threads; 0 is all that there are.
type Case = (&'static str, usize);

const CASES: [Case; 8] = [
    ("locked scene", 1),
    ("locked scene", 0),
    ("5 spheres", 1),
    ("5 spheres", 0),
    ("100 spheres", 1),
    ("100 spheres", 0),
    ("1000 spheres", 1),
    ("1000 spheres", 0),
];

/// Step 5 as it is.
#[divan::bench(args = CASES, sample_count = 5)]
fn clear(bencher: Bencher, case: Case) {
    let draw = |camera: &Camera, scene: &Scene<Material, Light>| {
        render(camera, 1, |ray| colour(scene, ray))
    };
    measure(bencher, case, draw);
}

/// The final picture as PNG bytes.
#[divan::bench(sample_count = 20)]
fn encode(bencher: Bencher) {
    let image = picture(&camera(), 1);
    bencher.bench(|| image.write_with_encoder(PngEncoder::new(&mut vec![])));
}

fn camera() -> Camera {
    Camera::new(1920, 1080, 60_f64.to_radians())
}

fn measure(
    bencher: Bencher,
    (name, threads): Case,
    draw: impl Fn(&Camera, &Scene<Material, Light>) -> RgbImage + Sync,
) {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.expect("a pool of threads");
    let camera = camera();
    let scene = match name {
        "locked scene" => scene(),
        "5 spheres" => lit(FIVE.into()),
        "100 spheres" => lit(cube(100)),
        _ => lit(cube(1000)),
    };
    bencher
        .counter(ItemsCount::new(camera.h_res * camera.v_res))
        .bench(|| pool.install(|| draw(&camera, &scene)));
}

const FIVE: [Sphere; 5] = [
    Sphere { centre: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 },
    Sphere { centre: DVec3::new(-2.0, 0.25, -6.0), radius: 1.0 },
    Sphere { centre: DVec3::new(1.75, -0.5, -4.5), radius: 0.5 },
    Sphere { centre: DVec3::new(0.625, 1.125, -4.0), radius: 0.375 },
    Sphere { centre: DVec3::new(0.0, -21.0, -8.0), radius: 20.0 },
];

/// This number of spheres, ten in a row and ten rows in a square, in front of the
/// camera.
fn cube(count: u32) -> Vec<Sphere> {
    let place = |k: u32| {
        DVec3::new((k % 10) as f64, (k / 10 % 10) as f64, (k / 100) as f64)
    };
    let sphere = |k: u32| Sphere {
        centre: place(k) - DVec3::new(4.5, 4.5, 18.0),
        radius: 0.4,
    };
    (0..count).map(sphere).collect()
}

/// The spheres, of the materials of the locked scene in turn, in one white light.
fn lit(spheres: Vec<Sphere>) -> Scene<Material, Light> {
    let point_light = PointLight {
        position: DVec3::new(3.0, 4.0, 0.0),
        diffuse: DVec3::ONE,
        attenuation: Attenuation { a: 1.0, b: 0.0, c: 1.0 / 64.0 },
    };
    let scene = scene();
    let materials = scene.objects.iter().map(|object| object.material).cycle();
    let objects = spheres.into_iter().zip(materials);
    let ball = |(sphere, material)| Object { name: "ball", sphere, material };
    Scene {
        objects: objects.map(ball).collect(),
        lights: vec![Light { point_light, specular: DVec3::ONE }],
        ..scene
    }
}

/// The example, of which the benchmark needs no program.
#[allow(dead_code)]
#[path = "../examples/fast.rs"]
mod example;

/// The same pictures, to the byte.
#[divan::bench(args = CASES, sample_count = 5)]
fn fast(bencher: Bencher, case: Case) {
    let level = fearless_simd::Level::new();
    measure(bencher, case, |camera, scene| example::draw(level, camera, 1, scene));
}
