//! Draws step 5: the scene in the light of the whole Phong sum.
fn main() {
    step05_phong::run(env!("CARGO_PKG_NAME"), step05_phong::picture);
}
