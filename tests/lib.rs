//! What the tests of the five steps share: locked pictures, programs to run, random
//! input.

// The gallery has the same files, and would be built anew for every mutant.
#[path = "gallery/src/difference.rs"]
mod difference;
#[path = "gallery/src/label.rs"]
mod label;
mod locked;
#[path = "gallery/src/panels.rs"]
mod panels;
mod program;
mod random;
mod refusals;

pub use difference::Difference;
use difference::apart;
pub use locked::{assert_locked, here, locked, target};
pub use program::{Program, assert_program};
pub use random::{point, rays, sphere, unit};

use step01_rays::Camera;

/// The camera of the five pictures: 640×360 pixels, a field of view of 60 degrees.
pub fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}
