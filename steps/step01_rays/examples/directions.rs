//! The picture of step 1, with one ray per pixel: the colour of each direction.

use image::{ImageResult, RgbImage};
use step01_rays::{Camera, direction_colour, rgb8};

/// The picture, pixel by pixel, from left to right and from top to bottom.
pub fn picture(camera: &Camera) -> RgbImage {
    let pixel = |i, j| rgb8(direction_colour(&camera.ray(i, j)));
    let mut image = RgbImage::new(camera.h_res, camera.v_res);
    for j in 0..camera.v_res {
        for i in 0..camera.h_res {
            image.put_pixel(i, j, pixel(f64::from(i), f64::from(j)));
        }
    }
    image
}

fn main() -> ImageResult<()> {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    picture(&camera).save("step01_rays.png")
}
