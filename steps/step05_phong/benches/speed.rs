//! Measures how fast pictures of 1920×1080 pixels are drawn. `cargo bench` takes
//! about two minutes, and `cargo bench -- fast` measures only `fast`.

use divan::{Bencher, counter::ItemsCount};
use glam::DVec3;
use image::{RgbImage, codecs::png::PngEncoder};
use rayon::ThreadPoolBuilder;
use step05_phong::*;

fn main() {
    divan::main();
}

/// Numbers of spheres in front of the camera. Up to five are placed by hand.
const SIZES: [usize; 8] = [0, 1, 5, 100, 1000, 10_000, 100_000, 1_000_000];

/// Step 5 as it is, for the numbers of spheres that don't take minutes.
#[divan::bench(args = SIZES[..5].iter().copied(), sample_count = 3)]
fn clear(bencher: Bencher, count: usize) {
    measure(bencher, 1, lit(spheres(count)), |camera, scene| {
        render(camera, 1, |ray| colour(scene, ray))
    });
}

/// Step 5's own scene, on one thread and on all threads.
#[divan::bench(args = [1, 0], sample_count = 5)]
fn clear_step05(bencher: Bencher, threads: usize) {
    measure(bencher, threads, scene(), |camera, scene| {
        render(camera, 1, |ray| colour(scene, ray))
    });
}

/// Encodes the final picture as a PNG file.
#[divan::bench(sample_count = 20)]
fn encode(bencher: Bencher) {
    let image = picture(&camera(), 1);
    bencher.bench(|| image.write_with_encoder(PngEncoder::new(&mut vec![])));
}

fn camera() -> Camera {
    Camera::new(1920, 1080, 60_f64.to_radians())
}

/// Measures `draw` on this number of threads, where 0 means all of them.
fn measure(
    bencher: Bencher,
    threads: usize,
    scene: Scene<Material, Light>,
    draw: impl Fn(&Camera, &Scene<Material, Light>) -> RgbImage + Sync,
) {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.expect("a pool of threads");
    let camera = camera();
    bencher
        .counter(ItemsCount::new(camera.h_res * camera.v_res))
        .bench(|| pool.install(|| draw(&camera, &scene)));
}

fn spheres(count: usize) -> Vec<Sphere> {
    let five = [
        Sphere::new([0.0, 0.0, -5.0], 1.0),
        Sphere::new([-2.0, 0.25, -6.0], 1.0),
        Sphere::new([1.75, -0.5, -4.5], 0.5),
        Sphere::new([0.625, 1.125, -4.0], 0.375),
        Sphere::new([0.0, -21.0, -8.0], 20.0),
    ];
    if count <= 5 { five[..count].into() } else { cloud(count, 0.06..0.38) }
}

/// Spheres at random places in a box in front of the camera, with random radii in
/// this range.
fn cloud(count: usize, radius: std::ops::Range<f64>) -> Vec<Sphere> {
    // Numbers that look random: a multiplication and an addition, modulo 2⁶⁴.
    let mut state = 1_u64;
    let mut number = |from: f64, to: f64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1);
        from + (to - from) * ((state >> 11) as f64 / (1_u64 << 53) as f64)
    };
    let mut next = || {
        let centre = [number(-6.0, 6.0), number(-3.5, 3.5), number(-14.0, -6.0)];
        Sphere::new(centre, number(radius.start, radius.end))
    };
    (0..count).map(|_| next()).collect()
}

/// A scene of these spheres, lit by one white light. They take turns with the
/// materials of step 5's scene.
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

/// The example. Its program is dead code here.
#[allow(dead_code)]
#[path = "../examples/fast.rs"]
mod example;

/// `fast`, which draws the same pictures, byte for byte.
#[divan::bench(args = SIZES, sample_count = 9)]
fn fast(bencher: Bencher, count: usize) {
    measure_fast(bencher, 1, lit(spheres(count)));
}

/// Step 5's own scene, on one thread and on all threads.
#[divan::bench(args = [1, 0], sample_count = 9)]
fn fast_step05(bencher: Bencher, threads: usize) {
    measure_fast(bencher, threads, scene());
}

/// A million grains, so small that most rays pass between them and little is
/// hidden.
#[divan::bench(sample_count = 3)]
fn fast_grains(bencher: Bencher) {
    measure_fast(bencher, 1, lit(cloud(1_000_000, 0.002..0.002)));
}

fn measure_fast(bencher: Bencher, threads: usize, scene: Scene<Material, Light>) {
    let level = fearless_simd::Level::new();
    measure(bencher, threads, scene, |camera, scene| {
        example::draw(level, camera, 1, scene)
    });
}
