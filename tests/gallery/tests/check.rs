//! What `check` says of pictures.

use crate::{folder, made, named, opened, right};
use gallery::{Answer, Mistake, Parts, Step, camera, check, mistakes};
use image::{Rgb, RgbImage, imageops};
use std::collections::HashSet;

/// The size of the locked pictures.
const SIZE: (u32, u32) = (640, 360);

/// What `check` says of this picture, once it is a PNG file; no sentence twice.
fn asked(test: &str, picture: &RgbImage, name: Option<&str>) -> Answer {
    let folder = folder(test);
    let file = folder.join("my.png");
    picture.save(&file).expect("a file in that folder");
    let answer = check(&file, name, &folder);
    let mut lines = HashSet::new();
    let sentences = answer.text.lines().filter(|line| !line.starts_with("  "));
    for line in sentences {
        assert!(lines.insert(line), "twice: {line}");
    }
    answer
}

/// Fails unless `check` names these mistakes, and no other ones before them.
fn assert_names(answer: &Answer, named: &[&Mistake]) {
    assert_eq!(answer.code, 1, "{}", answer.text);
    let when: Vec<_> = named.iter().map(|mistake| mistake.when).collect();
    let told = format!("what you get when {}.", when.join(", and "));
    assert!(answer.text.contains(&told), "{told}\n{}", answer.text);
    assert!(!answer.text.contains(" in all but "), "{}", answer.text);
    for Mistake { section, .. } in named {
        assert!(answer.text.contains(&section.path()), "{}", answer.text);
        assert!(answer.text.contains(&section.page()), "{}", answer.text);
    }
}

#[test]
fn right_pictures_are_right() {
    for step in Step::ALL {
        let picture = right(step.name());
        for name in [None, Some(step.name())] {
            let Answer { code, text } = asked("right", &picture, name);
            let right = format!(
                "Right: this is the picture of {}, in every pixel.",
                step.name()
            );
            assert_eq!((code, text), (0, right));
        }
    }
}

#[test]
fn every_mistake_is_named() {
    for mistake in mistakes() {
        let picture = mistake.picture(&camera(640, 360), 1);
        let answer = asked("named", &picture, Some(mistake.step.name()));
        assert_names(&answer, &[mistake]);
    }
}

#[test]
fn mistakes_are_named_without_the_name_of_their_step() {
    // Every fourth, for this takes long: each is compared with all steps.
    for mistake in mistakes().step_by(4) {
        let picture = mistake.picture(&camera(640, 360), 1);
        // The sky without a sphere is the right picture of step 1.
        if picture == right("step01_rays") {
            continue;
        }
        let answer = asked("unnamed", &picture, None);
        assert!(
            answer.text.contains(&format!("when {}.", mistake.when)),
            "{answer:?}"
        );
    }
}

#[test]
fn mistakes_of_the_camera_and_of_bytes_are_named_in_the_last_step() {
    for mistake in mistakes().filter(|mistake| mistake.section.step == Step::Rays) {
        let picture = made(Step::Phong, &[mistake.name], SIZE, 1);
        if picture == right("step05_phong") {
            continue;
        }
        let answer = asked("later", &picture, Some(Step::Phong.name()));
        let told = format!("when {}.", mistake.when);
        assert!(answer.text.contains(&told), "{}: {}", mistake.name, answer.text);
    }
}

#[test]
fn mistakes_are_named_at_another_size_and_number_of_samples() {
    let cases = [
        ("y-down", Step::Nearest, 320, 180, 1),
        ("y-down", Step::Rays, 200, 113, 1),
        ("mirrored", Step::Phong, 640, 360, 2),
        ("full-angle", Step::Sphere, 160, 90, 3),
        ("square-view", Step::Nearest, 400, 300, 2),
        ("inward", Step::Diffuse, 320, 180, 4),
        ("no-exponent", Step::Phong, 1280, 720, 1),
        ("gamma", Step::Phong, 320, 180, 3),
        ("bgr", Step::Diffuse, 64, 36, 1),
        ("last-in-list", Step::Nearest, 320, 180, 16),
    ];
    for (name, step, width, height, samples) in cases {
        let picture = made(step, &[name], (width, height), samples);
        let answer = asked("sizes", &picture, Some(step.name()));
        assert_names(&answer, &[named(name)]);
        let size = format!("{width}×{height} pixels");
        assert_eq!(answer.text.contains(&size), width != 640, "{}", answer.text);
        let rays = format!("{samples}×{samples} rays a pixel");
        assert_eq!(answer.text.contains(&rays), samples != 1, "{}", answer.text);
    }
}

