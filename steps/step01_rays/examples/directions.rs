//! The picture of step 1, with one ray per pixel: the colour of each direction.

use image::ImageResult;
use step01_rays::{Camera, direction_colour, draw_pixels, rgb8};

fn main() -> ImageResult<()> {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    let pixel = |i, j| rgb8(direction_colour(&camera.ray(i, j)));
    draw_pixels(&camera, &pixel).save("step01_rays.png")
}
