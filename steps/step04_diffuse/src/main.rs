//! Draws step 4: the scene in ambient and diffuse light.
fn main() {
    step04_diffuse::draw_and_save(env!("CARGO_PKG_NAME"), step04_diffuse::picture);
}
