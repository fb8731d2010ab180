//! Snapshot tests of the answers about small pictures. Checking a small picture takes little time.
//! In an answer, many sentences about wrong pixels have a condition, such as a minimum number of
//! pixels. For many of these sentences, one picture just meets the condition, and another picture
//! just misses the condition.

use crate::{assert_locked, encode, format_answer};
use check::check_png;
use course::{Step, camera_with_size, find_draw_function};
use glam::DVec3;
use image::imageops::{flip_horizontal, flip_vertical, rotate90, rotate180, rotate270};
use image::{Rgb, RgbImage};
use step01_rays::{direction_colour, rgb8};
use step05_phong::{Light, Material, Ray, Scene, phong, visible_point};

const COLUMNS: u32 = 64;
const ROWS: u32 = 36;

/// Draws the course's picture `name` at the small size.
fn draw_small(name: &str) -> Result<RgbImage, String> {
    let draw = find_draw_function(name).ok_or("no such picture")?;
    Ok(draw(&camera_with_size(COLUMNS, ROWS), 1))
}

fn draw_small_step(step: Step) -> RgbImage {
    draw_small(step.name()).expect("each step has a picture")
}

/// Draws the picture of a step and changes its pixels. `change` turns a pixel's column, row and
/// colour into a new colour.
fn map_small(step: Step, change: impl Fn(u32, u32, [u8; 3]) -> [u8; 3]) -> RgbImage {
    let ours = draw_small_step(step);
    RgbImage::from_fn(COLUMNS, ROWS, |i, j| Rgb(change(i, j, ours[(i, j)].0)))
}

/// Draws a small picture. `colour` returns the colour of each ray.
fn draw(colour: impl Fn(&Ray) -> DVec3) -> RgbImage {
    let camera = camera_with_size(COLUMNS, ROWS);
    RgbImage::from_fn(COLUMNS, ROWS, |i, j| rgb8(colour(&camera.ray(i.into(), j.into()))))
}

