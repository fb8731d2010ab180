//! How fast the picture is drawn, at 1920×1080: `cargo bench`.

use divan::{Bencher, counter::ItemsCount};
use glam::DVec3;
use image::{ImageFormat, RgbImage};
use rayon::ThreadPoolBuilder;
use std::io::Cursor;
use step05_phong::*;

fn main() {
    divan::main();
}

/// The locked scene, on one thread and on all (0).
#[divan::bench(args = [1, 0], sample_count = 20)]
fn locked_scene(bencher: Bencher, threads: usize) {
    cast(bencher, threads, &scene());
}

/// Five spheres and one light, on one thread and on all (0).
#[divan::bench(args = [1, 0], sample_count = 20)]
fn five_spheres(bencher: Bencher, threads: usize) {
    cast(bencher, threads, &lit(FIVE.into()));
}

/// As many spheres as told in a cube in front of the camera, on all threads.
#[divan::bench(args = [5, 100, 1000], sample_count = 3)]
fn spheres(bencher: Bencher, count: u32) {
    let place = |k: u32| {
        DVec3::new((k % 10) as f64, (k / 10 % 10) as f64, (k / 100) as f64)
    };
    let sphere = |k: u32| Sphere {
        centre: place(k) - DVec3::new(4.5, 4.5, 18.0),
        radius: 0.4,
    };
    cast(bencher, 0, &lit((0..count).map(sphere).collect()));
}

/// The final picture as PNG bytes.
#[divan::bench(sample_count = 20)]
fn encode(bencher: Bencher) {
    let image = picture(&camera(), 1);
    bencher
        .bench(|| image.write_to(&mut Cursor::new(Vec::new()), ImageFormat::Png));
}

const FIVE: [Sphere; 5] = [
    Sphere { centre: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 },
    Sphere { centre: DVec3::new(-2.0, 0.25, -6.0), radius: 1.0 },
    Sphere { centre: DVec3::new(1.75, -0.5, -4.5), radius: 0.5 },
    Sphere { centre: DVec3::new(0.625, 1.125, -4.0), radius: 0.375 },
    Sphere { centre: DVec3::new(0.0, -21.0, -8.0), radius: 20.0 },
];

/// The spheres, of the materials of the locked scene in turn, in one white light.
fn lit(spheres: Vec<Sphere>) -> Scene<Material, Light> {
    let point = PointLight {
        position: DVec3::new(3.0, 4.0, 0.0),
        diffuse: DVec3::ONE,
        attenuation: Attenuation { a: 1.0, b: 0.0, c: 1.0 / 64.0 },
    };
    let scene = scene();
    let materials = scene.objects.iter().map(|object| object.material).cycle();
    let objects = spheres.into_iter().zip(materials);
    Scene {
        objects: objects
            .map(|(sphere, material)| Object { sphere, material })
            .collect(),
        lights: vec![Light { point, specular: DVec3::ONE }],
        ..scene
    }
}

fn camera() -> Camera {
    Camera::new(1920, 1080, 60_f64.to_radians())
}

fn cast(bencher: Bencher, threads: usize, scene: &Scene<Material, Light>) {
    let pool = ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("a pool of threads");
    let camera = camera();
    bencher.counter(ItemsCount::new(camera.h_res * camera.v_res)).bench(
        || -> RgbImage {
            pool.install(|| render(&camera, 1, |ray| colour(scene, ray)))
        },
    );
}