#[test]
fn right_pictures_of_another_size_or_number_of_samples_are_right_but_for_that() {
    let cases = [
        (320, 180, 1, "--width 640 gives"),
        (640, 480, 1, "--aspect 16:9 gives"),
        (400, 300, 1, "--width 640 --aspect 16:9 gives"),
        (640, 360, 2, "--samples 1 gives"),
        (960, 540, 3, "--width 640 gives"),
        (320, 180, 8, "--width 640 gives"),
    ];
    for (width, height, samples, option) in cases {
        for step in [Step::Nearest, Step::Phong] {
            let picture = step.picture(&camera(width, height), samples);
            for name in [None, Some(step.name())] {
                let Answer { code, text } = asked("options", &picture, name);
                assert_eq!(code, 1, "{text}");
                assert!(text.starts_with("Right but for its "), "{text}");
                assert!(
                    text.contains(step.name()) && text.contains(option),
                    "{text}"
                );
            }
        }
    }
}

#[test]
fn the_tallest_picture_is_told_its_size() {
    let Answer { code, text } = asked("tall", &RgbImage::new(1, 6_800_000), None);
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("--width 640 --aspect 16:9 gives that size."), "{text}");
}

#[test]
fn two_mistakes_are_told_apart() {
    let cases: [(Step, &[&str]); 9] = [
        (Step::Nearest, &["y-down", "mirrored"]),
        (Step::Phong, &["mirrored", "bgr"]),
        (Step::Phong, &["full-angle", "gamma"]),
        (Step::Sphere, &["square-view", "bgr"]),
        (Step::Diffuse, &["y-down", "inward"]),
        (Step::Nearest, &["half-tangent", "last-in-list"]),
        (Step::Phong, &["no-ambient", "no-exponent"]),
        (Step::Rays, &["mirrored", "gamma"]),
        (Step::Diffuse, &["truncated", "absolute"]),
    ];
    for (step, names) in cases {
        let picture = made(step, names, SIZE, 1);
        let both: Vec<_> = names.iter().map(|name| named(name)).collect();
        assert_names(&asked("two", &picture, Some(step.name())), &both);
        assert_names(&asked("two", &picture, None), &both);
    }
}

#[test]
fn what_nobody_knows_is_not_named() {
    let mut noise = 1_u32;
    let mut random = || {
        noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (noise >> 24) as u8
    };
    let noise =
        RgbImage::from_fn(640, 360, |_, _| Rgb([random(), random(), random()]));
    let blobs = RgbImage::from_fn(640, 360, |i, j| {
        let (x, y) = (f64::from(i) / 40.0, f64::from(j) / 30.0);
        let wave = |a: f64| (127.0 + 120.0 * (x * a).sin() * (y + a).cos()) as u8;
        Rgb([wave(1.0), wave(1.7), wave(0.6)])
    });
    // Another scene, with the right camera and the right light.
    let mut parts = Parts::right(&camera(640, 360));
    parts.first_hit = |sphere, ray| {
        let mut sphere = *sphere;
        sphere.centre.x *= 0.8;
        sphere.radius *= 0.9;
        sphere.intersect(ray).first_hit()
    };
    let scene = parts.picture(Step::Phong, 1);
    // One sphere has another colour.
    let mut painted = right("step05_phong");
    for (_, _, pixel) in painted.enumerate_pixels_mut() {
        if pixel[0] < 60 && 80 < pixel[1] {
            pixel.0.swap(0, 1);
        }
    }
    for picture in [noise, blobs, scene, painted] {
        for name in
            [None, Some("step05_phong"), Some("step02_sphere"), Some("step01_rays")]
        {
            let Answer { code, text } = asked("unknown", &picture, name);
            assert_eq!(code, 1, "{text}");
            assert!(
                text.starts_with("Not right yet: this is not the picture"),
                "{text}"
            );
            assert!(!text.contains("what you get when"), "{text}");
        }
    }
}

