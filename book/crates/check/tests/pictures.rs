//! Answers about pictures that are ours as a whole, or with one change; and about the scenes of
//! names.

use crate::{
    assert_locked, assert_rows_locked, draw, draw_scene, draw_step, encode, format_answer,
    locked_picture, map_locked,
};
use check::check_scene_png;
use course::{Step, camera, ungated_colour};
use glam::DVec3;
use image::imageops::{self, crop_imm, overlay};
use image::{Rgb, RgbImage};
use step01_rays::Camera;
use step02_sphere::Sphere;
use step03_nearest::OBJECTS;
use step05_phong::{Light, Material};

/// A scene of step 5.
type Scene = step05_phong::Scene<Material, Light>;

const PHONG: &str = "step05_phong";
const NEAREST: &str = "step03_nearest";

#[test]
fn answers_about_whole_pictures_are_as_locked() {
    let ours = locked_picture(PHONG);
    let other_options = Camera::new(100, 75, 75.5_f64.to_radians());
    let twice_the_angle = Camera::new(640, 360, 120_f64.to_radians());
    let mut screenshot = RgbImage::from_pixel(800, 500, Rgb([90; 3]));
    overlay(&mut screenshot, &locked_picture(NEAREST), 30, 60);
    let twice = RgbImage::from_fn(1280, 720, |i, j| ours[(i / 2, j / 2)]);
    let wrong_pixel = |i, j, ours| if (i, j) == (9, 9) { [9; 3] } else { ours };
    assert_rows_locked(
        "whole_pictures",
        [
            ("right", PHONG, draw_step(Step::Phong)),
            ("100×75, 75.5°, 2", PHONG, (Step::Phong.picture())(&other_options, 2)),
            ("120°", PHONG, (Step::Phong.picture())(&twice_the_angle, 1)),
            ("step 4", PHONG, locked_picture("step04_diffuse")),
            ("glass", "sun", locked_picture("glass")),
            ("upside down", PHONG, imageops::flip_vertical(&ours)),
            ("a quarter", "depth", imageops::rotate90(&locked_picture("depth"))),
            ("blue for red", PHONG, map_locked(PHONG, |_, _, [r, g, b]| [b, g, r])),
            ("grey", PHONG, map_locked(PHONG, |_, _, [_, g, _]| [g; 3])),
            ("black", PHONG, RgbImage::new(640, 360)),
            ("cut out", PHONG, crop_imm(&ours, 100, 150, 300, 200).to_image()),
            ("screenshot", NEAREST, screenshot),
            ("enlarged", PHONG, twice),
            ("made smaller", PHONG, imageops::thumbnail(&ours, 240, 135)),
            ("one wrong pixel", "rings", map_locked("rings", wrong_pixel)),
        ],
    );
}

fn changed(mut scene: Scene, change: impl Fn(&mut Scene)) -> RgbImage {
    change(&mut scene);
    draw(|ray| step05_phong::colour(&scene, ray))
}

#[test]
fn answers_about_changes_of_ours_are_as_locked() {
    let bare_sky = || draw(|ray| ray.direction * DVec3::new(1.0, 1.0, -1.0));
    let scene = step05_phong::scene();
    let phong = step05_phong::scene;
    let nearer = Sphere { centre: DVec3::new(0.0, 0.0, -4.95), radius: 1.0 };
    let mut high_camera = camera();
    high_camera.matrix.y_axis.y *= 1.07;
    let mut half_a_pixel = camera();
    half_a_pixel.matrix.z_axis -= 0.5 * (camera().matrix.x_axis + camera().matrix.y_axis);
    let seen_by = Step::Nearest.picture();
    assert_rows_locked(
        "changes_of_ours",
        [
            ("sky without 0.7 + 0.3", "step01_rays", bare_sky()),
            ("sky without 0.7 + 0.3, of step 1", "step04_diffuse", bare_sky()),
            ("no gate", PHONG, draw(|ray| ungated_colour(&scene, ray))),
            (
                "red's n is 41",
                PHONG,
                changed(phong(), |one| one.objects[0].material.shininess = 41),
            ),
            (
                "no warm highlights",
                PHONG,
                changed(phong(), |one| one.lights[0].specular = DVec3::ZERO),
            ),
            ("3 objects", NEAREST, draw(|ray| step03_nearest::colour(&OBJECTS[..3], ray))),
            ("nearer", "step02_sphere", draw(|ray| step02_sphere::colour(&nearer, ray))),
            ("a higher camera", NEAREST, seen_by(&high_camera, 1)),
            ("half a pixel up and left", NEAREST, seen_by(&half_a_pixel, 1)),
        ],
    );
}

#[test]
fn answers_about_scenes_of_names_are_as_locked() {
    let ada = course::named_scene("ada");
    let rows = [
        ("right", "ada", draw_scene("ada")),
        ("another case", "Ada", draw_scene("ada")),
        ("no gate", "ada", draw(|ray| ungated_colour(&ada, ray))),
        ("one number", "ada", changed(ada.clone(), |one| one.objects[3].sphere.radius = 1.0)),
        ("the picture of step 5", "ada", draw_step(Step::Phong)),
    ];
    let others = ["ada", "bob"].map(str::to_owned);
    let answer = |(title, name, picture): (&str, &str, RgbImage)| {
        let answer = check_scene_png(&encode(picture), "my.png", name, &others);
        (format!("{title}, {name}"), format_answer(answer))
    };
    assert_locked("scenes_of_names", rows.map(answer));
}
