//! The pictures that answer, each drawn by its step.

mod step01;

pub use step01::STEP01;

use crate::Sight;
use glam::DVec3;
use step01_rays::{Camera, Ray, render};

/// What `camera` sees, one ray a pixel.
fn picture(camera: &Camera, colour: impl Fn(&Ray) -> DVec3 + Sync) -> Sight {
    let image = render(camera, 1, colour);
    let pixels = image.pixels().flat_map(|p| [p[0], p[1], p[2], 255]).collect();
    Sight::Picture { size: image.dimensions().into(), pixels }
}
