//! Draws step 2: one sphere in front of step 1's picture.
fn main() {
    step02_sphere::draw_and_save(env!("CARGO_PKG_NAME"), step02_sphere::picture);
}
