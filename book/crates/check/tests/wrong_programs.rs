//! Answers about pictures of programs that are wrong in other ways than we know: what is said
//! has to be true of every pixel that it speaks of.

use crate::{Answers, Titled, draw, draw_changed_scene, locked_picture, map_locked};
use course::{Step, camera};
use glam::DVec3;
use image::imageops::blur;
use image::{Rgb, RgbImage};
use step01_rays::{Ray, direction_colour, rgb8, sub_pixels};
use step03_nearest::{OBJECTS, Object, colour, nearest};
use step05_phong::terms;

/// The place from which a pixel is taken.
type Move = fn(u32, u32) -> (u32, u32);

/// The sum after a light, by the sum before it, its term and its n·l; None ends the loop.
type Add = fn(DVec3, DVec3, f64) -> Option<DVec3>;

const STEPS: [&str; 2] = ["step01_rays", "step05_phong"];

#[test]
fn exchanged_and_coarse_pixels_are_as_locked() {
    let mut answers = Answers::new();
    for name in STEPS {
        let ours = locked_picture(name);
        let places: Titled<Move, 6> = [
            ("rows exchanged in pairs", |i, j| (i, j ^ 1)),
            ("columns exchanged in pairs", |i, j| (i ^ 1, j)),
            ("a checkerboard of neighbours", |i, j| ((i + (i + j) % 2).min(639), j)),
            ("pixels doubled", |i, j| (i & !1, j & !1)),
            ("pixels four times as large", |i, j| (i & !3, j & !3)),
            ("one column to the left", |i, j| ((i + 1).min(639), j)),
        ];
        for (title, place) in places {
            let pixel = |(i, j)| ours.get_pixel(i, j).0;
            let picture = map_locked(name, |i, j, _| pixel(place(i, j)));
            answers.add_picture(&format!("{name}: {title}"), name, picture);
        }
    }
    answers.assert_locked("exchanged_and_coarse_pixels");
}

#[test]
fn means_and_samples_are_as_locked() {
    let mut answers = Answers::new();
    let scene = step05_phong::scene();
    let camera = camera();
    let ray = |i: u32, j: u32, (u, v): (f64, f64)| camera.ray(f64::from(i) + u, f64::from(j) + v);
    let mean_of_bytes = |samples: u32| {
        RgbImage::from_fn(640, 360, |i, j| {
            let bytes = sub_pixels(samples).into_iter().map(|place| {
                let bytes = rgb8(step05_phong::colour(&scene, &ray(i, j, place))).0;
                DVec3::from_array(bytes.map(f64::from)) / 255.0
            });
            rgb8(bytes.sum::<DVec3>() / f64::from(samples * samples))
        })
    };
    answers.add_picture("mean of bytes, 2", "step05_phong", mean_of_bytes(2));
    let on_circle = RgbImage::from_fn(640, 360, |i, j| {
        let places = (0..8).map(|k| f64::from(k).sin_cos());
        let colours = places.map(|(s, c)| colour(&OBJECTS, &ray(i, j, (s / 2.0, c / 2.0))));
        rgb8(colours.sum::<DVec3>() / 8.0)
    });
    answers.add_picture("samples on a circle", "step03_nearest", on_circle);
    let scattered = RgbImage::from_fn(640, 360, |i, j| {
        let [u, v] = [101, 97].map(|n| f64::from((i * 31 + j * 17) * 7919 % n) / f64::from(n));
        rgb8(direction_colour(&ray(i, j, (u - 0.5, v - 0.5))))
    });
    answers.add_picture("a random place in each pixel", "step01_rays", scattered);
    let corners =
        RgbImage::from_fn(640, 360, |i, j| rgb8(colour(&OBJECTS, &ray(i, j, (0.5, -0.5)))));
    answers.add_picture("the corner of each pixel", "step03_nearest", corners);
    answers.assert_locked("means_and_samples");
}

