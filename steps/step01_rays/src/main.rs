//! Draws step 1: each ray's direction as a colour.
fn main() {
    step01_rays::run(env!("CARGO_PKG_NAME"), step01_rays::picture);
}
