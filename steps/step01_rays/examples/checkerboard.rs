//! A checkered floor to the horizon, with one ray per pixel.

use glam::DVec3;
use image::{ImageResult, RgbImage};
use step01_rays::{Camera, Ray, direction_colour, draw_pixels, rgb8};

/// The colour that `ray` sees: a tile of the floor, 1.5 below the eye, or the sky.
pub fn colour(ray: &Ray) -> DVec3 {
    let v = ray.direction;
    if v.y >= 0.0 {
        return direction_colour(ray);
    }
    let p = ray.at(-1.5 / v.y);
    let is_even = (p.x.floor() + p.z.floor()) % 2.0 == 0.0;
    if is_even {
        DVec3::new(0.98, 0.95, 0.88)
    } else {
        DVec3::new(0.16, 0.30, 0.36)
    }
}

/// The picture: the colour of the ray through the centre of each pixel.
pub fn picture(camera: &Camera) -> RgbImage {
    draw_pixels(camera, |i, j| rgb8(colour(&camera.ray(i, j))))
}

fn main() -> ImageResult<()> {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    picture(&camera).save("checkerboard.png")
}
