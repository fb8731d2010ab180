//! Draws step 5: the scene in the light of the whole Phong sum.
fn main() {
    step05_phong::draw_and_save(env!("CARGO_PKG_NAME"), step05_phong::picture);
}
