//! Draws step 3: several spheres, each in its own flat colour.
fn main() {
    step03_nearest::draw_and_save(env!("CARGO_PKG_NAME"), step03_nearest::picture);
}
