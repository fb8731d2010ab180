//! A first sphere: red wherever its equation has a root.

use glam::DVec3;
use image::{ImageResult, RgbImage};
use step02_sphere::{Camera, Roots, Sphere, direction_colour, render};

/// The picture: red, or the colour of the direction.
pub fn picture(camera: &Camera) -> RgbImage {
    let sphere = Sphere::new([0.0, 0.0, 5.0], 1.0);
    render(camera, 1, |ray| match sphere.intersect(ray) {
        Roots::Zero => direction_colour(ray),
        Roots::One(_) | Roots::Two(..) => DVec3::new(0.91, 0.34, 0.28),
    })
}

fn main() -> ImageResult<()> {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    picture(&camera).save("disc.png")
}
