//! What `check` says of pictures.

use super::{locked, made, named, right};
use ::check::{Answer, look};
use gallery::{Mistake, Parts, Step, camera, mistakes};
use glam::DVec3;
use image::{Rgb, RgbImage, imageops};
use rayon::ThreadPoolBuilder;
use std::collections::HashSet;
use std::f64::consts::PI;
use step01_rays::Camera;
use tests::{is_thorough, some};

/// The size of the locked pictures.
const SIZE: (u32, u32) = (640, 360);

/// What `check` says of this picture; no sentence twice.
fn asked(picture: &RgbImage, name: Option<&str>) -> Answer {
    let answer = look(picture, name, locked());
    let mut lines = HashSet::new();
    for line in answer.text.lines().filter(|line| !line.starts_with("  ")) {
        assert!(lines.insert(line), "twice: {line}");
    }
    answer
}

/// What it says of a wrong picture: all these words.
fn told(picture: &RgbImage, name: Option<&str>, words: &[&str]) -> String {
    let Answer { code, text, .. } = asked(picture, name);
    assert_eq!(code, 1, "{text}");
    assert!(!text.starts_with("Right:"), "{text}");
    for word in words {
        assert!(text.contains(word), "{word} is missing: {text}");
    }
    text
}

/// Fails unless `check` names these mistakes, and no other ones before them.
fn assert_named(
    picture: &RgbImage,
    name: Option<&str>,
    named: &[&Mistake],
) -> String {
    let when: Vec<_> = named.iter().map(|mistake| mistake.when).collect();
    let when = format!("what you get when {}.", when.join(", and "));
    let text = told(picture, name, &[&when]);
    assert!(!text.contains(" in all but "), "{text}");
    for Mistake { section, .. } in named {
        assert!(text.contains(&section.path()), "{text}");
        assert!(text.contains(&section.page()), "{text}");
    }
    text
}

#[test]
fn right_pictures_are_right() {
    for name in Step::ALL.map(Step::name).into_iter().chain(["glass"]) {
        for asked_for in [None, Some(name)] {
            let text =
                format!("Right: this is the picture of {name}, in every pixel.");
            assert_eq!(asked(&right(name), asked_for), Answer::new(0, text));
        }
    }
}

#[test]
fn every_mistake_is_named() {
    for (k, mistake) in some(mistakes().enumerate(), 20) {
        let picture = mistake.picture(&camera(640, 360), 1);
        assert_named(&picture, Some(mistake.step.name()), &[mistake]);
        // Every 40th, for this takes long: each is compared with all steps. The sky
        // without a sphere is the right picture of step 1.
        if k % 40 == 0 && picture != right("step01_rays") {
            told(&picture, None, &[&format!("when {}.", mistake.when)]);
        }
    }
}

#[test]
fn what_a_mistake_hides_is_not_called_right() {
    // No highlight is left, whatever the specular term.
    let picture = made(Step::Phong, &["normal-from-origin"], SIZE, 1);
    let text = told(&picture, Some("step05_phong"), &["attenuation  "]);
    let stages = text.lines().filter(|line| line.contains("specular, "));
    let hidden =
        stages.filter(|line| line.ends_with("nothing in this picture shows it"));
    assert!(0 < hidden.count(), "{text}");
}

#[test]
fn mistakes_of_the_camera_and_of_bytes_are_named_in_the_last_step() {
    // Every third, for in the last step there are most causes to compare with; all are
    // named in their own step.
    let all = mistakes().filter(|mistake| mistake.section.step == Step::Rays);
    for mistake in some(all.step_by(3), 5) {
        let picture = made(Step::Phong, &[mistake.name], SIZE, 1);
        if picture != right("step05_phong") {
            let when = format!("when {}.", mistake.when);
            told(&picture, Some("step05_phong"), &[&when]);
        }
    }
}

#[test]
fn mistakes_are_named_at_another_size_and_number_of_samples() {
    let cases = [
        ("y-down", Step::Nearest, 320, 180, 1),
        ("y-down", Step::Rays, 200, 113, 1),
        ("mirrored", Step::Nearest, 640, 360, 1),
        ("full-angle", Step::Sphere, 160, 90, 3),
        ("square-view", Step::Nearest, 200, 150, 2),
        ("inward", Step::Diffuse, 160, 90, 4),
        ("no-exponent", Step::Phong, 960, 180, 1),
        ("gamma", Step::Phong, 160, 90, 3),
        ("bgr", Step::Diffuse, 64, 36, 1),
        ("last-in-list", Step::Nearest, 64, 36, 16),
    ];
    for (name, step, width, height, samples) in some(cases, 5) {
        let picture = made(step, &[name], (width, height), samples);
        let text = assert_named(&picture, Some(step.name()), &[named(name)]);
        let size = format!("{width}×{height} pixels");
        assert_eq!(text.contains(&size), width != 640, "{text}");
        let rays = format!("{samples}×{samples} rays a pixel");
        assert_eq!(text.contains(&rays), samples != 1, "{text}");
    }
}

