//! Answers about pictures that are ours as a whole: right, with other options, of another name,
//! turned, cut out, of few colours.

use crate::{Answers, draw_step, locked_picture, map_locked};
use course::{Step, camera_with_size};
use image::imageops::{self, FilterType, crop_imm, overlay, resize};
use image::{Rgb, RgbImage};
use step01_rays::Camera;

#[test]
fn right_and_other_pictures_are_as_locked() {
    let mut answers = Answers::new();
    answers.add_picture("right", "step05_phong", draw_step(Step::Phong));
    for (size, fov, samples) in [
        ((320, 180), 60.0_f64, 1),
        ((100, 75), 75.5, 2),
        ((640, 360), 110.0, 1),
        ((640, 360), 60.0, 2),
    ] {
        let picture =
            (Step::Phong.picture())(&Camera::new(size.0, size.1, fov.to_radians()), samples);
        answers.add_picture(&format!("{size:?}, {fov}°, {samples}"), "step05_phong", picture);
    }
    let mut almost = (Step::Phong.picture())(&camera_with_size(64, 36), 1);
    almost.put_pixel(9, 9, Rgb([0; 3]));
    answers.add_picture("other options and one wrong pixel", "step05_phong", almost);
    for (found, expected) in [
        ("step04_diffuse", "step05_phong"),
        ("step03_nearest", "step04_diffuse"),
        ("step01_rays", "step03_nearest"),
        ("step02_sphere", "step03_nearest"),
        ("step05_phong", "step01_rays"),
        ("step04_diffuse", "sun"),
        ("glass", "sun"),
        ("disc", "step02_sphere"),
    ] {
        answers.add_picture(&format!("{found} for {expected}"), expected, locked_picture(found));
    }
    answers.assert_locked("right_and_other_pictures");
}

#[test]
fn turned_cut_and_enlarged_pictures_are_as_locked() {
    let mut answers = Answers::new();
    for name in ["step05_phong", "plane"] {
        let ours = locked_picture(name);
        let mut shot = RgbImage::from_pixel(800, 500, Rgb([220; 3]));
        overlay(&mut shot, &ours, 30, 60);
        for (title, picture) in [
            ("upside down", imageops::flip_vertical(&ours)),
            ("mirrored", imageops::flip_horizontal(&ours)),
            ("half around", imageops::rotate180(&ours)),
            ("a quarter", imageops::rotate90(&ours)),
            ("blue for red", map_locked(name, |_, _, [r, g, b]| [b, g, r])),
            ("grey", map_locked(name, |_, _, [_, g, _]| [g; 3])),
            ("one colour", map_locked(name, |_, _, _| [7, 8, 9])),
            ("black", map_locked(name, |_, _, _| [0; 3])),
            ("cut out", crop_imm(&ours, 100, 150, 300, 200).to_image()),
            ("screenshot", shot),
            ("enlarged", resize(&ours, 1280, 720, FilterType::Nearest)),
            ("made smaller", resize(&ours, 240, 135, FilterType::Triangle)),
            ("mirrored, and one pixel is wrong", {
                let mut picture = imageops::flip_horizontal(&ours);
                picture.put_pixel(9, 9, Rgb([9; 3]));
                picture
            }),
        ] {
            answers.add_picture(&format!("{name}: {title}"), name, picture);
        }
    }
    let mut shot = RgbImage::from_pixel(656, 404, Rgb([90; 3]));
    overlay(&mut shot, &locked_picture("step03_nearest"), 8, 36);
    answers.add_picture("screenshot of a flat picture", "step03_nearest", shot);
    for (name, place) in [("depth", (9, 9)), ("rings", (9, 9))] {
        let mut picture = locked_picture(name);
        picture.put_pixel(place.0, place.1, Rgb([9; 3]));
        answers.add_picture(&format!("{name} with one grey pixel"), name, picture);
    }
    answers.assert_locked("turned_cut_and_enlarged_pictures");
}
