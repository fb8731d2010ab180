//! The picture of step 1, without the program around it.

use image::ImageResult;
use step01_rays::{Camera, picture};

fn main() -> ImageResult<()> {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    picture(&camera, 1).save("step01_rays.png")
}
