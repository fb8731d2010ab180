//! Pictures that are no render, or not quite: each is told in plain words.

use super::{locked, made, named, right};
use ::check::{Answer, check, look};
use gallery::{Parts, Step, camera, mistakes};
use image::imageops::{FilterType, crop_imm, overlay, resize};
use image::{DynamicImage, ImageFormat};
use image::{Rgb, RgbImage, Rgba, RgbaImage};
use std::f64::consts::PI;
use std::io::Cursor;
use step01_rays::Camera;
use tests::{is_thorough, some};

/// Fails unless the first words are these, and nothing is measured.
fn assert_told(picture: &RgbImage, words: &str) {
    let Answer { code, text, .. } = look(picture, Some("step05_phong"), locked());
    assert_eq!(code, 1, "{text}");
    assert!(text.starts_with("Not right yet: "), "{text}");
    assert!(text.contains(words), "{words}: {text}");
    assert!(!text.contains("Stage by stage"), "{text}");
}

#[test]
fn scaled_and_cut_pictures_are_told() {
    let ours = right("step05_phong");
    // Smaller, by both, and larger.
    let cases = [
        (FilterType::Triangle, 240, 135),
        (FilterType::Lanczos3, 160, 90),
        (FilterType::Triangle, 800, 450),
    ];
    for (filter, width, height) in some(cases, 3) {
        let size = format!("made into {width}×{height}.");
        assert_told(&resize(&ours, width, height, filter), &size);
    }
    let part = crop_imm(&ours, 100, 50, 300, 200).to_image();
    assert_told(&part, "its columns 100 to 399 and rows 50 to 249.");
    let mut shot = RgbImage::from_pixel(800, 500, Rgb([220; 3]));
    overlay(&mut shot, &ours, 30, 60);
    assert_told(&shot, "from column 30 and row 60 on.");
    let wrong = made(Step::Phong, &["no-exponent"], (240, 135), 1);
    let twice = resize(&wrong, 480, 270, FilterType::Nearest);
    assert_told(&twice, "Each pixel stands there 2×2 times");
}

/// What is nearly ours, scaled, is told from what was drawn so, of one ray or of many.
#[test]
fn what_was_drawn_in_another_size_was_not_scaled() {
    for samples in [1, 2] {
        let mut parts = Parts::right(&camera(480, 270));
        parts.materials().for_each(|material| material.shininess += 1);
        let picture = parts.picture(Step::Phong, samples);
        let Answer { text, .. } = look(&picture, Some("step05_phong"), locked());
        let words = "specular, warm     WRONG";
        assert!(text.contains(words) && !text.contains("scaled"), "{text}");
    }
}

#[test]
fn changed_colours_are_told() {
    let ours = right("step05_phong");
    let changed = |change: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let mut picture = ours.clone();
        for pixel in picture.pixels_mut() {
            let part = change(pixel.0.map(|c| f64::from(c) / 255.0));
            pixel.0 = part.map(|c| (255.0 * c + 0.5) as u8);
        }
        picture
    };
    let power = |c: f64| c.powf(1.0 / 1.8);
    assert_told(&changed(&|rgb| rgb.map(power)), "to the power 1/1.8");
    let luma = |[r, g, b]: [f64; 3]| [0.299 * r + 0.587 * g + 0.114 * b; 3];
    assert_told(
        &changed(&luma),
        "0.299 red + 0.587 green + 0.114 blue of the picture",
    );
    assert_told(&changed(&|[_, g, _]| [g; 3]), "green alone of the picture");
}

#[test]
fn grey_is_no_fault_where_ours_is_grey() {
    let mut picture = right("depth");
    picture.pixels_mut().for_each(|pixel| pixel.0 = pixel.0.map(|c| c / 2));
    let Answer { code, text, .. } = look(&picture, Some("depth"), locked());
    assert_eq!(code, 1, "{text}");
    assert!(
        text.starts_with("Not right yet: ") && !text.contains("grey"),
        "{text}"
    );
}

