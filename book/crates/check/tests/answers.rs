//! What is said of pictures, by the lines of an answer.

use crate::{
    PhongScene, assert_answer_contains, draw_changed_step05, locked, locked_picture,
    text_of_wrong_picture,
};
use check::check_picture;
use course::{Step, camera_with_size};
use glam::DVec3;
use image::imageops::{self, FilterType, crop_imm, overlay, resize};
use image::{Rgb, RgbImage};
use step01_rays::{Camera, render};

type Change<'a> = &'a dyn Fn(&mut PhongScene);

#[test]
fn right_picture_gets_code_0_or_its_true_name() {
    for one in locked() {
        let answer = check_picture(&one.picture, Some(&one.name), locked());
        assert_eq!(answer.code, 0, "{}", answer.text);
    }
    assert_answer_contains(
        &locked_picture("glass"),
        "sun",
        &["this is the picture of glass, not of sun"],
    );
}

#[test]
fn picture_with_other_options_names_them() {
    for (size, fov, samples) in
        [((320, 180), 60.0_f64, 1), ((100, 75), 75.5, 2), ((640, 360), 110.0, 1)]
    {
        let camera = Camera::new(size.0, size.1, fov.to_radians());
        let picture = (Step::Phong.picture())(&camera, samples);
        let words = format!("{fov}° and {samples}×{samples} rays");
        assert_answer_contains(
            &picture,
            "step05_phong",
            &["Right, but with other options", &words],
        );
    }
    let mut picture = (Step::Phong.picture())(&camera_with_size(320, 180), 1);
    picture.put_pixel(9, 9, Rgb([0; 3]));
    assert_answer_contains(&picture, "step05_phong", &["draw it with the default options"]);
}

#[test]
fn turned_scaled_or_recoloured_picture_is_named() {
    let mapped = |picture: &RgbImage, change: &dyn Fn([u8; 3]) -> [u8; 3]| {
        let mut picture = picture.clone();
        picture.pixels_mut().for_each(|pixel| pixel.0 = change(pixel.0));
        picture
    };
    for name in ["step05_phong", "plane"] {
        let ours = locked_picture(name);
        let mut shot = RgbImage::from_pixel(800, 500, Rgb([220; 3]));
        overlay(&mut shot, &ours, 30, 60);
        for (picture, words) in [
            (imageops::flip_vertical(&ours), "upside down"),
            (imageops::flip_horizontal(&ours), "mirrored"),
            (imageops::rotate180(&ours), "turned half around"),
            (imageops::rotate90(&ours), "turned a quarter to the right"),
            (mapped(&ours, &|[r, g, b]| [b, g, r]), "red and blue swapped"),
            (mapped(&ours, &|[_, g, _]| [g; 3]), "grey in every pixel"),
            (mapped(&ours, &|_| [7, 8, 9]), "one colour, (7, 8, 9)"),
            (resize(&ours, 240, 135, FilterType::Triangle), "made into 240×135"),
            (resize(&ours, 1280, 720, FilterType::CatmullRom), "made into 1280×720"),
            (crop_imm(&ours, 100, 150, 300, 200).to_image(), "columns 100 to 399"),
            (shot, "from column 30 and row 60 on"),
        ] {
            let text = text_of_wrong_picture(&picture, name);
            let first_line = text.lines().next().unwrap_or_default();
            assert!(first_line.contains(words), "{name}: {words}: {text}");
        }
    }
    // What is grey in ours as well explains nothing.
    let mut depth = locked_picture("depth");
    depth.put_pixel(9, 9, Rgb([9; 3]));
    assert!(!text_of_wrong_picture(&depth, "depth").contains("grey"));
    // Nor does a mirror what is as wrong in it.
    let mut rings = locked_picture("rings");
    rings.put_pixel(9, 9, Rgb([9; 3]));
    assert!(!text_of_wrong_picture(&rings, "rings").contains("picture is that"));
}

#[test]
fn screenshot_of_a_flat_picture_is_found() {
    let mut shot = RgbImage::from_pixel(656, 404, Rgb([90; 3]));
    overlay(&mut shot, &locked_picture("step03_nearest"), 8, 36);
    assert_answer_contains(&shot, "step03_nearest", &["from column 8 and row 36 on"]);
}

#[test]
fn one_wrong_number_is_named_with_its_owner() {
    let golden = "the golden sphere is at (0.45, −1.27, −5.8); it should be at (0.45, \
                  −1.12, −5.8)";
    let cases: [(Change, &str); 4] = [
        (&|scene| scene.objects[2].sphere.centre.y = -1.27, golden),
        (&|scene| scene.objects[0].material.shininess = 41, "n of the red sphere is 41"),
        (&|scene| scene.ambient_light.y = 0.23, "L_a of the scene is (0.32, 0.23, "),
        (
            &|scene| scene.lights[0].point_light.attenuation.b = 0.025,
            "(a, b, c) of the warm light is (0.7, 0.025, ",
        ),
    ];
    for (change, words) in cases {
        assert_answer_contains(&draw_changed_step05(change), "step05_phong", &[words]);
    }
}

#[test]
fn answer_names_the_file_or_the_tests() {
    let mut higher = camera_with_size(640, 360);
    higher.matrix.y_axis.y *= 1.07;
    let scene = step05_phong::scene();
    let higher = render(&higher, 1, |ray| step05_phong::colour(&scene, ray));
    let displacement = DVec3::new(0.123, 0.0456, 0.0);
    let cases: [(RgbImage, &[&str]); 3] = [
        (
            higher,
            &[
                "with another camera: x and y of D_v are (0, −0.001934), not (0, −0.001807)",
                "camera.rs",
            ],
        ),
        (
            (Step::Rays.picture())(&camera_with_size(640, 360), 1),
            &["picture of step01_rays, not of"],
        ),
        (
            draw_changed_step05(|scene| scene.objects[7].sphere.centre += displacement),
            &["pixels of objects show the sky", "-p step03_nearest"],
        ),
    ];
    for (picture, words) in cases {
        assert_answer_contains(&picture, "step05_phong", words);
    }
}

#[test]
fn listed_mistake_is_shown_with_its_diff() {
    let picture = render(&camera_with_size(640, 360), 1, |ray| {
        let v = ray.direction;
        DVec3::new(v.x, v.y, -v.z)
    });
    let diff = "- 0.7 + 0.3 * DVec3::new(v.x, v.y, -v.z)\n  + DVec3::new(v.x, v.y, -v.z)";
    assert_answer_contains(&picture, "step01_rays", &[diff]);
    let words = "pixels of step01_rays with a mistake in it, not of step04";
    assert_answer_contains(&picture, "step04_diffuse", &[words]);
}