#[test]
fn other_skies_and_bytes_are_as_locked() {
    let mut answers = Answers::new();
    let skies: Titled<fn(&Ray) -> DVec3, 4> = [
        ("white to blue", |ray| {
            let t = 0.5 + 0.5 * ray.direction.normalize().y;
            (1.0 - t) * DVec3::ONE + t * DVec3::new(0.5, 0.7, 1.0)
        }),
        ("weak", |ray| 0.6 + 0.2 * ray.direction * DVec3::new(1.0, 1.0, -1.0)),
        ("strong", |ray| 0.7 + 0.35 * ray.direction * DVec3::new(1.0, 1.0, -1.0)),
        ("grey", |_| DVec3::splat(0.4)),
    ];
    for (title, sky) in skies {
        let ball = step02_sphere::SPHERE;
        let shown = |step: Step, ray: &Ray| match step {
            Step::Sphere if ball.intersect(ray).first_hit().is_some() => {
                step02_sphere::colour(&ball, ray)
            }
            Step::Nearest => {
                nearest(&OBJECTS, ray).map_or_else(|| sky(ray), |hit| hit.object.material)
            }
            _ => sky(ray),
        };
        for step in [Step::Rays, Step::Sphere, Step::Nearest] {
            let title = format!("{title} sky, step {}", step.number());
            answers.add_picture(&title, step.name(), draw(|ray| shown(step, ray)));
        }
    }
    let bytes: Titled<fn(f64) -> u8, 6> = [
        ("255.99·I cut off", |i| (255.99 * i) as u8),
        ("gamma 2", |i| (255.0 * i.sqrt() + 0.5) as u8),
        ("a negative", |i| (255.0 * (1.0 - i) + 0.5) as u8),
        ("half as bright", |i| (127.5 * i + 0.5) as u8),
        ("in tens", |i| ((25.5 * i) as u8).min(25) * 10),
        ("at most 254", |i| (255.0 * i + 0.5).min(254.0) as u8),
    ];
    for (title, byte) in bytes {
        for (name, objects) in [("step01_rays", &[][..]), ("step03_nearest", &OBJECTS)] {
            let camera = camera();
            let pixel = |i: u32, j: u32| colour(objects, &camera.ray(i.into(), j.into()));
            let picture = RgbImage::from_fn(640, 360, |i, j| Rgb(pixel(i, j).to_array().map(byte)));
            answers.add_picture(&format!("{title}, {name}"), name, picture);
        }
    }
    answers.assert_locked("other_skies_and_bytes");
}

type Hits<'a> = [(f64, &'a Object<DVec3>)];

/// The number of the hit with the least key.
fn least(hits: &Hits, key: impl Fn(&(f64, &Object<DVec3>)) -> f64) -> Option<usize> {
    (0..hits.len()).min_by(|a, b| key(&hits[*a]).total_cmp(&key(&hits[*b])))
}

#[test]
fn other_ways_to_choose_a_hit_are_as_locked() {
    let choices: Titled<fn(&Hits) -> Option<usize>, 6> = [
        ("t as a whole number", |hits| least(hits, |hit| hit.0.floor())),
        ("nearer only by 0.5", |hits| {
            (0..hits.len()).reduce(|best, k| if hits[k].0 < hits[best].0 - 0.5 { k } else { best })
        }),
        ("the nearer centre", |hits| least(hits, |hit| hit.1.sphere.centre.length())),
        ("the smaller ball", |hits| least(hits, |hit| hit.1.sphere.radius)),
        ("the second", |hits| {
            let first = least(hits, |hit| hit.0)?;
            (0..hits.len()).find(|k| *k != first).or(Some(first))
        }),
        ("no ball with a long name", |hits| {
            least(hits, |hit| hit.0 + 100.0 * (hit.1.name.len() / 12) as f64)
        }),
    ];
    let mut answers = Answers::new();
    for (title, choose) in choices {
        let picture = draw(|ray| {
            let hits = OBJECTS.iter();
            let hits = hits.filter_map(|one| Some((one.sphere.intersect(ray).first_hit()?, one)));
            let hits: Vec<_> = hits.collect();
            choose(&hits).map_or_else(|| direction_colour(ray), |k| hits[k].1.material)
        });
        answers.add_picture(title, "step03_nearest", picture);
    }
    let in_boxes = draw(|ray| {
        let is_near = |one: &&Object<DVec3>| {
            let t = one.sphere.centre.dot(ray.direction) / ray.direction.length_squared();
            (ray.at(t) - one.sphere.centre).abs().max_element() < 0.5 * one.sphere.radius
        };
        colour(&OBJECTS.iter().filter(is_near).copied().collect::<Vec<_>>(), ray)
    });
    answers.add_picture("a box half as large as the ball", "step03_nearest", in_boxes);
    answers.assert_locked("other_ways_to_choose_a_hit");
}

