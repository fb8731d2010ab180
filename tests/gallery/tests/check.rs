//! What `check` says of every picture that a reader may bring.

use gallery::{Answer, Mistake, Parts, Step, check, locked, mistakes};
use image::{Rgb, RgbImage, RgbaImage, imageops};
use std::path::PathBuf;
use std::process::{Command, Output};
use std::{env, fs};
use step01_rays::Camera;

fn camera(width: u32, height: u32) -> Camera {
    Camera::new(width, height, 60_f64.to_radians())
}

/// An empty folder of this test.
fn folder(test: &str) -> PathBuf {
    let program = env::current_exe().expect("a running program has a path");
    let target = program.ancestors().nth(3).expect("target/PROFILE/deps/program");
    let folder = target.join("tests").join(format!("check-{test}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}

/// What `check` says of this picture, once it is a PNG file.
fn asked(test: &str, picture: &RgbImage, name: Option<&str>) -> Answer {
    let folder = folder(test);
    let file = folder.join("my.png");
    picture.save(&file).expect("a file in that folder");
    check(&file, name, &folder)
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

fn named(name: &str) -> &'static Mistake {
    mistakes().find(|mistake| mistake.name == name).expect(name)
}

/// The picture of `step` with all these mistakes in it.
fn made(step: Step, names: &[&str], camera: &Camera, samples: u32) -> RgbImage {
    let mut parts = Parts::right(camera);
    names.iter().for_each(|name| (named(name).change)(&mut parts));
    parts.picture(step, samples)
}

#[test]
fn right_pictures_are_right() {
    for step in Step::ALL {
        let picture = locked(step.name()).expect("a locked picture");
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
        if picture == Step::Rays.picture(&camera(640, 360), 1) {
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
        let picture = mistake.picture_in(Step::Phong, &camera(640, 360), 1);
        if picture == Step::Phong.picture(&camera(640, 360), 1) {
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
        let picture = made(step, &[name], &camera(width, height), samples);
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
        (320, 180, 16, "--width 640 gives"),
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
        let picture = made(step, names, &camera(640, 360), 1);
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
    let grey = RgbImage::from_pixel(640, 360, Rgb([128; 3]));
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
    let mut painted = locked("step05_phong").expect("a locked picture");
    for (_, _, pixel) in painted.enumerate_pixels_mut() {
        if pixel[0] < 60 && 80 < pixel[1] {
            pixel.0.swap(0, 1);
        }
    }
    for picture in [noise, blobs, grey, scene, painted] {
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
    let right = locked("step03_nearest").expect("a locked picture");
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
fn a_few_stray_pixels_do_not_hide_what_is_known() {
    let mut picture = made(Step::Nearest, &["mirrored"], &camera(640, 360), 1);
    (100..150).for_each(|i| picture.put_pixel(i, 9, Rgb([0; 3])));
    let text = asked("stray", &picture, Some("step03_nearest")).text;
    assert!(
        text.contains("is in all but 50 pixels what you get when x points left."),
        "{text}"
    );
    let mut picture = locked("step03_nearest").expect("a locked picture");
    picture.put_pixel(7, 9, Rgb([0; 3]));
    let text = asked("stray", &picture, None).text;
    assert!(
        text.starts_with("Nearly right: ") && text.contains("all but 1 pixel"),
        "{text}"
    );
}

#[test]
fn the_picture_of_the_difference_is_yours_ours_and_where_they_differ() {
    let (ours, yours) = (
        locked("step03_nearest").expect("a locked picture"),
        made(Step::Nearest, &["mirrored"], &camera(640, 360), 1),
    );
    let text = asked("panels", &yours, Some("step03_nearest")).text;
    let path =
        text.lines().last().and_then(|line| line.split_once(": ")).expect("a path");
    let panels = image::open(path.1).expect("a PNG").to_rgb8();
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
    let picture = locked("step04_diffuse").expect("a locked picture");
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
    let picture = locked("step01_rays").expect("a locked picture");
    let Answer { text, .. } = asked("other", &picture, Some("step02_sphere"));
    assert!(text.contains("this is the picture of step01_rays, not of"), "{text}");
    assert!(text.contains(named("never-hits").when), "{text}");
}

/// The locked picture of an exercise.
fn exercise() -> RgbImage {
    locked("glass").expect("a locked picture")
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

fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_check"));
    command.args(arguments).output().expect("check runs")
}

#[test]
fn the_program_ends_with_0_1_or_2() {
    let folder = folder("codes");
    let path = |name: &str| folder.join(name).display().to_string();
    let right = locked("step02_sphere").expect("a locked picture");
    right.save(path("right.png")).expect("a file");
    made(Step::Sphere, &["a-is-a-length"], &camera(640, 360), 1)
        .save(path("wrong.png"))
        .expect("a file");
    // Alpha and another name's end do not matter.
    let alpha = RgbaImage::from_fn(640, 360, |i, j| {
        let [r, g, b] = right.get_pixel(i, j).0;
        image::Rgba([r, g, b, 255])
    });
    alpha.save(path("alpha.png")).expect("a file");
    fs::copy(path("right.png"), path("right")).expect("a copy");

    for (file, name, code) in [
        ("right.png", None, 0),
        ("right.png", Some("step02_sphere"), 0),
        ("alpha.png", None, 0),
        ("right", None, 0),
        ("right.png", Some("step01_rays"), 1),
        ("wrong.png", Some("step02_sphere"), 1),
        ("wrong.png", None, 1),
    ] {
        let path = path(file);
        let arguments: Vec<_> = [path.as_str()].into_iter().chain(name).collect();
        let output = run(&arguments);
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        assert!(
            output.stderr.is_empty() && !output.stdout.is_empty(),
            "{output:?}"
        );
    }
    let help = run(&["--help"]);
    assert!(help.status.success());
    assert!(String::from_utf8_lossy(&help.stdout).contains("step05_phong"));
}

#[test]
fn what_can_not_be_looked_at_is_told_in_one_sentence() {
    let folder = folder("refused");
    let path = |name: &str| folder.join(name).display().to_string();
    let right = fs::read(locked_path("step01_rays")).expect("a snapshot");
    fs::write(path("right.png"), &right).expect("a file");
    fs::write(path("empty.png"), "").expect("a file");
    fs::write(path("text.png"), "not a picture").expect("a file");
    fs::write(path("photo.png"), b"\xff\xd8\xff\xe0\0\x10JFIF\0\x01")
        .expect("a file");
    fs::write(path("short.png"), &right[..right.len() / 2]).expect("a file");
    fs::write(path("head.png"), &right[..20]).expect("a file");
    let mut flipped = right.clone();
    flipped[right.len() / 2] ^= 0x55;
    fs::write(path("flipped.png"), flipped).expect("a file");
    fs::write(path("huge.png"), huge()).expect("a file");
    fs::create_dir(path("folder.png")).expect("a folder");
    let (right, nowhere) = (path("right.png"), path("nowhere.png"));
    let all =
        "step01_rays, step02_sphere, step03_nearest, step04_diffuse, step05_phong";
    let cases: [(&[&str], &str); 13] = [
        (&[&nowhere], "can't read"),
        (&[&path("folder.png")], "is not a file"),
        (&[&path("empty.png")], "is not a PNG file"),
        (&[&path("text.png")], "is not a PNG file"),
        (&[&path("photo.png")], "is not a PNG file"),
        (&[&path("short.png")], "is a damaged PNG file"),
        (&[&path("head.png")], "is a damaged PNG file"),
        (&[&path("flipped.png")], "is a damaged PNG file"),
        (&[&path("huge.png")], "is 200000×200000 pixels; allowed are"),
        (&[&right, "step06_mirror"], all),
        (&[], "allowed are one PNG file"),
        (&[&right, "step01_rays", "more"], "allowed are one PNG file"),
        (&["--width", "640"], "allowed are one PNG file"),
    ];
    for (arguments, words) in cases {
        let output = run(arguments);
        let text = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
        assert!(text.starts_with("error: ") && text.lines().count() == 1, "{text}");
        assert!(text.contains(words), "{arguments:?}: {text}");
    }
}

fn locked_path(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    folder.join(format!("../snapshots/{name}.snap.png"))
}

/// The beginning of a PNG file that says it has 200000×200000 pixels.
fn huge() -> Vec<u8> {
    let mut png = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
    png.extend(200_000_u32.to_be_bytes());
    png.extend(200_000_u32.to_be_bytes());
    png.extend([8, 2, 0, 0, 0]);
    png.extend(crc(&png[12..29]).to_be_bytes());
    png.extend(b"\0\0\x10\0IDAT\x78\x9c");
    png
}

/// The checksum of a part of a PNG file.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| {
            (crc >> 1) ^ if crc & 1 == 1 { 0xEDB8_8320 } else { 0 }
        })
    })
}
