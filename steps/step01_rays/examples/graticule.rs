//! The graticule: lines of constant longitude and latitude over the sky.

use glam::DVec3;
use image::RgbImage;
use step01_rays::{Camera, Ray, direction_colour, draw_and_save, render};

/// The angle from one line to the next.
const SPACING: f64 = 5_f64.to_radians();

/// How far `angle` is from the nearest multiple of the spacing.
fn from_line(angle: f64) -> f64 {
    (angle - (angle / SPACING).round() * SPACING).abs()
}

/// The colour that `ray` sees: the colour of its direction, under lines that are
/// two pixels wide. `pixel` is the angle that a pixel covers.
fn colour(ray: &Ray, pixel: f64) -> DVec3 {
    let v = ray.direction.normalize();
    let (longitude, latitude) = (v.x.atan2(-v.z), v.y.asin());
    // Meridians meet at the poles, so near them the same angle covers a shorter
    // distance.
    let away = from_line(latitude).min(from_line(longitude) * latitude.cos());
    let covered = (1.5 - away / pixel).clamp(0.0, 1.0);
    direction_colour(ray).lerp(DVec3::ONE, covered)
}

/// The picture: the sky of step 1 with its graticule.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let pixel = camera.matrix.x_axis.length();
    render(camera, samples, |ray| colour(ray, pixel))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