#[test]
fn other_ways_to_add_light_are_as_locked() {
    let scene = step04_diffuse::scene();
    let sums: Titled<Add, 5> = [
        ("the first light behind ends the loop", |sum, term, cosine| {
            (0.0 < cosine).then_some(sum + term)
        }),
        ("light is added only below 1", |sum, term, _| {
            Some(if sum.max_element() < 1.0 { sum + term } else { sum })
        }),
        ("the brighter of both", |sum, term, _| Some(sum.max(term))),
        ("lit by steps", |sum, term, cosine| Some(if 0.5 < cosine { sum + term } else { sum })),
        ("clamped after each light", |sum, term, _| Some((sum + term).min(DVec3::splat(0.9)))),
    ];
    let mut answers = Answers::new();
    for (title, add) in sums {
        let picture = draw(|ray| {
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
        });
        answers.add_picture(title, "step04_diffuse", picture);
    }
    let scene = step05_phong::scene();
    let clamped = draw(|ray| match terms(&scene, ray) {
        None => direction_colour(ray),
        Some(terms) => terms.ambient + terms.diffuse + terms.specular.min(DVec3::splat(0.2)),
    });
    answers.add_picture("highlights are clamped", "step05_phong", clamped);
    let metal = draw_changed_scene(|scene| {
        scene.objects.iter_mut().for_each(|one| one.material.specular = one.material.matte.diffuse);
    });
    answers.add_picture("spheres shine as metal", "step05_phong", metal);
    answers.assert_locked("other_ways_to_add_light");
}

#[test]
fn missing_and_noisy_pixels_are_as_locked() {
    let mut answers = Answers::new();
    let name = "step05_phong";
    let blocks: Titled<fn(u32, u32) -> bool, 7> = [
        ("the last row is never drawn", |_, j| j == 359),
        ("the last column is never drawn", |i, _| i == 639),
        ("the lower ten rows", |_, j| 350 <= j),
        ("every other row", |_, j| j % 2 == 1),
        ("a ninth in the middle", |i, j| i / 213 == 1 && j / 120 == 1),
        ("the corners", |i, j| i + j < 20),
        ("one black pixel", |i, j| (i, j) == (320, 180)),
    ];
    for (title, is_black) in blocks {
        let picture = map_locked(name, |i, j, ours| if is_black(i, j) { [0; 3] } else { ours });
        answers.add_picture(title, name, picture);
    }
    let changes: Titled<fn(u32, u32, u8) -> u8, 3> = [
        ("last digits", |i, j, b| b.saturating_add(u8::from((i * 640 + j * 7) % 9973 == 0))),
        ("noise", |i, j, b| b.saturating_add((i * 7919 % 5 + j % 2) as u8).saturating_sub(2)),
        ("half of it in other bits", |i, _, b| if i < 320 { b } else { b ^ 0x15 }),
    ];
    for (title, change) in changes {
        let picture = map_locked(name, |i, j, ours| ours.map(|byte| change(i, j, byte)));
        answers.add_picture(title, name, picture);
    }
    answers.add_picture("blurred", name, blur(&locked_picture(name), 2.0));
    let waves = RgbImage::from_fn(640, 360, |i, j| Rgb([(i * j / 64) as u8, (i ^ j) as u8, 255]));
    for name in ["step02_sphere", "glass"] {
        answers.add_picture(&format!("waves for {name}"), name, waves.clone());
    }
    answers.assert_locked("missing_and_noisy_pixels");
}