#[test]
fn right_pictures_of_another_size_or_number_of_samples_are_right_but_for_that() {
    let cases = [
        (320, 180, 1, "--width 640 gives"),
        (640, 480, 1, "--aspect 16:9 gives"),
        (400, 300, 1, "--width 640 --aspect 16:9 gives"),
        (640, 360, 2, "--samples 1 gives"),
        (240, 135, 3, "--width 640 gives"),
        (64, 36, 8, "--width 640 gives"),
    ];
    // In turn, with a name and without one.
    let steps = [(Step::Phong, Some("step05_phong")), (Step::Nearest, None)];
    let cases = cases.into_iter().zip(steps.into_iter().cycle());
    for ((width, height, samples, option), (step, name)) in some(cases, 3) {
        let picture = step.picture(&camera(width, height), samples);
        told(&picture, name, &["Right but for its ", step.name(), option]);
    }
    let tall = RgbImage::new(1, 16384);
    told(&tall, None, &["--width 640 --aspect 16:9 gives that size."]);
    let small = imageops::thumbnail(&right("glass"), 320, 180);
    let words =
        ["320×180 pixels, and the locked picture 640×360: --width 640 gives"];
    let text = told(&small, Some("glass"), &words);
    assert!(!text.contains("what you get when"), "{text}");
}

#[test]
fn two_mistakes_are_told_apart() {
    let cases: [(Step, &[&str]); 9] = [
        (Step::Nearest, &["y-down", "truncated"]),
        (Step::Phong, &["mirrored", "bgr"]),
        (Step::Phong, &["full-angle", "gamma"]),
        (Step::Sphere, &["square-view", "bgr"]),
        (Step::Diffuse, &["y-down", "inward"]),
        (Step::Nearest, &["half-tangent", "last-in-list"]),
        (Step::Phong, &["no-ambient", "no-exponent"]),
        (Step::Rays, &["mirrored", "gamma"]),
        (Step::Diffuse, &["truncated", "absolute"]),
    ];
    for (k, (step, names)) in some(cases.into_iter().enumerate(), 4) {
        let picture = made(step, names, SIZE, 1);
        let both: Vec<_> = names.iter().map(|name| named(name)).collect();
        assert_named(&picture, Some(step.name()), &both);
        // The first and the last without a name, for this takes long.
        if k % 8 == 0 {
            assert_named(&picture, None, &both);
        }
    }
}

#[test]
fn one_thing_is_likelier_than_two_mistakes() {
    let turned = made(Step::Phong, &["y-down", "mirrored"], SIZE, 1);
    let mut parts = Parts::right(&camera(640, 360));
    parts.diffuse = |_, _, _, _, _| DVec3::ZERO;
    parts.specular = |_, _, _, _, _| DVec3::ZERO;
    let ambient = parts.picture(Step::Phong, 1);
    let turn = "h = −tan(θ / 2), where ours is h = tan(θ / 2)";
    let sum = "I = I_a, where ours is I = I_a + E_d + E_s";
    for (picture, one) in [(turned, turn), (ambient, sum)] {
        let text = told(&picture, Some("step05_phong"), &["no known mistake", one]);
        assert!(!text.contains(" is what you get when "), "{text}");
    }
}

/// A slip of another file may give the picture of a known mistake.
#[test]
fn what_gives_the_same_picture_elsewhere_is_told_beside_a_name() {
    let mistake = named("y-down").picture_in(Step::Rays, &camera(320, 180), 1);
    let text = told(
        &mistake,
        Some("step01_rays"),
        &["y points down", "or else sky = 0.7 + 0.3 (V_x, −V_y, −V_z)"],
    );
    let sky = "  sky                can't be told: either it or rays is wrong";
    assert!(text.contains(sky), "{text}");
    // Of two mistakes, too.
    let both = made(Step::Phong, &["normalised", "no-max"], SIZE, 1);
    let text = told(
        &both,
        Some("step05_phong"),
        &["V is normalised", "or else sky = 0.7 + 0.3 normalised("],
    );
    let sky = "  sky                can't be told: either it or rays is wrong";
    assert!(text.contains(sky), "{text}");
    // An object shows which of them it is.
    let mistake = named("y-down").picture_in(Step::Phong, &camera(320, 180), 1);
    let text = told(&mistake, Some("step05_phong"), &["y points down"]);
    assert!(text.contains("  sky                right"), "{text}");
}