#[test]
fn what_is_not_known_is_described() {
    let right = right("step03_nearest");
    let mut picture = right.clone();
    let teal = *right.get_pixel(615, 240);
    for pixel in picture.pixels_mut().filter(|pixel| **pixel == teal) {
        *pixel = Rgb([10, 20, 30]);
    }
    let text = asked("described", &picture, Some("step03_nearest")).text;
    for words in [
        "It differs on the teal sphere (all of it, darker by ",
        "Right in every pixel: the red sphere, the ground, the golden sphere",
        "columns 522 to 639",
        "side by side: ",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let moved = RgbImage::from_fn(640, 360, |i, j| {
        *right.get_pixel((i + 5).min(639), j.saturating_sub(3))
    });
    let text = asked("moved", &moved, Some("step03_nearest")).text;
    assert!(
        text.contains("closer to ours moved by pixels: 5 to the right, 3 up"),
        "{text}"
    );
}

#[test]
fn stray_pixels_do_not_hide_what_is_known() {
    let mut mirrored = made(Step::Nearest, &["mirrored"], SIZE, 1);
    (100..150).for_each(|i| mirrored.put_pixel(i, 9, Rgb([0; 3])));
    let text = asked("stray", &mirrored, Some("step03_nearest")).text;
    assert!(
        text.contains("is in all but 50 pixels what you get when x points left."),
        "{text}"
    );
    // The first is what two by two rays give there: it must not be taken for a hint.
    let edge = Step::Phong.picture(&camera(640, 360), 2);
    let phong = right("step05_phong");
    let is_edge =
        |&(i, j): &(u32, u32)| phong.get_pixel(i, j) != edge.get_pixel(i, j);
    let all = (0..640 * 360).map(|k| (k % 640, k / 640));
    let (i, j) = all.filter(is_edge).nth(999).expect("an edge");
    let strays = [
        (i, j, *edge.get_pixel(i, j)),
        (0, 0, Rgb([0; 3])),
        (639, 359, Rgb([255; 3])),
        (7, 9, Rgb([255, 0, 0])),
        (320, 180, Rgb([1, 2, 3])),
        (271, 101, Rgb([0, 0, 255])),
    ];
    let is_told = |picture: &RgbImage, asked_for, name: &str, but: &str| {
        let text = asked("stray", picture, asked_for).text;
        let told = format!("Nearly right: this is the picture of {name}{but}.\n");
        assert!(text.starts_with(&told) && !text.contains(" rays "), "{text}");
    };
    for name in ["step05_phong", "glass"] {
        let mut all = right(name);
        for (i, j, colour) in strays {
            let mut one = right(name);
            one.put_pixel(i, j, colour);
            all.put_pixel(i, j, colour);
            is_told(&one, Some(name), name, " in all but 1 pixel");
        }
        is_told(&all, Some(name), name, " in all but 6 pixels");
        is_told(&all, None, name, " in all but 6 pixels");
    }
}

/// The same picture, but for one in `share` pixels, off by this much.
fn off(picture: &RgbImage, by: u8, share: usize) -> RgbImage {
    let mut off = picture.clone();
    for pixel in off.pixels_mut().step_by(share) {
        pixel.0 = pixel.0.map(|c| if c < 128 { c + by } else { c - by });
    }
    off
}

#[test]
fn what_is_off_by_one_or_two_is_never_right() {
    for (by, shares) in [(1, [1, 640 * 360]), (2, [3, 500])] {
        for share in shares {
            for name in ["step01_rays", "step05_phong", "glass"] {
                let picture = off(&right(name), by, share);
                let Answer { code, text } = asked("off", &picture, Some(name));
                assert_eq!(code, 1, "{text}");
                assert!(text.starts_with("Nearly right: "), "{text}");
                assert!(
                    text.contains(&format!("(off by {by} of 255 at")),
                    "{text}"
                );
            }
        }
        let small = off(&Step::Phong.picture(&camera(320, 180), 1), by, 2);
        let text = asked("off", &small, Some("step05_phong")).text;
        assert!(text.starts_with("Nearly right: "), "{text}");
        let mirrored = off(&made(Step::Phong, &["mirrored"], SIZE, 1), by, 9);
        let text = asked("off", &mirrored, Some("step05_phong")).text;
        let but =
            format!("is in all but 25600 pixels (off by {by} of 255 at most)");
        assert!(text.contains(&but) && text.contains("x points left"), "{text}");
    }
}

#[test]
fn what_was_not_compared_in_full_is_not_called_right() {
    // More rays than are cast for an answer.
    let mut picture = Step::Nearest.picture(&camera(640, 120), 16);
    picture.put_pixel(1, 1, Rgb([0; 3]));
    let text = asked("large", &picture, Some("step03_nearest")).text;
    assert!(text.starts_with("Nearly right: "), "{text}");
    assert!(text.contains(" that were compared."), "{text}");
}

#[test]
fn a_picture_of_one_colour_has_no_invented_causes() {
    for colour in [[0; 3], [255; 3], [128; 3], [0, 0, 255], [232, 87, 71]] {
        let mut picture = RgbImage::from_pixel(640, 360, Rgb(colour));
        for only in
            ["It has one colour only: ", "It has one colour only in nearly "]
        {
            for name in
                [None].into_iter().chain(Step::ALL.map(Step::name).map(Some))
            {
                let Answer { code, text } = asked("flat", &picture, name);
                assert_eq!(code, 1, "{text}");
                assert!(text.starts_with("Not right yet: "), "{text}");
                assert!(text.contains(only), "{text}");
                assert!(text.contains(&format!("{colour:?}.")), "{text}");
                let mut causes =
                    text.lines().filter(|line| line.contains(" when "));
                assert!(!causes.any(|line| line.contains(", and ")), "{text}");
            }
            picture.put_pixel(320, 180, Rgb([9; 3]));
        }
    }
    let one = made(Step::Nearest, &["centre-ignored"], SIZE, 1);
    let answer = asked("flat", &one, Some("step03_nearest"));
    assert_names(&answer, &[named("centre-ignored")]);
    assert!(answer.text.contains("It has one colour only: "), "{answer:?}");
}

#[test]
fn what_two_steps_know_is_told_once() {
    // The sphere is behind the camera, so the pictures of steps 1 and 2 are the same.
    let picture = made(Step::Rays, &["looks-back"], SIZE, 1);
    let text = asked("once", &picture, None).text;
    assert_eq!(text.matches(named("looks-back").when).count(), 1, "{text}");
}

#[test]
fn every_cause_is_told() {
    let inside = made(Step::Sphere, &["always-hits"], SIZE, 1);
    let text = asked("all", &inside, Some("step02_sphere")).text;
    let is_cause = |mistake: &&Mistake| {
        mistake.section.step <= Step::Sphere
            && made(Step::Sphere, &[mistake.name], SIZE, 1) == inside
    };
    let causes: Vec<_> = mistakes().filter(is_cause).collect();
    assert!(4 <= causes.len());
    for Mistake { when, .. } in causes {
        assert_eq!(text.matches(&format!(" when {when}")).count(), 1, "{text}");
    }
}

#[test]
fn the_picture_of_the_difference_is_yours_ours_and_where_they_differ() {
    let ours = right("step03_nearest");
    let yours = made(Step::Nearest, &["mirrored"], SIZE, 1);
    let text = asked("panels", &yours, Some("step03_nearest")).text;
    let path =
        text.lines().last().and_then(|line| line.split_once(": ")).expect("a path");
    let panels = opened(path.1.as_ref());
    assert_eq!(panels.dimensions(), (3 * 640, 360));
    let panel = |k: u32| {
        image::imageops::crop_imm(&panels, k * 640, 0, 640, 360).to_image()
    };
    assert!(panel(0) == yours && panel(1) == ours);
    for ((a, b), c) in yours.pixels().zip(ours.pixels()).zip(panel(2).pixels()) {
        assert_eq!(a != b, *c != Rgb([0; 3]));
    }
}

#[test]
fn the_right_picture_of_another_step_is_told() {
    let picture = right("step04_diffuse");
    let Answer { code, text } = asked("other", &picture, Some("step05_phong"));
    assert_eq!(code, 1);
    assert!(
        text.contains(
            "this is the picture of step04_diffuse, not of step05_phong."
        ),
        "{text}"
    );
    assert!(!text.contains("what you get when"), "{text}");
    // The sky alone is right in step 1, and a known mistake in step 2.
    let picture = right("step01_rays");
    let Answer { text, .. } = asked("other", &picture, Some("step02_sphere"));
    assert!(text.contains("this is the picture of step01_rays, not of"), "{text}");
    assert!(text.contains(named("never-hits").when), "{text}");
}

/// The locked picture of an exercise.
fn exercise() -> RgbImage {
    right("glass")
}

#[test]
fn the_right_picture_of_an_exercise_is_right() {
    for name in [None, Some("glass")] {
        let Answer { code, text } = asked("exercise", &exercise(), name);
        let right = "Right: this is the picture of glass, in every pixel.";
        assert_eq!((code, text.as_str()), (0, right));
    }
}

#[test]
fn mirror_images_and_swapped_channels_of_an_exercise_are_named() {
    let (left, down) = (imageops::flip_horizontal, imageops::flip_vertical);
    let mut swapped = exercise();
    swapped.pixels_mut().for_each(|pixel| pixel.0.reverse());
    for (picture, when) in [
        (left(&exercise()), "x points left"),
        (down(&exercise()), "y points down"),
        (down(&left(&exercise())), "y points down, and x points left"),
        (swapped, "red and blue change places"),
    ] {
        let Answer { code, text } = asked("turned", &picture, Some("glass"));
        assert_eq!(code, 1, "{text}");
        let told = format!("picture of glass is what you get when {when}.");
        assert!(text.contains(&told), "{text}");
    }
}

#[test]
fn another_size_of_an_exercise_is_told() {
    let small = imageops::thumbnail(&exercise(), 320, 180);
    let Answer { code, text } = asked("small", &small, Some("glass"));
    assert_eq!(code, 1, "{text}");
    assert!(
        text.contains("320×180 pixels, and the locked picture 640×360"),
        "{text}"
    );
    assert!(text.contains("--width 640 gives that size."), "{text}");
    assert!(!text.contains("what you get when"), "{text}");
}
