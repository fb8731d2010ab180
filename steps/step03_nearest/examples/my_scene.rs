//! A scene of your own: it begins as a snowman, in flat colours.

use glam::DVec3;
use image::RgbImage;
use step03_nearest::{Camera, Object, Sphere, colour, draw_and_save, render};

/// A ball in one flat colour.
pub fn ball(
    name: &'static str,
    centre: [f64; 3],
    radius: f64,
    colour: [f64; 3],
) -> Object<DVec3> {
    let sphere = Sphere::new(centre, radius);
    Object { name, sphere, material: colour.into() }
}

/// The objects: a ground of snow, and a snowman on it.
pub fn objects() -> Vec<Object<DVec3>> {
    let (coal, wool) = ([0.22, 0.20, 0.27], [0.91, 0.34, 0.28]);
    let mut objects = vec![
        ball("ground", [0.0, -41.5, -8.0], 40.0, [0.87, 0.89, 0.96]),
        ball("belly", [0.0, -0.75, -7.0], 0.95, [0.94, 0.95, 0.99]),
        ball("chest", [0.0, 0.55, -7.0], 0.65, [0.97, 0.98, 1.00]),
        ball("head", [0.0, 1.40, -7.0], 0.44, [1.00, 1.00, 1.00]),
        ball("cap", [0.0, 1.62, -7.1], 0.42, wool),
        ball("bobble", [0.0, 2.05, -7.1], 0.14, [0.99, 0.76, 0.32]),
        ball("right eye", [-0.12, 1.46, -6.57], 0.05, coal),
        ball("left eye", [0.16, 1.46, -6.57], 0.05, coal),
    ];
    // Three buttons, one above the other.
    let button = |y| ball("button", [0.0, y, -6.37], 0.06, coal);
    objects.extend([0.3, 0.55, 0.8].map(button));
    // A nose of nine balls, each smaller than the last and further out.
    objects.extend((0..9).map(|k| {
        let along = f64::from(k) / 8.0;
        let centre = [0.02 + 0.5 * along, 1.33 - 0.08 * along, -6.54];
        ball("carrot", centre, 0.1 - 0.08 * along, [0.96, 0.55, 0.20])
    }));
    objects
}

/// The picture: your objects, each in its flat colour.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let objects = objects();
    render(camera, samples, |ray| colour(&objects, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
