//! Answers about pictures that are ours as a whole, or with one change; and about the scenes of
//! names.

use crate::{
    LOCKED, assert_locked, assert_rows_locked, draw, draw_step, encode, format_answer,
    locked_picture, map_locked,
};
use check::check_scene_png;
use course::{Step, camera, ungated_colour};
use glam::DVec3;
use image::imageops::{self, FilterType, crop_imm, overlay, resize};
use image::{Rgb, RgbImage};
use step01_rays::{Camera, render};
use step02_sphere::Sphere;
use step05_phong::{Light, Material};

/// A scene of step 5.
type Scene = step05_phong::Scene<Material, Light>;

const PHONG: &str = "step05_phong";

/// A picture with one pixel of another colour.
fn with_pixel(mut picture: RgbImage) -> RgbImage {
    picture[(9, 9)] = Rgb([9; 3]);
    picture
}

/// A picture inside a larger one.
fn screenshot(name: &str, grey: u8) -> RgbImage {
    let mut shot = RgbImage::from_pixel(800, 500, Rgb([grey; 3]));
    overlay(&mut shot, &locked_picture(name), 30, 60);
    shot
}

#[test]
fn answers_about_whole_pictures_are_as_locked() {
    let ours = locked_picture(PHONG);
    let phong = |width, height, fov: f64, samples| {
        (Step::Phong.picture())(&Camera::new(width, height, fov.to_radians()), samples)
    };
    assert_rows_locked(
        "whole_pictures",
        [
            ("right", PHONG, draw_step(Step::Phong)),
            ("100×75, 75.5°, 2", PHONG, phong(100, 75, 75.5, 2)),
            ("small, one wrong pixel", PHONG, with_pixel(phong(64, 36, 60.0, 1))),
            ("step 4", PHONG, locked_picture("step04_diffuse")),
            ("step 2", "step03_nearest", locked_picture("step02_sphere")),
            ("glass", "sun", locked_picture("glass")),
            ("upside down", PHONG, imageops::flip_vertical(&ours)),
            ("mirrored, one wrong pixel", PHONG, with_pixel(imageops::flip_horizontal(&ours))),
            ("a quarter", PHONG, imageops::rotate90(&ours)),
            ("blue for red", PHONG, map_locked(PHONG, |_, _, [r, g, b]| [b, g, r])),
            ("grey", PHONG, map_locked(PHONG, |_, _, [_, g, _]| [g; 3])),
            ("black", PHONG, RgbImage::new(640, 360)),
            ("cut out", PHONG, crop_imm(&ours, 100, 150, 300, 200).to_image()),
            ("screenshot", "step03_nearest", screenshot("step03_nearest", 90)),
            ("enlarged", PHONG, resize(&ours, 1280, 720, FilterType::Nearest)),
            ("made smaller", PHONG, resize(&ours, 240, 135, FilterType::Triangle)),
            ("one wrong pixel", "rings", with_pixel(locked_picture("rings"))),
        ],
    );
}

/// The picture of a scene with a change.
fn draw_changed(mut scene: Scene, change: impl Fn(&mut Scene)) -> RgbImage {
    change(&mut scene);
    draw(|ray| step05_phong::colour(&scene, ray))
}

/// The picture of step 5 with a change of its scene.
fn changed(change: impl Fn(&mut Scene)) -> RgbImage {
    draw_changed(step05_phong::scene(), change)
}

/// The picture of step 2 with another ball.
fn ball(z: f64, radius: f64) -> RgbImage {
    let sphere = Sphere { centre: DVec3::new(0.0, 0.0, z), radius };
    draw(|ray| step02_sphere::colour(&sphere, ray))
}

/// The picture of step 3 by another camera.
fn seen_by(change: impl Fn(&mut Camera)) -> RgbImage {
    let mut camera = camera();
    change(&mut camera);
    (Step::Nearest.picture())(&camera, 1)
}

#[test]
fn answers_about_changes_of_ours_are_as_locked() {
    let [sphere, nearest] = ["step02_sphere", "step03_nearest"];
    let bare_sky = || draw(|ray| ray.direction * DVec3::new(1.0, 1.0, -1.0));
    let scene = step05_phong::scene();
    let without_gate = |samples| render(&camera(), samples, |ray| ungated_colour(&scene, ray));
    assert_rows_locked(
        "changes_of_ours",
        [
            ("sky without 0.7 + 0.3", "step01_rays", bare_sky()),
            ("sky without 0.7 + 0.3, of step 1", "step04_diffuse", bare_sky()),
            ("no gate", PHONG, without_gate(1)),
            ("no gate, 2×2 rays", PHONG, without_gate(2)),
            ("golden lower", PHONG, changed(|one| one.objects[2].sphere.centre.y = -1.27)),
            ("red's n is 41", PHONG, changed(|one| one.objects[0].material.shininess = 41)),
            ("L_a has another green", PHONG, changed(|one| one.ambient_light.y = 0.23)),
            ("no warm highlights", PHONG, changed(|one| one.lights[0].specular = DVec3::ZERO)),
            ("no white sphere", PHONG, changed(|one| one.objects[6].sphere.radius = 0.0)),
            ("the first 3 objects", PHONG, changed(|one| one.objects.truncate(3))),
            ("a ball nearer or larger", sphere, ball(-4.95, 1.0)),
            ("a ball nearer and larger", sphere, ball(-4.5, 1.31)),
            ("a ball as large as seen", sphere, ball(-10.0, 2.0)),
            ("a slanted camera", nearest, seen_by(|one| one.matrix.y_axis.x = 0.0004)),
            ("a higher camera", nearest, seen_by(|one| one.matrix.y_axis.y *= 1.07)),
            (
                "half a pixel up and left",
                nearest,
                seen_by(|one| {
                    one.matrix.z_axis -= 0.5 * (one.matrix.x_axis + one.matrix.y_axis);
                }),
            ),
        ],
    );
}

#[test]
fn answers_about_scenes_of_names_are_as_locked() {
    let ada = course::named_scene("ada");
    let right = || draw_changed(ada.clone(), |_| ());
    let one_number = |scene: &mut Scene| scene.objects[3].sphere.radius = 1.0;
    let no_highlights =
        |scene: &mut Scene| scene.lights.iter_mut().for_each(|one| one.specular = DVec3::ZERO);
    let rows = [
        ("right", "ada", right()),
        ("another case", "Ada", right()),
        ("another name", "bob", right()),
        ("4 rays per pixel", "ada", render(&camera(), 2, |ray| step05_phong::colour(&ada, ray))),
        ("no gate", "ada", draw(|ray| ungated_colour(&ada, ray))),
        ("one number", "ada", draw_changed(ada.clone(), one_number)),
        ("no highlights", "ada", draw_changed(ada.clone(), no_highlights)),
        ("one wrong pixel", "ada", with_pixel(right())),
        ("the picture of step 5", "ada", draw_step(Step::Phong)),
    ];
    let others = ["ada", "bob", "cleo"].map(str::to_owned);
    let answer = |(title, name, picture): (&str, &str, RgbImage)| {
        let answer = check_scene_png(&encode(picture), "my.png", name, &others, &LOCKED);
        (format!("{title}, {name}"), format_answer(answer))
    };
    assert_locked("scenes_of_names", rows.map(answer));
}
