//! What the tests of the five steps share: locked pictures, programs to run, random
//! input.

mod locked;
mod program;
mod random;
mod refusals;

pub use locked::{Locking, here, locked, target};
pub use program::{Program, assert_program};
pub use random::{point, rays, sphere, unit};

use std::env;
use step01_rays::Camera;

/// Whether all cases of long lists are tried, as before a change lands: THOROUGH is set.
pub fn is_thorough() -> bool {
    env::var_os("THOROUGH").is_some()
}

/// The camera of the five pictures: 640×360 pixels, a field of view of 60 degrees.
pub fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}
