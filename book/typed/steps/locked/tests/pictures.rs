use std::io::Cursor;
use step01_rays::Camera;

fn lock(name: &str, picture: fn(&Camera, u32) -> image::RgbImage) {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    let mut png = Cursor::new(vec![]);
    picture(&camera, 1).write_to(&mut png, image::ImageFormat::Png).unwrap();
    insta::assert_binary_snapshot!(&format!("{name}.png"), png.into_inner());
}

macro_rules! lock {
    ($step:ident) => {
        #[test]
        fn $step() {
            lock(stringify!($step), $step::picture);
        }
    };
}

lock!(step01_rays);
lock!(step02_sphere);
lock!(step03_nearest);
lock!(step04_diffuse);
lock!(step05_phong);