/// Compares the answers about these pictures with the snapshot `name`. Leaves out the end of each
/// answer, which names `by_hand` tests and a pixel.
#[track_caller]
fn assert_small_locked(name: &str, rows: impl IntoIterator<Item = (&'static str, Step, RgbImage)>) {
    let answer = |(title, step, picture): (&str, Step, RgbImage)| {
        let answer = check_png(&encode(picture), "my.png", Some(step.name()), draw_small);
        let text = format_answer(answer);
        let end = text.find("The tests by hand").unwrap_or(text.len());
        (format!("{title}, {}", step.name()), text[..end].to_owned())
    };
    assert_locked(name, rows.into_iter().map(answer));
}

#[test]
fn facts_of_small_pictures_are_as_locked() {
    use Step::{Diffuse, Nearest, Phong, Rays, Sphere};
    let ours = draw_small_step(Nearest);
    let number = |i: u32, j: u32| COLUMNS * j + i;
    let ray_colour = |scene: &Scene<Material, Light>, ray: &Ray, terms: fn([DVec3; 5]) -> DVec3| {
        let Some(point) = visible_point(&scene.objects, ray) else { return direction_colour(ray) };
        let terms_of_lights = |lights: &[Light]| phong(&point, ray, scene.ambient_light, lights);
        let [warm, cool] = [0, 1].map(|k| terms_of_lights(&scene.lights[k..=k]));
        terms([warm.ambient, warm.diffuse, cool.diffuse, warm.specular, cool.specular])
    };
    let scene = step05_phong::scene();
    let picture_from_terms =
        |terms: fn([DVec3; 5]) -> DVec3| draw(|ray| ray_colour(&scene, ray, terms));
    let grey = |channel: usize| move |_, _, ours: [u8; 3]| [ours[channel]; 3];
    let is_sphere = |i, j| draw_small_step(Sphere)[(i, j)].0 == [232, 87, 71];
    let only_objects = |change: fn([u8; 3]) -> [u8; 3]| {
        let sky = draw_small_step(Rays);
        map_small(Phong, move |i, j, ours| if ours == sky[(i, j)].0 { ours } else { change(ours) })
    };
    // Changes `count` pixels of the red sphere. Five of these pixels show the sky, and the rest are
    // nearly black.
    let few_show_the_sky = |count: usize| {
        let (mut picture, sky) = (draw_small_step(Nearest), draw_small_step(Rays));
        let red = picture.enumerate_pixels().filter(|(_, _, colour)| colour.0 == [232, 87, 71]);
        let positions: Vec<_> = red.map(|(i, j, _)| (i, j)).take(count).collect();
        for (k, position) in positions.into_iter().enumerate() {
            picture[position] = if k < 5 { sky[position] } else { Rgb([9; 3]) };
        }
        picture
    };
    assert_small_locked(
        "small_facts",
        [
            // These pictures have wrong bytes.
            ("our red", Nearest, map_small(Nearest, grey(0))),
            ("our green", Nearest, map_small(Nearest, grey(1))),
            ("our blue", Nearest, map_small(Nearest, grey(2))),
            (
                "one column to the left",
                Nearest,
                map_small(Nearest, |i, j, _| ours[((i + 1).min(63), j)].0),
            ),
            (
                "one column to the right",
                Nearest,
                map_small(Nearest, |i, j, _| ours[(i.saturating_sub(1), j)].0),
            ),
            ("one row up", Nearest, map_small(Nearest, |i, j, _| ours[(i, (j + 1).min(35))].0)),
            (
                "one row down",
                Nearest,
                map_small(Nearest, |i, j, _| ours[(i, j.saturating_sub(1))].0),
            ),
            (
                "two columns to the left",
                Nearest,
                map_small(Nearest, |i, j, _| ours[((i + 2).min(63), j)].0),
            ),
            (
                "two columns to the right",
                Nearest,
                map_small(Nearest, |i, j, _| ours[(i.saturating_sub(2), j)].0),
            ),
            (
                "two rows down",
                Nearest,
                map_small(Nearest, |i, j, _| ours[(i, j.saturating_sub(2))].0),
            ),
            ("two rows up", Nearest, map_small(Nearest, |i, j, _| ours[(i, (j + 2).min(35))].0)),
            (
                "15 wrong pixels",
                Nearest,
                map_small(Nearest, |i, j, c| {
                    if number(i, j) % 150 == 0 && number(i, j) < 2250 { [9; 3] } else { c }
                }),
            ),
            (
                "16 wrong pixels",
                Nearest,
                map_small(Nearest, |i, j, c| if number(i, j) % 150 == 0 { [9; 3] } else { c }),
            ),
            (
                "one right colour",
                Sphere,
                map_small(Sphere, |i, j, c| if is_sphere(i, j) { [9; 3] } else { c }),
            ),
            (
                "4 right colours",
                Nearest,
                map_small(
                    Nearest,
                    |i, j, c| if j > 8 && i < 25 && c[2] != 255 { [9, 8, 7] } else { c },
                ),
            ),
            (
                "two wrong colours",
                Nearest,
                map_small(Nearest, |i, j, c| if j < 10 { [9, 9, (i % 2) as u8] } else { c }),
            ),
            // These pictures are made from ours by a rule for bytes, such as halving each byte.
            ("falling bytes", Phong, map_small(Phong, |_, _, c| c.map(|b| 255 - b))),
            ("falling bytes", Rays, map_small(Rays, |_, _, c| c.map(|b| 255 - b))),
            ("half", Sphere, map_small(Sphere, |_, _, c| c.map(|b| b / 2))),
            ("half", Nearest, map_small(Nearest, |_, _, c| c.map(|b| b / 2))),
            (
                "half of the objects",
                Nearest,
                map_small(Nearest, |i, j, c| {
                    if c == draw_small_step(Rays)[(i, j)].0 { c } else { c.map(|b| b / 2) }
                }),
            ),
            (
                "the sky alone",
                Diffuse,
                map_small(Diffuse, |i, j, c| {
                    if c == draw_small_step(Rays)[(i, j)].0 { c.map(|b| b / 2) } else { c }
                }),
            ),
            (
                "255 wraps",
                Phong,
                map_small(Phong, |_, _, c| c.map(|b| if b == 255 { 0 } else { b })),
            ),
            ("255 wraps", Rays, map_small(Rays, |_, _, c| c.map(|b| if b == 255 { 0 } else { b }))),
            (
                "objects' dark bytes halved",
                Phong,
                only_objects(|c| c.map(|b| if b < 100 { b / 2 } else { b })),
            ),
            (
                "few of the objects' bytes",
                Phong,
                only_objects(|c| c.map(|b| if b < 60 && b % 8 == 0 { b / 2 } else { b })),
            ),
            (
                "16 of the objects' bytes",
                Phong,
                only_objects(|c| c.map(|b| if (100..116).contains(&b) { b / 2 } else { b })),
            ),
            (
                "15 of the objects' bytes",
                Phong,
                only_objects(|c| c.map(|b| if (100..115).contains(&b) { b / 2 } else { b })),
            ),
            (
                "bright bytes fold",
                Phong,
                map_small(Phong, |_, _, c| {
                    c.map(|b| if b > 200 { 400u16.saturating_sub(b.into()) as u8 } else { b })
                }),
            ),
            (
                "one byte twice",
                Phong,
                map_small(Phong, |i, _, c| c.map(|b| if b == 255 && i % 2 == 0 { 0 } else { b })),
            ),
            // These pictures have wrong light.
            ("without ambient", Phong, picture_from_terms(|[_, b, c, d, e]| b + c + d + e)),
            ("without warm diffuse", Phong, picture_from_terms(|[a, _, c, d, e]| a + c + d + e)),
            ("without cool diffuse", Phong, picture_from_terms(|[a, b, _, d, e]| a + b + d + e)),
            ("without warm specular", Phong, picture_from_terms(|[a, b, c, _, e]| a + b + c + e)),
            ("without cool specular", Phong, picture_from_terms(|[a, b, c, d, _]| a + b + c + d)),
            ("without both diffuse", Phong, picture_from_terms(|[a, _, _, d, e]| a + d + e)),
            ("without ambient and specular", Phong, picture_from_terms(|[_, b, c, _, _]| b + c)),
            ("without ambient", Diffuse, picture_from_terms(|[_, b, c, _, _]| b + c)),
            ("without cool", Diffuse, picture_from_terms(|[a, b, _, _, _]| a + b)),
            ("black objects", Diffuse, picture_from_terms(|_| DVec3::ZERO)),
            ("twice ambient", Phong, picture_from_terms(|[a, b, c, d, e]| 2.0 * a + b + c + d + e)),
            (
                "scaled above 1",
                Phong,
                draw(|ray| {
                    let colour = step05_phong::colour(&scene, ray);
                    colour / colour.max_element().max(1.0)
                }),
            ),
            (
                "more above 1",
                Phong,
                map_small(
                    Phong,
                    |i, j, c| if c[0] == 255 || (i, j) == (0, 0) { [1, c[1], c[2]] } else { c },
                ),
            ),
            // These pictures have wrong regions.
            (
                "first object alone",
                Nearest,
                draw(|ray| step03_nearest::colour(&step03_nearest::OBJECTS[..1], ray)),
            ),
            (
                "three objects",
                Nearest,
                draw(|ray| step03_nearest::colour(&step03_nearest::OBJECTS[..3], ray)),
            ),
            (
                "a few show the sky",
                Nearest,
                map_small(Nearest, |i, j, c| {
                    if number(i, j) % 97 == 0 {
                        draw_small_step(Rays)[(i, j)].0
                    } else if i == 40 {
                        [9; 3]
                    } else {
                        c
                    }
                }),
            ),
            (
                "a tenth shows the sky",
                Nearest,
                map_small(Nearest, |i, j, c| {
                    if j == 20 && c[2] != 255 {
                        if i < 6 { draw_small_step(Rays)[(i, j)].0 } else { [9; 3] }
                    } else {
                        c
                    }
                }),
            ),
            ("5 of 50 show the sky", Nearest, few_show_the_sky(50)),
            ("5 of 51 show the sky", Nearest, few_show_the_sky(51)),
            (
                "sky and one object",
                Nearest,
                map_small(Nearest, |_, _, c| if c[2] == 255 || c[0] == 41 { [1, 2, 3] } else { c }),
            ),
            (
                "one object",
                Nearest,
                map_small(Nearest, |_, _, c| if c[0] == 41 { [1, 2, 3] } else { c }),
            ),
            (
                "sky",
                Nearest,
                map_small(Nearest, |_, _, c| if c[2] == 255 { [1, 2, c[0]] } else { c }),
            ),
            (
                "a pixel",
                Phong,
                map_small(Phong, |i, j, c| if (i, j) == (20, 20) { [1, 2, 3] } else { c }),
            ),
        ],
    );
}

#[test]
fn answers_about_shapes_of_undrawn_pixels_are_as_locked() {
    let of_colour = |colour, is_undrawn: fn(u32, u32) -> bool| {
        map_small(Step::Rays, |i, j, ours| if is_undrawn(i, j) { colour } else { ours })
    };
    let black = |is_undrawn| of_colour([0; 3], is_undrawn);
    let white = |is_undrawn| of_colour([255; 3], is_undrawn);
    let rows = [
        ("a row", black(|_, j| j == 7)),
        ("two rows", black(|_, j| j == 7 || j == 8)),
        ("three rows", black(|_, j| j == 7 || j == 8 || j == 20)),
        ("a column and 3 more", black(|i, _| i == 7 || i % 21 == 20)),
        ("columns", white(|i, _| (10..20).contains(&i))),
        ("every 2nd row", black(|_, j| j % 2 == 0)),
        ("every 3rd column", white(|i, _| i % 3 == 1)),
        ("every 4th row", black(|_, j| j % 4 == 3)),
        ("every 11th column", black(|i, _| i % 11 == 3)),
        ("every 12th column", black(|i, _| i % 12 == 3)),
        ("every 13th column", black(|i, _| i % 13 == 3)),
        ("every 21st column", black(|i, _| i % 21 == 3)),
        ("100 pixels", black(|i, j| i < 10 && j < 10)),
        ("99 pixels", black(|i, j| i < 11 && j < 9)),
        ("a rectangle", black(|i, j| (5..30).contains(&i) && (3..12).contains(&j))),
        ("crossings", black(|i, j| i % 2 == 0 && j % 2 == 1)),
        (
            "four rectangles",
            black(|i, j| {
                (i / 9, j / 9) == (0, 1)
                    || (i / 9, j / 9) == (2, 0)
                    || (i / 9, j / 9) == (3, 3)
                    || (i / 9, j / 9) == (5, 2)
            }),
        ),
        (
            "five rectangles",
            black(|i, j| [(0, 1), (2, 0), (3, 3), (5, 2), (6, 1)].contains(&(i / 9, j / 9))),
        ),
        ("to the end", black(|i, j| 64 * j + i >= 1000)),
        ("from the start", white(|i, j| 64 * j + i < 1000)),
        ("a bar on the left", black(|i, _| i < 5)),
        ("bars on both sides", black(|i, _| !(5..60).contains(&i))),
        ("bars of one pixel", black(|i, j| i == 0 || i == 63 || j == 0)),
        ("bars above and below", black(|_, j| !(2..33).contains(&j))),
        ("left and below", black(|i, j| i < 2 || j > 33)),
        ("a frame of one pixel", black(|i, j| i == 0 || j == 0 || i == 63 || j == 35)),
        ("a frame", white(|i, j| !(3..62).contains(&i) || !(1..31).contains(&j))),
        (
            "a frame around 100 pixels",
            black(|i, j| !(10..20).contains(&i) || !(10..20).contains(&j)),
        ),
        (
            "a frame around 99 pixels",
            black(|i, j| !(10..21).contains(&i) || !(10..19).contains(&j)),
        ),
        (
            "a frame with a spot",
            black(|i, j| !(3..62).contains(&i) || !(1..31).contains(&j) || (i, j) == (9, 9)),
        ),
        ("lines between tiles", black(|i, j| i % 8 == 7 || j % 8 == 7)),
        ("a cross", black(|i, j| i == 30 || j == 10)),
        ("every 3rd pixel", black(|i, j| (64 * j + i) % 3 == 2)),
        ("two of five pixels", black(|i, j| (64 * j + i) % 5 < 2)),
        ("every 9th diagonal", black(|i, j| (i + 72 - j) % 9 == 4)),
        ("rising diagonals", white(|i, j| (i + j) % 9 < 2)),
        ("a triangle", black(|i, j| i < j)),
        (
            "a triangle and a spot",
            map_small(Step::Rays, |i, j, c| {
                if i < j {
                    [0; 3]
                } else if (i, j) == (40, 3) {
                    [7; 3]
                } else {
                    c
                }
            }),
        ),
        (
            "rows and a spot",
            map_small(Step::Rays, |i, j, c| {
                if j % 3 == 0 {
                    [0; 3]
                } else if (i, j) == (40, 4) {
                    [7; 3]
                } else {
                    c
                }
            }),
        ),
        ("all but a pixel", black(|i, j| (i, j) != (20, 30))),
        ("grey rows", of_colour([1; 3], |_, j| j % 2 == 0)),
    ];
    let rows = rows.map(|(title, picture)| (title, Step::Rays, picture)).into_iter();
    let sky = draw_small_step(Step::Rays);
    let map_nearest =
        |change: &dyn Fn(u32, u32, [u8; 3]) -> [u8; 3]| map_small(Step::Nearest, change);
    let nearest_rows = [
        ("a black sky", map_nearest(&|i, j, c| if c == sky[(i, j)].0 { [0; 3] } else { c })),
        ("black objects", map_nearest(&|i, j, c| if c == sky[(i, j)].0 { c } else { [0; 3] })),
        (
            "black but a pixel of the sky",
            map_nearest(&|i, j, c| if (i, j) == (0, 0) { c } else { [0; 3] }),
        ),
        (
            "half of the black sky",
            map_nearest(&|i, j, c| if c == sky[(i, j)].0 && (i * j) % 7 < 3 { [0; 3] } else { c }),
        ),
        (
            "white rows of the objects",
            map_nearest(&|_, j, c| if j > 20 && j % 2 == 0 { [255; 3] } else { c }),
        ),
    ];
    let nearest_rows = nearest_rows.map(|(title, picture)| (title, Step::Nearest, picture));
    assert_small_locked("small_shapes", rows.chain(nearest_rows));
}

#[test]
fn answers_about_transformed_pictures_are_as_locked() {
    let ours = draw_small_step(Step::Nearest);
    let swapped = |order: [usize; 3]| map_small(Step::Nearest, move |_, _, c| order.map(|k| c[k]));
    let part = |i, j, w, h| image::imageops::crop_imm(&ours, i, j, w, h).to_image();
    let enlarged = |times: u32| {
        RgbImage::from_fn(times * COLUMNS, times * ROWS, |i, j| ours[(i / times, j / times)])
    };
    let mut spotted = enlarged(3);
    spotted[(100, 50)] = Rgb([9; 3]);
    let mut spotted_part = part(10, 5, 40, 20);
    spotted_part[(39, 19)] = Rgb([9; 3]);
    let mut uniform_but_last = RgbImage::new(COLUMNS, ROWS);
    uniform_but_last[(63, 35)] = Rgb([0, 0, 1]);
    let mut uniform_but_first = RgbImage::new(COLUMNS, ROWS);
    uniform_but_first[(0, 0)] = Rgb([1, 0, 0]);
    let wide = RgbImage::from_fn(2 * COLUMNS, ROWS, |i, j| ours[(i / 2, j)]);
    let rows = [
        ("upside down", flip_vertical(&ours)),
        ("mirrored", flip_horizontal(&ours)),
        ("half a turn", rotate180(&ours)),
        ("a quarter", rotate90(&ours)),
        ("three quarters", rotate270(&ours)),
        ("transposed", rotate90(&flip_vertical(&ours))),
        ("blue, green, red", swapped([2, 1, 0])),
        ("green, red, blue", swapped([1, 0, 2])),
        ("red, blue, green", swapped([0, 2, 1])),
        ("green, blue, red", swapped([1, 2, 0])),
        ("mirrored, and blue, green, red", flip_horizontal(&swapped([2, 1, 0]))),
        ("a part", part(10, 5, 40, 20)),
        ("the last columns", part(14, 0, 50, 36)),
        ("the last rows", part(0, 16, 64, 20)),
        ("the first row and 36 columns", part(0, 0, 36, 1)),
        ("100 pixels", part(20, 10, 10, 10)),
        ("99 pixels", part(20, 10, 11, 9)),
        ("a part with a spot", spotted_part),
        ("twice", enlarged(2)),
        ("three times", enlarged(3)),
        ("three times with a spot", spotted),
        ("wide", wide),
        ("one colour", RgbImage::new(COLUMNS, ROWS)),
        ("one colour but the last", uniform_but_last),
        ("one colour but the first", uniform_but_first),
        ("a row more", RgbImage::from_fn(64, 37, |i, j| ours[(i, j.min(35))])),
    ];
    assert_small_locked(
        "small_wholes",
        rows.map(|(title, picture)| (title, Step::Nearest, picture)),
    );
}