/// What JPEG makes of a picture: the squares' cosine sums, rounded to multiples of `q`.
fn squared(picture: &RgbImage, q: f64) -> RgbImage {
    let wave = |u: usize, x: usize| {
        let scale = if u == 0 { (1.0_f64 / 8.0).sqrt() } else { 0.5 };
        scale * ((2 * x + 1) as f64 * u as f64 * PI / 16.0).cos()
    };
    let waves: [[f64; 8]; 8] =
        std::array::from_fn(|u| std::array::from_fn(|x| wave(u, x)));
    let turn = |square: [[f64; 8]; 8], is_back: bool| -> [[f64; 8]; 8] {
        let wave =
            |u: usize, x: usize| if is_back { waves[x][u] } else { waves[u][x] };
        let row = |row: [f64; 8]| -> [f64; 8] {
            std::array::from_fn(|u| (0..8).map(|x| wave(u, x) * row[x]).sum())
        };
        let rows = square.map(row);
        let columns: [[f64; 8]; 8] =
            std::array::from_fn(|i| row(rows.map(|row| row[i])));
        std::array::from_fn(|j| columns.map(|column| column[j]))
    };
    let mut squared = picture.clone();
    for (i, j, k) in (0..picture.width() / 8)
        .flat_map(|i| (0..picture.height() / 8).map(move |j| (i, j)))
        .flat_map(|(i, j)| (0..3).map(move |k| (8 * i, 8 * j, k)))
    {
        let square = std::array::from_fn(|y| {
            std::array::from_fn(|x| {
                f64::from(picture.get_pixel(i + x as u32, j + y as u32)[k])
            })
        });
        let rounded =
            turn(square, false).map(|row| row.map(|c| (c / q).round() * q));
        for (y, row) in turn(rounded, true).into_iter().enumerate() {
            for (x, c) in row.into_iter().enumerate() {
                squared.get_pixel_mut(i + x as u32, j + y as u32)[k] =
                    c.round() as u8;
            }
        }
    }
    squared
}

#[test]
fn a_jpeg_is_told_and_nothing_else_is_one() {
    let cases = [("step02_sphere", 9.0), ("step05_phong", 30.0)];
    for (name, q) in some(cases, 2) {
        let text = look(&squared(&right(name), q), Some(name), locked()).text;
        assert!(text.contains("it was a JPEG"), "{name}, {q}: {text}");
    }
    // Neither right nor wrong pictures are taken for what they are not.
    for mistake in some(mistakes().step_by(40), 3) {
        let mut parts = gallery::Parts::right(&camera(128, 72));
        (mistake.change)(&mut parts);
        // So that no name explains it.
        parts.scene.lights.iter_mut().for_each(|light| light.specular *= 0.83);
        let picture = parts.picture(Step::Phong, 1);
        let text = look(&picture, Some("step05_phong"), locked()).text;
        for words in
            ["JPEG", "scaled", "cut out", "screenshot", "is grey", "gamma,"]
        {
            assert!(!text.contains(words), "{}: {text}", mistake.name);
        }
    }
}

/// The bytes of a PNG file.
fn png(picture: impl Into<DynamicImage>) -> Vec<u8> {
    let mut png = Cursor::new(vec![]);
    picture.into().write_to(&mut png, ImageFormat::Png).expect("a picture");
    png.into_inner()
}

#[test]
fn other_kinds_of_png_are_told() {
    let ours = DynamicImage::from(right("step02_sphere"));
    let grey = png(ours.to_luma8());
    let deep = png(ours.to_rgb16());
    let colours = ours.to_rgb8();
    let clear = RgbaImage::from_fn(640, 360, |i, j| {
        let [r, g, b] = colours.get_pixel(i, j).0;
        Rgba([r, g, b, if i == 9 { 0 } else { 255 }])
    });
    let all = [
        (grey, 1, "The file is grey: "),
        (deep, 0, "The file has 16 bits a channel"),
        (palette(), 1, "The file has a palette: "),
    ];
    for (png, code, words) in all {
        let answer =
            check(Cursor::new(png), "my.png", Some("step02_sphere"), locked());
        assert_eq!(answer.code, code, "{}", answer.text);
        assert!(answer.text.contains(words), "{}", answer.text);
    }
    let small = crop_imm(&clear, 0, 0, 640, 360).to_image();
    let answer = check(Cursor::new(png(small)), "my.png", None, locked());
    assert!(
        answer.code == 0 && answer.text.contains("transparent"),
        "{}",
        answer.text
    );
}

