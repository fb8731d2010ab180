//! Answers about pictures of programs that are wrong in other ways than we know: what is said
//! has to be true of every pixel that it speaks of.

use crate::{assert_rows_locked, draw, locked_picture, map_locked};
use course::camera;
use glam::DVec3;
use image::imageops::blur;
use image::{Rgb, RgbImage};
use step01_rays::{Ray, direction_colour, rgb8, sub_pixels};
use step03_nearest::{OBJECTS, Object, colour, nearest};

const RAYS: &str = "step01_rays";
const NEAREST: &str = "step03_nearest";
const DIFFUSE: &str = "step04_diffuse";
const PHONG: &str = "step05_phong";

/// A picture of ours, each pixel of which is taken from elsewhere.
fn moved(name: &str, place: impl Fn(u32, u32) -> (u32, u32)) -> RgbImage {
    let ours = locked_picture(name);
    map_locked(name, |i, j, _| ours[place(i, j)].0)
}

/// The picture of a function of a pixel's column and row and of another place in the pixel.
fn sampled(mean: impl Fn(&dyn Fn(f64, f64) -> Ray, u32, u32) -> DVec3) -> RgbImage {
    let camera = camera();
    RgbImage::from_fn(640, 360, |i, j| {
        rgb8(mean(&|u, v| camera.ray(f64::from(i) + u, f64::from(j) + v), i, j))
    })
}

#[test]
fn answers_about_pixels_and_samples_are_as_locked() {
    let scene = step05_phong::scene();
    let mean_of_bytes = sampled(|ray, _, _| {
        let bytes = sub_pixels(2).into_iter().map(|(u, v)| {
            let bytes = rgb8(step05_phong::colour(&scene, &ray(u, v))).0;
            DVec3::from_array(bytes.map(f64::from)) / 255.0
        });
        bytes.sum::<DVec3>() / 4.0
    });
    let on_circle = sampled(|ray, _, _| {
        let places = (0..8).map(|k| f64::from(k).sin_cos());
        places.map(|(s, c)| colour(&OBJECTS, &ray(s / 2.0, c / 2.0))).sum::<DVec3>() / 8.0
    });
    let scattered = sampled(|ray, i, j| {
        let [u, v] = [101, 97].map(|n| f64::from((i * 31 + j * 17) * 7919 % n) / f64::from(n));
        direction_colour(&ray(u - 0.5, v - 0.5))
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
            ("pixels doubled", RAYS, moved(RAYS, |i, j| (i & !1, j & !1))),
            ("one column to the left", RAYS, moved(RAYS, |i, j| ((i + 1).min(639), j))),
            ("mean of bytes", PHONG, mean_of_bytes),
            ("samples on a circle", NEAREST, on_circle),
            ("a random place in each pixel", RAYS, scattered),
            ("the last row is never drawn", PHONG, black(|_, j| j == 359)),
            ("every other row", PHONG, black(|_, j| j % 2 == 1)),
            ("a ninth in the middle", PHONG, black(|i, j| i / 213 == 1 && j / 120 == 1)),
            ("noise", PHONG, map_locked(PHONG, |i, j, ours| ours.map(|b| noise(i, j, b)))),
            ("blurred", PHONG, blur(&locked_picture(PHONG), 2.0)),
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
    let weak = |ray: &Ray| 0.6 + 0.2 * ray.direction * DVec3::new(1.0, 1.0, -1.0);
    let below = |sky: fn(&Ray) -> DVec3| {
        draw(|ray| nearest(&OBJECTS, ray).map_or_else(|| sky(ray), |hit| hit.object.material))
    };
    let bytes = |objects: &[Object<DVec3>], byte: fn(f64) -> u8| {
        let pixel = |i: u32, j: u32| colour(objects, &camera().ray(i.into(), j.into()));
        RgbImage::from_fn(640, 360, |i, j| Rgb(pixel(i, j).to_array().map(byte)))
    };
    assert_rows_locked(
        "skies_and_bytes",
        [
            ("a white to blue sky", RAYS, draw(white_to_blue)),
            ("a white to blue sky", NEAREST, below(white_to_blue)),
            ("a weak sky", NEAREST, below(weak)),
            ("255.99·I cut off", NEAREST, bytes(&OBJECTS, |i| (255.99 * i) as u8)),
            ("gamma 2", NEAREST, bytes(&OBJECTS, |i| (255.0 * i.sqrt() + 0.5) as u8)),
            ("a negative", NEAREST, bytes(&OBJECTS, |i| (255.0 * (1.0 - i) + 0.5) as u8)),
            ("in tens", NEAREST, bytes(&OBJECTS, |i| ((25.5 * i) as u8).min(25) * 10)),
        ],
    );
}

type Hits<'a> = [(f64, &'a Object<DVec3>)];

/// The number of the hit with the least key.
fn least(hits: &Hits, key: impl Fn(&(f64, &Object<DVec3>)) -> f64) -> Option<usize> {
    (0..hits.len()).min_by(|a, b| key(&hits[*a]).total_cmp(&key(&hits[*b])))
}

/// The picture of step 3 with another choice of the hit that is seen.
fn chosen(choose: fn(&Hits) -> Option<usize>) -> RgbImage {
    draw(|ray| {
        let hits = OBJECTS.iter();
        let hits = hits.filter_map(|one| Some((one.sphere.intersect(ray).first_hit()?, one)));
        let hits: Vec<_> = hits.collect();
        choose(&hits).map_or_else(|| direction_colour(ray), |k| hits[k].1.material)
    })
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
    let nearer_by_half = |hits: &Hits| {
        (0..hits.len()).reduce(|best, k| if hits[k].0 < hits[best].0 - 0.5 { k } else { best })
    };
    let second = |hits: &Hits| {
        let first = least(hits, |hit| hit.0)?;
        (0..hits.len()).find(|k| *k != first).or(Some(first))
    };
    let in_boxes = draw(|ray| {
        let is_near = |one: &&Object<DVec3>| {
            let t = one.sphere.centre.dot(ray.direction) / ray.direction.length_squared();
            (ray.at(t) - one.sphere.centre).abs().max_element() < 0.5 * one.sphere.radius
        };
        colour(&OBJECTS.iter().filter(is_near).copied().collect::<Vec<_>>(), ray)
    });
    let front_lit = |sum: DVec3, term: DVec3, cosine: f64| (0.0 < cosine).then_some(sum + term);
    let below_1 = |sum: DVec3, term: DVec3, _: f64| {
        Some(if sum.max_element() < 1.0 { sum + term } else { sum })
    };
    let clamped = |sum: DVec3, term: DVec3, _: f64| Some((sum + term).min(DVec3::splat(0.9)));
    assert_rows_locked(
        "hits_and_light",
        [
            ("t as a whole number", NEAREST, chosen(|hits| least(hits, |hit| hit.0.floor()))),
            ("nearer only by 0.5", NEAREST, chosen(nearer_by_half)),
            ("the second hit", NEAREST, chosen(second)),
            ("a box half as large as the ball", NEAREST, in_boxes),
            ("the first light behind ends the loop", DIFFUSE, summed(front_lit)),
            ("light is added only below 1", DIFFUSE, summed(below_1)),
            ("clamped after each light", DIFFUSE, summed(clamped)),
        ],
    );
}
