//! The picture on the cover: that of step 5, larger and smoother.

use step05_phong::{Camera, picture};
use tests::assert_locked;

#[test]
fn the_cover_is_locked() {
    let camera = Camera::new(1280, 720, 60_f64.to_radians());
    assert_locked("cover", &picture(&camera, 4));
}
