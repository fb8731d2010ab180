//! Draws step 1: each ray's direction as a colour.
fn main() {
    step01_rays::draw_and_save(env!("CARGO_PKG_NAME"), step01_rays::picture);
}
