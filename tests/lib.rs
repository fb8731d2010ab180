//! What the tests of the five steps share: locked pictures, programs to run, random
//! input.

mod locked;
mod program;
mod random;
mod refusals;

pub use gallery::Difference;
pub use locked::{assert_locked, locked, target};
pub use program::{Program, folder};
pub use random::{point, rays, sphere, unit};
pub use refusals::assert_refuses_bad_input;

use step01_rays::Camera;

/// The camera of the five pictures: 640×360 pixels, a field of view of 60 degrees.
pub fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}
