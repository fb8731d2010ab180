//! Answers about pictures of programs that are wrong in other ways than we know: what is said
//! has to be true of every pixel that it speaks of.

use crate::{assert_rows_locked, draw, locked_picture, map_locked};
use course::camera;
use glam::DVec3;
use image::{Rgb, RgbImage};
use step01_rays::{Ray, direction_colour, rgb8, sub_pixels};
use step03_nearest::{OBJECTS, colour, nearest};

const RAYS: &str = "step01_rays";
const NEAREST: &str = "step03_nearest";
const DIFFUSE: &str = "step04_diffuse";
const PHONG: &str = "step05_phong";

/// A picture of ours, each pixel of which is taken from elsewhere.
fn moved(name: &str, place: impl Fn(u32, u32) -> (u32, u32)) -> RgbImage {
    let ours = locked_picture(name);
    map_locked(name, |i, j, _| ours[place(i, j)].0)
}

/// The picture of a function of the rays in a pixel.
fn sampled(mean: impl Fn(&dyn Fn(f64, f64) -> Ray) -> DVec3) -> RgbImage {
    let camera = camera();
    RgbImage::from_fn(640, 360, |i, j| {
        rgb8(mean(&|u, v| camera.ray(f64::from(i) + u, f64::from(j) + v)))
    })
}

#[test]
fn answers_about_pixels_and_samples_are_as_locked() {
    let scene = step05_phong::scene();
    let mean_of_bytes = sampled(|ray| {
        let bytes = sub_pixels(2).into_iter().map(|(u, v)| {
            let bytes = rgb8(step05_phong::colour(&scene, &ray(u, v))).0;
            DVec3::from_array(bytes.map(f64::from)) / 255.0
        });
        bytes.sum::<DVec3>() / 4.0
    });
    let on_circle = sampled(|ray| {
        let places = (0..8).map(|k| f64::from(k).sin_cos());
        places.map(|(s, c)| colour(&OBJECTS, &ray(s / 2.0, c / 2.0))).sum::<DVec3>() / 8.0
    });
    let noise = |i, j, b: u8| b.saturating_add((i * 7919 % 5 + j % 2) as u8).saturating_sub(2);
    let black = |is_black: fn(u32, u32) -> bool| {
        map_locked(PHONG, |i, j, ours| if is_black(i, j) { [0; 3] } else { ours })
    };
    let waves = RgbImage::from_fn(640, 360, |i, j| Rgb([(i * j / 64) as u8, (i ^ j) as u8, 255]));
    assert_rows_locked(
        "pixels_and_samples",
        [
            ("rows exchanged in pairs", RAYS, moved(RAYS, |i, j| (i, j ^ 1))),
            ("a checkerboard", PHONG, moved(PHONG, |i, j| ((i + (i + j) % 2).min(639), j))),
            ("mean of bytes", PHONG, mean_of_bytes),
            ("samples on a circle", NEAREST, on_circle),
            ("every other row is never drawn", PHONG, black(|_, j| j % 2 == 1)),
            ("a ninth in the middle", PHONG, black(|i, j| i / 213 == 1 && j / 120 == 1)),
            ("noise", PHONG, map_locked(PHONG, |i, j, ours| ours.map(|b| noise(i, j, b)))),
            ("waves", "glass", waves),
        ],
    );
}

#[test]
fn answers_about_skies_and_bytes_are_as_locked() {
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
    assert_rows_locked(
        "skies_and_bytes",
        [
            ("a white to blue sky", RAYS, draw(white_to_blue)),
            ("a white to blue sky", NEAREST, below_sky),
            ("255.99·I cut off", NEAREST, bytes(|i| (255.99 * i) as u8)),
            ("gamma 2", NEAREST, bytes(|i| (255.0 * i.sqrt() + 0.5) as u8)),
        ],
    );
}

/// The picture of step 4, in which a function adds a term to the sum, by its n·l; None ends the
/// loop.
fn summed(add: fn(DVec3, DVec3, f64) -> Option<DVec3>) -> RgbImage {
    let scene = step04_diffuse::scene();
    draw(|ray| {
        let Some(point) = step04_diffuse::visible_point(&scene.objects, ray) else {
            return direction_colour(ray);
        };
        let mut sum = step04_diffuse::ambient(point.material, scene.ambient_light);
        for light in &scene.lights {
            let (l, d) = light.direction_from(point.p);
            let term = step04_diffuse::diffuse(point.n, l, d, point.material, light);
            let Some(new_sum) = add(sum, term, point.n.dot(l)) else { break };
            sum = new_sum;
        }
        sum
    })
}

#[test]
fn answers_about_hits_and_light_are_as_locked() {
    let nearer_by_half = draw(|ray| {
        let hits = OBJECTS.iter();
        let hits = hits.filter_map(|one| Some((one.sphere.intersect(ray).first_hit()?, one)));
        let seen = hits.reduce(|best, hit| if hit.0 < best.0 - 0.5 { hit } else { best });
        seen.map_or_else(|| direction_colour(ray), |(_, one)| one.material)
    });
    let front_lit = |sum: DVec3, term: DVec3, cosine: f64| (0.0 < cosine).then_some(sum + term);
    let below_1 = |sum: DVec3, term: DVec3, _: f64| {
        Some(if sum.max_element() < 1.0 { sum + term } else { sum })
    };
    assert_rows_locked(
        "hits_and_light",
        [
            ("nearer only by 0.5", NEAREST, nearer_by_half),
            ("the first light behind ends the loop", DIFFUSE, summed(front_lit)),
            ("light is added only below 1", DIFFUSE, summed(below_1)),
        ],
    );
}