/// A file of two colours with a palette.
fn palette() -> Vec<u8> {
    let mut file = vec![];
    let mut encoder = png::Encoder::new(&mut file, 640, 360);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_palette(vec![232, 87, 71, 200, 200, 255]);
    let mut writer = encoder.write_header().expect("a header");
    let pixels: Vec<u8> = (0..640 * 360).map(|k| u8::from(k % 7 == 0)).collect();
    writer.write_image_data(&pixels).expect("pixels");
    drop(writer);
    file
}

#[test]
fn another_field_of_view_is_told_as_an_option() {
    for (fov, samples) in some([(30.0_f64, 1), (75.5, 2), (110.0, 1)], 3) {
        let camera = Camera::new(200, 150, fov.to_radians());
        let picture = Step::Phong.picture(&camera, samples);
        let text = look(&picture, Some("step05_phong"), locked()).text;
        assert!(text.starts_with("Right but for its field of view"), "{text}");
        assert!(text.contains(&format!("Its field of view is {fov}°")), "{text}");
        let wrong = named("inward").picture_in(Step::Phong, &camera, samples);
        let text = look(&wrong, Some("step05_phong"), locked()).text;
        assert!(text.contains("what you get when normals point into"), "{text}");
        assert!(text.contains("--fov 60 gives that"), "{text}");
    }
    // Where an option explains as much as a mistake does, both are said.
    let twice = Step::Phong.picture(&Camera::new(200, 150, 2.0 * PI / 3.0), 1);
    let text = look(&twice, Some("step05_phong"), locked()).text;
    assert!(text.contains(named("full-angle").when), "{text}");
    assert!(text.contains("You get the same picture with --fov 120."), "{text}");
    // A mistake with the tangent of the option's angle.
    let camera = Camera::new(200, 150, 75_f64.to_radians());
    let half = named("half-tangent").picture_in(Step::Phong, &camera, 1);
    let text = look(&half, Some("step05_phong"), locked()).text;
    assert!(text.contains(named("half-tangent").when), "{text}");
    assert!(text.contains("Its field of view is 75°"), "{text}");
    // At 90° the tangent is 1, as where the angle is left out: a second mistake is not
    // needed.
    let (wide, wrong) =
        (Camera::new(200, 150, PI / 2.0), named("radius-not-squared"));
    let wrong_and_wide = wrong.picture_in(Step::Phong, &wide, 1);
    let text = look(&wrong_and_wide, Some("step05_phong"), locked()).text;
    assert!(text.contains(&format!("what you get when {}.", wrong.when)), "{text}");
    assert!(text.contains("Its field of view is 90°"), "{text}");
}

#[test]
fn of_very_large_pictures_every_pixel_is_looked_at() {
    let mut large = Step::Rays.picture(&camera(4300, 2060), 1);
    let asked = |picture: &RgbImage| {
        let png = Cursor::new(png(picture.clone()));
        check(png, "large.png", Some("step01_rays"), locked()).text
    };
    large.put_pixel(1, 1, Rgb([0; 3])); // which is not kept
    let text = asked(&large);
    assert!(text.contains("in all but 1 pixel.\n"), "{text}");
    assert!(text.contains("--width 640 --aspect 16:9 gives that size."), "{text}");
    if !is_thorough() {
        return;
    }
    let mirrored = named("mirrored").picture_in(Step::Rays, &camera(4300, 2060), 1);
    let text = asked(&mirrored);
    assert!(text.contains("is what you get when x points left."), "{text}");
    assert!(text.contains("too large to be measured"), "{text}");
}
