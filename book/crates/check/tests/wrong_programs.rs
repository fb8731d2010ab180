//! Answers about pictures of programs that are wrong in other ways than we know: what is said
//! has to be true of every pixel that it speaks of.

use crate::{assert_rows_locked, draw, locked_picture, map_locked};
use course::camera;
use glam::DVec3;
use image::{Rgb, RgbImage};
use step01_rays::{Ray, direction_colour};
use step03_nearest::{OBJECTS, colour, nearest};

const RAYS: &str = "step01_rays";
const NEAREST: &str = "step03_nearest";
const PHONG: &str = "step05_phong";

#[test]
fn answers_about_pixels_are_as_locked() {
    let (rays, phong) = (locked_picture(RAYS), locked_picture(PHONG));
    let noise = |i, j, b: u8| b.saturating_add((i * 7919 % 5 + j % 2) as u8).saturating_sub(2);
    let black = |is_black: fn(u32, u32) -> bool| {
        map_locked(PHONG, |i, j, ours| if is_black(i, j) { [0; 3] } else { ours })
    };
    let waves = RgbImage::from_fn(640, 360, |i, j| Rgb([(i * j / 64) as u8, (i ^ j) as u8, 255]));
    assert_rows_locked(
        "pixels",
        [
            ("rows exchanged in pairs", RAYS, map_locked(RAYS, |i, j, _| rays[(i, j ^ 1)].0)),
            ("one row up", PHONG, map_locked(PHONG, |i, j, _| phong[(i, 359.min(j + 1))].0)),
            ("every other row is never drawn", PHONG, black(|_, j| j % 2 == 1)),
            ("a ninth in the middle", PHONG, black(|i, j| i / 213 == 1 && j / 120 == 1)),
            ("noise", PHONG, map_locked(PHONG, |i, j, ours| ours.map(|b| noise(i, j, b)))),
            ("waves", "glass", waves),
        ],
    );
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
    let bytes = |byte: fn(f64) -> u8| {
        let intensity = |i: u32, j: u32| colour(&OBJECTS, &camera().ray(i.into(), j.into()));
        RgbImage::from_fn(640, 360, |i, j| Rgb(intensity(i, j).to_array().map(byte)))
    };
    let nearer_by_half = draw(|ray| {
        let hits = OBJECTS.iter();
        let hits = hits.filter_map(|one| Some((one.sphere.intersect(ray).first_hit()?, one)));
        let seen = hits.reduce(|best, hit| if hit.0 < best.0 - 0.5 { hit } else { best });
        seen.map_or_else(|| direction_colour(ray), |(_, one)| one.material)
    });
    let scene = step04_diffuse::scene();
    let scaled = draw(|ray| {
        let colour = step04_diffuse::colour(&scene, ray);
        colour / colour.max_element().max(1.0)
    });
    assert_rows_locked(
        "colours",
        [
            ("a white to blue sky", RAYS, draw(white_to_blue)),
            ("a white to blue sky", NEAREST, below_sky),
            ("255.99·I cut off", NEAREST, bytes(|i| (255.99 * i) as u8)),
            ("gamma 2", NEAREST, bytes(|i| (255.0 * i.sqrt() + 0.5) as u8)),
            ("nearer only by 0.5", NEAREST, nearer_by_half),
            ("scaled where it is above 1", "step04_diffuse", scaled),
        ],
    );
}
