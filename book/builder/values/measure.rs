//! What the values of several chapters share.

use compare::Difference;
use glam::DVec3;
pub use live::{
    camera, discriminant, format_number as number, format_vector as vector,
};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::sync::LazyLock;
use step02_sphere::Sphere;
use step05_phong::{
    Material, Object, Ray, SurfacePoint, colour, direction_colour, nearest,
    picture, reflect, render, scene, specular, visible_point,
};

/// The pixel of the worked examples of light: its column i and its row j.
pub const PIXEL: [u32; 2] = [470, 120];

/// A number that the page tells of a pixel of a picture.
pub fn told(picture: &str, pixel: [u32; 2], which: &str) -> String {
    let live = live::find(picture).expect("a picture that answers");
    let mut values = live.default_values();
    values[..2].copy_from_slice(&pixel.map(f64::from));
    let told = (live.numbers)(&values).remove(which);
    told.unwrap_or_else(|| panic!("{picture} has no {which}"))
}

/// The object that a pixel of the final picture shows.
pub fn object([i, j]: [u32; 2]) -> Object<Material> {
    let (scene, ray) = (scene(), camera().ray(i.into(), j.into()));
    *nearest(&scene.objects, &ray).expect("it shows one").object
}

/// A ray along −z that starts at (x, 0, z).
pub fn ahead(x: f64, z: f64) -> Ray {
    Ray { start: DVec3::new(x, 0.0, z), direction: DVec3::NEG_Z }
}

/// The sum of `number` over all rays of the course's pictures.
pub fn count(number: impl Fn(&Ray) -> usize + Sync) -> usize {
    let camera = camera();
    let of_row = |j: u32| -> usize {
        let rays = (0..camera.h_res).map(|i| camera.ray(i.into(), j.into()));
        rays.map(|ray| number(&ray)).sum()
    };
    (0..camera.v_res).into_par_iter().map(of_row).sum()
}

/// That sum with commas.
pub fn counted(number: impl Fn(&Ray) -> usize + Sync) -> String {
    grouped(count(number) as f64)
}

/// A length on the image plane, in pixels.
pub fn pixels(length: f64) -> f64 {
    length / camera().matrix.x_axis.x
}

/// Both t, with "and" between them.
pub fn both(sphere: &Sphere, ray: &Ray) -> String {
    let roots: Vec<_> = sphere.intersect(ray).iter().map(number).collect();
    roots.join(" and ")
}

/// Without the test of n·l: how many pixels of the final picture change, and by how
/// much at most.
pub static UNGATED: LazyLock<(usize, u8)> = LazyLock::new(|| {
    let scene = scene();
    let wrong = render(&camera(), 1, |ray| {
        let Some(SurfacePoint { p, n, material }) =
            visible_point(&scene.objects, ray)
        else {
            return direction_colour(ray);
        };
        let mut sum = colour(&scene, ray);
        let v = -ray.direction.normalize();
        for light in &scene.lights {
            let (l, d) = light.point_light.direction_from(p);
            if n.dot(l) <= 0.0 {
                sum += specular(reflect(n, l), v, d, material, light);
            }
        }
        sum
    });
    match Difference::between(&picture(&camera(), 1), &wrong) {
        Some(Difference::Pixels { count, largest, .. }) => (count, largest),
        _ => (0, 0),
    }
});

/// A number with one digit after the point.
pub fn tenths(number: f64) -> String {
    format!("{number:.1}")
}

/// A whole number with a comma between thousands.
pub fn grouped(number: f64) -> String {
    let digits = format!("{number:.0}");
    let comma = |at: usize| 0 < at && (digits.len() - at).is_multiple_of(3);
    let digits = digits.char_indices();
    digits
        .map(|(at, c)| format!("{}{c}", if comma(at) { "," } else { "" }))
        .collect()
}

/// An 8-bit colour as (red, green, blue).
pub fn rgb(channels: [u8; 3]) -> String {
    vector(channels.map(f64::from))
}
