use std::io::Cursor;
use step01_rays::Camera;

fn lock(name: &str, picture: fn(&Camera, u32) -> image::RgbImage) {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    let mut png = Cursor::new(vec![]);
    picture(&camera, 1).write_to(&mut png, image::ImageFormat::Png).unwrap();
    insta::assert_binary_snapshot!(name, png.into_inner());
}

#[test]
fn step01() {
    lock("step01_rays.png", step01_rays::picture);
}

#[test]
fn step02() {
    lock("step02_sphere.png", step02_sphere::picture);
}

#[test]
fn step03() {
    lock("step03_nearest.png", step03_nearest::picture);
}

#[test]
fn step04() {
    lock("step04_diffuse.png", step04_diffuse::picture);
}

#[test]
fn step05() {
    lock("step05_phong.png", step05_phong::picture);
}
