//! Locks answers about several kinds of pictures:
//!
//! - our whole picture, for instance upside down or enlarged
//! - our picture with one change
//! - pictures that result from unlisted mistakes
//! - scenes that are generated from names

use crate::{
    assert_locked, check, draw, draw_generated_scene, encode, format_answer, locked_picture,
    map_locked,
};
use check::check_scene_png;
use course::{Step, camera, colour_without_highlight_gate};
use glam::DVec3;
use image::imageops::{crop_imm, flip_horizontal, flip_vertical, rotate90, rotate180, rotate270};
use image::{Rgb, RgbImage};
use step01_rays::{Camera, Ray, direction_colour};
use step02_sphere::Sphere;
use step03_nearest::{OBJECTS, colour, nearest};

/// A title, the name of the expected picture, and the picture to check.
type Row = (&'static str, &'static str, RgbImage);

const RAYS: &str = "step01_rays";
const NEAREST: &str = "step03_nearest";
const PHONG: &str = "step05_phong";

/// Compares the answers about these pictures with the snapshot `name`.
#[track_caller]
fn assert_rows_locked(name: &str, rows: impl IntoIterator<Item = Row>) {
    let answer = |(title, expected, picture): Row| {
        (format!("{title}, {expected}"), format_answer(Ok(check(picture, expected))))
    };
    assert_locked(name, rows.into_iter().map(answer));
}

#[test]
fn answers_about_whole_pictures_are_as_locked() {
    let (ours, depth) = (locked_picture(PHONG), locked_picture("depth"));
    let other_options = Camera::new(100, 75, 75.5_f64.to_radians());
    let three_decimals = Camera::new(64, 36, 33.333_f64.to_radians());
    let narrow = Camera::new(640, 360, 5_f64.to_radians());
    let large = Camera::new(4096, 2304, 60_f64.to_radians());
    let twice_the_angle = Camera::new(640, 360, 120_f64.to_radians());
    let listed_angle = Camera::new(640, 360, 81.787_f64.to_radians());
    let four_decimals = Camera::new(640, 360, 59.9696_f64.to_radians());
    let wide = Camera::new(640, 360, 150.12345_f64.to_radians());
    let part = crop_imm(&ours, 100, 150, 300, 200).to_image();
    let mut spotted_part = part.clone();
    spotted_part[(7, 9)] = Rgb([9; 3]);
    let twice = RgbImage::from_fn(1280, 720, |i, j| ours[(i / 2, j / 2)]);
    let wrong_pixel = |i, j, ours| if (i, j) == (9, 9) { [9; 3] } else { ours };
    assert_rows_locked(
        "whole_pictures",
        [
            ("100×75, 75.5°, 2", PHONG, (Step::Phong.draw_function())(&other_options, 2)),
            ("33.333°", PHONG, (Step::Phong.draw_function())(&three_decimals, 1)),
            ("5°", NEAREST, (Step::Nearest.draw_function())(&narrow, 1)),
            ("4096×2304", RAYS, (Step::Rays.draw_function())(&large, 1)),
            ("120°", PHONG, (Step::Phong.draw_function())(&twice_the_angle, 1)),
            ("81.787°", NEAREST, (Step::Nearest.draw_function())(&listed_angle, 1)),
            ("59.9696°", NEAREST, (Step::Nearest.draw_function())(&four_decimals, 1)),
            ("150.12345°", PHONG, (Step::Phong.draw_function())(&wide, 1)),
            ("step 4", PHONG, locked_picture("step04_diffuse")),
            ("upside down", PHONG, flip_vertical(&ours)),
            ("mirrored", "depth", flip_horizontal(&depth)),
            ("half a turn", "depth", rotate180(&depth)),
            ("a quarter", "depth", rotate90(&depth)),
            ("three quarters", "depth", rotate270(&depth)),
            ("blue for red", PHONG, map_locked(PHONG, |_, _, [r, g, b]| [b, g, r])),
            ("grey", PHONG, map_locked(PHONG, |_, _, [_, g, _]| [g; 3])),
            ("black", PHONG, RgbImage::new(640, 360)),
            ("cut out", PHONG, part),
            ("cut out, with a wrong pixel", PHONG, spotted_part),
            ("enlarged", PHONG, twice),
            ("different size", "rings", RgbImage::new(64, 36)),
            ("one wrong pixel", "rings", map_locked("rings", wrong_pixel)),
        ],
    );
}

