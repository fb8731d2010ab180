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

/// Of a long list, one case of `share`, beginning with the first: so `cargo test` is over
/// soon. All of them where it is thorough.
pub fn some<T>(
    cases: impl IntoIterator<Item = T>,
    share: usize,
) -> impl Iterator<Item = T> {
    cases.into_iter().step_by(if is_thorough() { 1 } else { share })
}

/// The camera of the five pictures: 640×360 pixels, a field of view of 60 degrees.
pub fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}