#[test]
fn what_nobody_knows_is_not_named() {
    let wave = |i: u32, j: u32| (f64::from(i * i + 3 * j * j) * 0.37).sin();
    let noise = RgbImage::from_fn(640, 360, |i, j| {
        Rgb([0, 1, 2].map(|k| (127.0 + 127.0 * wave(i + k, j * 2 + k)) as u8))
    });
    // Another scene, with the right camera and the right light.
    let mut parts = Parts::right(&camera(640, 360));
    for object in parts.scene.objects.iter_mut().chain([&mut parts.sphere]) {
        object.sphere.centre.x = 0.8 * object.sphere.centre.x + 0.1;
        object.sphere.radius *= 0.9;
    }
    let scene = parts.picture(Step::Phong, 1);
    // One sphere has another colour.
    let mut painted = right("step05_phong");
    for pixel in painted.pixels_mut().filter(|one| one[0] < 60 && 80 < one[1]) {
        pixel.0.swap(0, 1);
    }
    let cases = [
        (&scene, Some("step05_phong")),
        (&noise, Some("step01_rays")),
        (&painted, None),
    ];
    for (picture, name) in some(cases, 3) {
        let words = ["Not right yet: this is not the picture", "no known mistake"];
        let text = told(picture, name, &words);
        assert!(!text.contains("what you get when"), "{text}");
    }
}

#[test]
fn what_is_not_known_is_described() {
    let mut picture = right("step03_nearest");
    let teal = *picture.get_pixel(615, 240);
    for pixel in picture.pixels_mut().filter(|pixel| **pixel == teal) {
        *pixel = Rgb([10, 20, 30]);
    }
    let words = [
        "It differs on the teal sphere (all of it, darker by ",
        "Right in every pixel: the red sphere, the ground, the golden sphere",
        "columns 522 to 639",
    ];
    told(&picture, Some("step03_nearest"), &words);
}