#[test]
fn answers_about_wrong_scenes_and_cameras_are_as_locked() {
    let bare_sky = draw(|ray| ray.direction * DVec3::new(1.0, 1.0, -1.0));
    let mut dull = step05_phong::scene();
    dull.lights[0].specular = DVec3::ZERO;
    let nearer = Sphere { centre: DVec3::new(0.0, 0.0, -4.95), radius: 1.0 };
    let mut high_camera = camera();
    high_camera.matrix.y_axis.y *= 1.07;
    let mut half_a_pixel = camera();
    half_a_pixel.matrix.z_axis -= 0.5 * (camera().matrix.x_axis + camera().matrix.y_axis);
    let seen_by = Step::Nearest.draw_function();
    let mut wide = camera();
    wide.matrix.x_axis.x *= 639.0 / 640.0;
    let mut rounded_ratio = camera();
    rounded_ratio.matrix.z_axis.y = -camera().matrix.z_axis.x / 1.78;
    let mut low_view = rounded_ratio;
    low_view.matrix.y_axis.y = -2.0 * rounded_ratio.matrix.z_axis.y / 359.0;
    assert_rows_locked(
        "wrong_scenes_and_cameras",
        [
            ("sky without 0.7 + 0.3", RAYS, bare_sky),
            ("no warm highlights", PHONG, draw(|ray| step05_phong::colour(&dull, ray))),
            ("3 objects", NEAREST, draw(|ray| step03_nearest::colour(&OBJECTS[..3], ray))),
            ("nearer", "step02_sphere", draw(|ray| step02_sphere::colour(&nearer, ray))),
            ("a higher camera", NEAREST, seen_by(&high_camera, 1)),
            ("D_u by hRes", RAYS, (Step::Rays.draw_function())(&wide, 1)),
            ("D_u by hRes", PHONG, (Step::Phong.draw_function())(&wide, 1)),
            ("1.78 for 16:9", PHONG, (Step::Phong.draw_function())(&rounded_ratio, 1)),
            ("1.78 for 16:9 in D_v, too", PHONG, (Step::Phong.draw_function())(&low_view, 1)),
            ("a higher camera", PHONG, (Step::Phong.draw_function())(&high_camera, 1)),
            ("half a pixel up and left", NEAREST, seen_by(&half_a_pixel, 1)),
        ],
    );
}

#[test]
fn answers_about_exchanged_rows_and_few_wrong_pixels_are_as_locked() {
    let rays = locked_picture(RAYS);
    let spots = |i: u32, j: u32, ours| if j == 9 && i.is_multiple_of(90) { [9; 3] } else { ours };
    assert_rows_locked(
        "pixels",
        [
            ("rows exchanged in pairs", RAYS, map_locked(RAYS, |i, j, _| rays[(i, j ^ 1)].0)),
            ("8 wrong pixels", PHONG, map_locked(PHONG, spots)),
        ],
    );
}

#[test]
fn answers_about_undrawn_pixels_are_as_locked() {
    let of_colour = |colour, is_undrawn: fn(u32, u32) -> bool| {
        map_locked(RAYS, |i, j, ours| if is_undrawn(i, j) { colour } else { ours })
    };
    let black = |is_undrawn| of_colour([0; 3], is_undrawn);
    let rows = [
        ("every other row", black(|_, j| j % 2 == 1)),
        ("white rows", of_colour([255; 3], |_, j| j % 3 == 0)),
        ("a triangle", black(|i, j| i < j)),
        ("a ninth in the middle", black(|i, j| i / 213 == 1 && j / 120 == 1)),
        ("two tiles", black(|i, j| (i / 64, j / 36) == (1, 2) || (i / 64, j / 36) == (7, 5))),
        ("from one pixel on", black(|i, j| 640 * j + i > 150_000)),
        ("the last row and column", black(|i, j| i == 639 || j == 359)),
        ("lines between tiles", black(|i, j| i % 16 == 15 || j % 16 == 15)),
        ("a frame of ten pixels", black(|i, j| !(10..630).contains(&i) || !(10..350).contains(&j))),
        ("bars on both sides", black(|i, _| !(40..600).contains(&i))),
        ("bars above and below", of_colour([255; 3], |_, j| !(45..315).contains(&j))),
        ("every third pixel", black(|i, j| (640 * j + i) % 3 == 1)),
        ("falling diagonals", black(|i, j| (i + 360 - j).is_multiple_of(8))),
        ("rising diagonals", black(|i, j| (i + j) % 8 < 2)),
        ("99 pixels", black(|i, j| i < 11 && j < 9)),
    ];
    let black_ball = |i: u32, j: u32, ours| {
        let hit = nearest(&OBJECTS, &camera().ray(i.into(), j.into()));
        if hit.is_some_and(|hit| hit.object.name == "teal sphere") { [0; 3] } else { ours }
    };
    let rows = rows.map(|(title, picture)| (title, RAYS, picture)).into_iter();
    let phong_rows = [
        (
            "every other column",
            PHONG,
            map_locked(PHONG, |i, _, ours| ours.map(|c| c * (i % 2) as u8)),
        ),
        ("a black ball", PHONG, map_locked(PHONG, black_ball)),
    ];
    assert_rows_locked("undrawn_pixels", rows.chain(phong_rows));
}

