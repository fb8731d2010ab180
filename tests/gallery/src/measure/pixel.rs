use super::words::vector;
use super::{Terms, hit};
use crate::{Parts, Step, camera};
use image::RgbImage;

/// The pixel that differs most, in full: yours, ours, which object, and each of its
/// terms.
pub fn pixel(yours: &RgbImage, ours: &RgbImage, step: Step) -> String {
    let pairs = yours.enumerate_pixels().zip(ours.pixels());
    let worst = pairs.max_by_key(|((_, _, a), b)| crate::difference::apart(a, b));
    let Some(((i, j, a), b)) = worst else { return String::new() };
    let (width, height) = yours.dimensions();
    let parts = Parts::right(&camera(width.max(2), height));
    let ray = parts.camera.ray(i.into(), j.into());
    let mut text = format!(
        "Column {i}, row {j}: yours is {:?}, ours {:?}. Its V is {}",
        a.0,
        b.0,
        vector(ray.direction)
    );
    let object = hit(&parts, step, i.into(), j.into());
    text += &match object.map(|k| parts.objects(step)[k].material.name) {
        None => ", and it sees the sky.".to_owned(),
        Some(name) => format!(", and it sees {name}."),
    };
    let terms =
        Terms::of(&parts, step, &ray, &[]).filter(|_| Step::Diffuse <= step);
    if let Some(Terms { parts: [a, d, s, e, t], .. }) = terms {
        text +=
            &format!(" I_a is {}; the warm light's I_d {}", vector(a), vector(d));
        text += &format!(", the cool light's {}", vector(e));
        if step == Step::Phong {
            text += &format!("; their I_s {} and {}", vector(s), vector(t));
        }
        text += &format!("; together {}.", vector(a + d + s + e + t));
    }
    text
}