#[test]
fn stray_pixels_do_not_hide_what_is_known() {
    let mut mirrored = made(Step::Nearest, &["mirrored"], SIZE, 1);
    (100..150).for_each(|i| mirrored.put_pixel(i, 9, Rgb([0; 3])));
    let words = ["is in all but 50 pixels what you get when x points left."];
    told(&mirrored, Some("step03_nearest"), &words);
    // The first is what two by two rays give there: it must not be taken for a hint.
    let (phong, two) =
        (right("step05_phong"), Step::Phong.picture(&camera(640, 360), 2));
    let apart = |(i, j, two): &(u32, u32, &Rgb<u8>)| {
        two[0].abs_diff(phong.get_pixel(*i, *j)[0])
    };
    let (i, j, edge) = two.enumerate_pixels().max_by_key(apart).expect("an edge");
    let strays = [
        (i, j, *edge),
        (0, 0, Rgb([0; 3])),
        (639, 359, Rgb([255; 3])),
        (271, 101, Rgb([0, 0, 255])),
    ];
    // All of them at once are asked of an exercise, too.
    let cases = [("step05_phong", 0), ("glass", strays.len() - 1)];
    for (name, first) in some(cases, 2) {
        let nearly =
            format!("Nearly right: this is the picture of {name} in all but");
        let mut all = right(name);
        for (k, (i, j, colour)) in strays.into_iter().enumerate() {
            all.put_pixel(i, j, colour);
            // The first alone, and all.
            if k < first || [1, 2].contains(&k) {
                continue;
            }
            let count =
                if k == 0 { "1 pixel".into() } else { format!("{} pixels", k + 1) };
            let count = format!("{nearly} {count}.\n");
            let differ = format!("\n{} of 230400 pixels differ", k + 1);
            let differ = if k == 0 { format!("{differ}s") } else { differ };
            let is_named = k != 3 || !is_thorough();
            told(&all, Some(name).filter(|_| is_named), &[&count, &differ]);
        }
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
    let small = Step::Phong.picture(&camera(320, 180), 1);
    let cases = [
        ("step05_phong", &right("step05_phong"), 1, 640 * 360),
        ("step05_phong", &small, 1, 9),
        ("glass", &right("glass"), 2, 3),
    ];
    for (name, picture, by, share) in some(cases, 3) {
        let words = ["Nearly right: ", &format!("(off by {by} of 255 at most).")];
        told(&off(picture, by, share), Some(name), &words);
    }
    told(
        &off(&right("step01_rays"), 1, 1),
        Some("step01_rays"),
        &["Not right yet"],
    );
    // No name where so many pixels are not explained.
    let mirrored = off(&made(Step::Phong, &["mirrored"], SIZE, 1), 2, 9);
    let text = told(&mirrored, Some("step05_phong"), &["no known mistake"]);
    assert!(!text.contains("your picture of step05_phong is"), "{text}");
}

#[test]
fn where_not_all_rays_are_cast_one_pixel_can_hide() {
    let mut large = Step::Nearest.picture(&camera(640, 98), 16);
    large.put_pixel(1, 1, Rgb([0; 3]));
    told(
        &large,
        Some("step03_nearest"),
        &["Nearly right: ", " that were compared."],
    );
}

#[test]
fn options_and_a_slip_that_no_list_has_are_both_told() {
    let wide = Camera::new(320, 180, PI / 2.0);
    let cases = [
        (camera(320, 180), 2, "It has 2×2 rays a pixel, and the locked picture 1"),
        (wide, 1, "Its field of view is 90°, and that of the locked picture 60°"),
    ];
    for (camera, samples, option) in cases {
        let mut parts = Parts::right(&camera);
        let right = parts.picture(Step::Phong, samples);
        parts.lit = |n, l| 0.3 < n.dot(l);
        let yours = parts.picture(Step::Phong, samples);
        // Ours has the same options: it differs where the slip shows, and nowhere else.
        let differ = yours.pixels().zip(right.pixels()).filter(|(a, b)| a != b);
        let differ = format!("\n{} of 57600 pixels differ", differ.count());
        let text =
            told(&yours, Some("step05_phong"), &[option, "0.3 < n·l", &differ]);
        let (_, pixel) = text.split_once("Column ").expect("one pixel");
        let mut numbers = pixel.split(|c: char| !c.is_ascii_digit());
        let mut number = || numbers.find_map(|word| word.parse().ok());
        let [i, j, r, g, b, ours @ ..] = [(); 8].map(|()| number().expect("eight"));
        let there = [&yours, &right].map(|all| all[(i, j)].0.map(u32::from));
        assert_eq!([[r, g, b], ours], there, "{text}");
    }
}

/// Work is counted, not timed; and what is looked at does not depend on who looks.
#[test]
fn an_answer_is_the_same_on_one_thread_and_on_many() {
    let mut parts = Parts::right(&camera(320, 180));
    parts.scene.ambient_light = DVec3::splat(parts.scene.ambient_light.length());
    parts.attenuation = |fade, d| fade.a + fade.b * d + fade.c * d;
    let yours = parts.picture(Step::Phong, 1);
    let on = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().expect("threads");
        pool.install(|| asked(&yours, Some("step05_phong")))
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn an_angle_that_is_an_option_and_taken_in_another_way_is_told() {
    let upright = (37.5_f64.to_radians().tan() * 319.0 / 179.0).atan();
    let taken = Camera::new(320, 180, 2.0 * upright);
    let picture = Parts::right(&taken).picture(Step::Phong, 1);
    let known = [named("upright-angle")];
    let text = assert_named(&picture, Some("step05_phong"), &known);
    assert!(text.contains("Its field of view is 75°"), "{text}");
}

#[test]
fn an_angle_of_which_little_sky_is_left_is_told() {
    let known = named("a-is-a-length");
    let mut parts = Parts::right(&Camera::new(640, 360, 70_f64.to_radians()));
    (known.change)(&mut parts);
    let picture = parts.picture(Step::Phong, 1);
    let text = assert_named(&picture, Some("step05_phong"), &[known]);
    assert!(text.contains("Its field of view is 70°"), "{text}");
}

#[test]
fn a_picture_of_one_colour_has_no_invented_causes() {
    let (all, nearly) =
        ("It has one colour only: ", "one colour only in nearly all");
    let phong = Some("step05_phong");
    let cases = [([255; 3], 1, nearly, phong), ([0; 3], 0, all, None)];
    for (colour, spots, only, name) in some(cases, 2) {
        let mut picture = RgbImage::from_pixel(320, 180, Rgb(colour));
        (0..spots).for_each(|i| picture.put_pixel(160 + i, 90, Rgb([9; 3])));
        let text = told(&picture, name, &[only, &format!("{colour:?}.")]);
        let mut causes = text.lines().filter(|line| line.contains(" when "));
        assert!(!causes.any(|line| line.contains(", and ")), "{text}");
        assert!(!text.contains(" rays a pixel"), "{text}");
    }
    let one = made(Step::Nearest, &["centre-ignored"], SIZE, 1);
    let known = [named("centre-ignored")];
    let text = assert_named(&one, Some("step03_nearest"), &known);
    assert!(text.contains("It has one colour only: "), "{text}");
}

#[test]
fn every_cause_is_told_once() {
    let inside = made(Step::Sphere, &["always-hits"], SIZE, 1);
    let text = told(&inside, Some("step02_sphere"), &[]);
    let is_cause = |mistake: &&Mistake| {
        mistake.section.step <= Step::Sphere
            && made(Step::Sphere, &[mistake.name], SIZE, 1) == inside
    };
    let causes: Vec<_> = mistakes().filter(is_cause).collect();
    assert!(4 <= causes.len());
    for Mistake { when, .. } in causes {
        // The stages say it again, on lines of their own.
        let lines = text.lines().filter(|line| !line.starts_with("  "));
        let told = lines.filter(|line| line.contains(&format!(" when {when}")));
        assert_eq!(told.count(), 1, "{text}");
    }
    // The sphere is behind the camera, so the pictures of steps 1 and 2 are the same.
    let picture = made(Step::Rays, &["looks-back"], SIZE, 1);
    let text = told(&picture, None, &[]);
    let lines = text.lines().filter(|line| !line.starts_with("  "));
    let told = lines.filter(|line| line.contains(named("looks-back").when));
    assert_eq!(told.count(), 1, "{text}");
}

#[test]
fn the_picture_of_the_difference_is_yours_ours_and_where_they_differ() {
    let ours = right("step03_nearest");
    let yours = made(Step::Nearest, &["mirrored"], SIZE, 1);
    let panels = look(&yours, None, locked()).difference.expect("a difference");
    assert_eq!((panels.width(), 360 + 20), (3 * 640, panels.height()));
    let panel =
        |k: u32| imageops::crop_imm(&panels, k * 640, 20, 640, 360).to_image();
    assert!(panel(0) == yours && panel(1) == ours);
    for ((a, b), c) in yours.pixels().zip(ours.pixels()).zip(panel(2).pixels()) {
        let is_grey = c.0 == [c[0]; 3];
        assert_eq!(a == b, is_grey, "{a:?}, {b:?}: {c:?}");
    }
}

#[test]
fn the_right_picture_of_another_step_is_told() {
    let words = [
        "this is the picture of step04_diffuse, not of step05_phong.",
        "No highlight is in it: I_s is not in the sum",
    ];
    let text = told(&right("step04_diffuse"), Some("step05_phong"), &words);
    assert!(!text.contains("what you get when"), "{text}");
    // The sky alone is right in step 1, and a known mistake in step 2.
    let words = [
        "this is the picture of step01_rays, not of",
        named("never-hits").when,
        "+ r² for − r² in c",
    ];
    told(&right("step01_rays"), Some("step02_sphere"), &words);
}

#[test]
fn mirror_images_and_swapped_channels_of_an_exercise_are_named() {
    let right = right("glass");
    let left = imageops::flip_horizontal(&right);
    let down = imageops::flip_vertical(&right);
    let both = imageops::flip_vertical(&left);
    let mut swapped = right;
    swapped.pixels_mut().for_each(|pixel| pixel.0.reverse());
    let cases = [
        (left, "x points left"),
        (down, "y points down"),
        (both, "y points down, and x points left"),
        (swapped, "red and blue change places"),
    ];
    for (picture, when) in some(cases, 3) {
        let words = format!("picture of glass is what you get when {when}.");
        for name in [None, Some("glass")] {
            told(&picture, name, &[&words]);
        }
    }
}

#[test]
fn what_is_all_black_or_all_white_is_told_as_its_intensity() {
    let mut picture = RgbImage::new(160, 90);
    told(&picture, Some("step01_rays"), &["at most 0 there, or no number"]);
    picture.pixels_mut().for_each(|pixel| pixel.0 = [255; 3]);
    told(&picture, Some("step01_rays"), &["at least 1 there"]);
}