#[test]
fn answers_about_colours_are_as_locked() {
    let white_to_blue = |ray: &Ray| {
        let t = 0.5 + 0.5 * ray.direction.normalize().y;
        (1.0 - t) * DVec3::ONE + t * DVec3::new(0.5, 0.7, 1.0)
    };
    let below_sky = draw(|ray| {
        nearest(&OBJECTS, ray).map_or_else(|| white_to_blue(ray), |hit| hit.object.material)
    });
    let encoded = |byte: fn(f64) -> u8| {
        let intensity = |i: u32, j: u32| colour(&OBJECTS, &camera().ray(i.into(), j.into()));
        RgbImage::from_fn(640, 360, |i, j| Rgb(intensity(i, j).to_array().map(byte)))
    };
    let nearer_by_half = draw(|ray| {
        let hits = OBJECTS
            .iter()
            .filter_map(|object| Some((object.sphere.intersect(ray).first_hit()?, object)));
        let visible_hit = hits.reduce(|best, hit| if hit.0 < best.0 - 0.5 { hit } else { best });
        visible_hit.map_or_else(|| direction_colour(ray), |(_, object)| object.material)
    });
    let brighten = |byte: u8| (u32::from(byte) * 3 / 2).min(255) as u8;
    let scene = step04_diffuse::scene();
    let scaled = draw(|ray| {
        let colour = step04_diffuse::colour(&scene, ray);
        colour / colour.max_element().max(1.0)
    });
    assert_rows_locked(
        "colours",
        [
            ("1.5 times as bright", RAYS, map_locked(RAYS, |_, _, ours| ours.map(brighten))),
            ("at most 254", RAYS, map_locked(RAYS, |_, _, ours| ours.map(|byte| byte.min(254)))),
            ("a white to blue sky", RAYS, draw(white_to_blue)),
            ("a white to blue sky", NEAREST, below_sky),
            ("255.99·I cut off", NEAREST, encoded(|i| (255.99 * i) as u8)),
            ("gamma 2", NEAREST, encoded(|i| (255.0 * i.sqrt() + 0.5) as u8)),
            ("nearer only by 0.5", NEAREST, nearer_by_half),
            ("scaled where it is above 1", "step04_diffuse", scaled),
        ],
    );
}

#[test]
fn answers_about_scenes_generated_from_names_are_as_locked() {
    let ada = course::generate_scene("ada");
    let mut small_ball = ada.clone();
    small_ball.objects[3].sphere.radius = 1.0;
    let rows = [
        ("right", "ada", draw_generated_scene("ada")),
        ("different case", "Ada", draw_generated_scene("ada")),
        ("no gate", "ada", draw(|ray| colour_without_highlight_gate(&ada, ray))),
        ("one number", "ada", draw(|ray| step05_phong::colour(&small_ball, ray))),
        ("the picture of step 5", "ada", locked_picture(PHONG)),
    ];
    let answer = |(title, name, picture): (&str, &str, RgbImage)| {
        let answer = check_scene_png(&encode(picture), "my.png", name);
        (format!("{title}, {name}"), format_answer(answer))
    };
    assert_locked("scenes_generated_from_names", rows.map(answer));
}
