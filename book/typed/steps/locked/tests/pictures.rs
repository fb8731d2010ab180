use std::io::Cursor;
use step01_rays::Camera;

fn lock(name: &str, picture: fn(&Camera, u32) -> image::RgbImage) {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    let mut png = Cursor::new(vec![]);
    picture(&camera, 1).write_to(&mut png, image::ImageFormat::Png).unwrap();
    insta::assert_binary_snapshot!(&format!("{name}.png"), png.into_inner());
}

// Step 1
#[test]
fn step01_rays() {
    lock("step01_rays", step01_rays::picture);
}

// Step 2
#[test]
fn step02_sphere() {
    lock("step02_sphere", step02_sphere::picture);
}

// Step 3
#[test]
fn step03_nearest() {
    lock("step03_nearest", step03_nearest::picture);
}

// Step 4
#[test]
fn step04_diffuse() {
    lock("step04_diffuse", step04_diffuse::picture);
}

// Step 5
#[test]
fn step05_phong() {
    lock("step05_phong", step05_phong::picture);
}
