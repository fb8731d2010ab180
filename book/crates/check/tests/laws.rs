//! Tests properties that hold for all pictures and all files.

use crate::{check, encode, locked_file, locked_picture, map_locked};
use check::{CheckError, ComparedPictures, Verdict, check_png};
use course::{
    Step, camera_with_fov, camera_with_size, names_of_right_pictures, read_locked_picture,
};
use fastrand::Rng;
use image::{DynamicImage, RgbImage};
use step01_rays::Camera;

#[test]
fn damaged_files_give_errors_without_panic() {
    let undamaged = encode((Step::Rays.draw_function())(&camera_with_size(16, 9), 1));
    let mut random = Rng::with_seed(0x5EED);
    for k in 0..300 {
        let mut file = undamaged.clone();
        let offset = random.usize(..file.len() - 12);
        file[offset] ^= random.u8(1..);
        file.truncate(if k % 2 == 0 { offset + 1 } else { file.len() });
        let answer = check_png(&file, "my.png", Some("step01_rays"), read_locked_picture);
        assert!(matches!(answer, Err(CheckError::Png { .. })), "{answer:?}");
    }
}

#[test]
fn only_equal_pictures_are_right() {
    let mut random = Rng::with_seed(0x5EED);
    for name in names_of_right_pictures().into_iter().step_by(11) {
        let answer = check_png(&locked_file(name), "my.png", Some(name), read_locked_picture);
        assert_eq!(answer.expect("the file can be checked").verdict, Verdict::Right, "{name}");
        let (position, bit) = ((random.u32(..640), random.u32(..360)), 1 << random.u8(..8));
        let change =
            |i, j, [r, g, b]: [u8; 3]| [r, if (i, j) == position { g ^ bit } else { g }, b];
        let answer = check(map_locked(name, change), name);
        assert_eq!(answer.verdict, Verdict::NotRight, "{name} at {position:?}");
    }
}

#[test]
fn right_programs_with_options_are_blamed_for_nothing() {
    let mut random = Rng::with_seed(0x5EED);
    for k in 0..40 {
        let step = Step::ALL[k % 5];
        let decimals = [1, 10, 100, 1000][k / 10];
        // If an angle has two or more decimals, `check` computes it from the colours of the sky at
        // the picture's border. The angles here are at least 40°, because at a smaller angle, there
        // may be no sky at the border.
        let fov_degrees =
            f64::from(random.u32(40 * decimals..150 * decimals)) / f64::from(decimals);
        let (columns, rows) = (random.u32(16..200), random.u32(16..200));
        let camera = Camera::new(columns, rows, fov_degrees.to_radians());
        let samples = random.u32(1..=4);
        let answer = check(step.draw_function()(&camera, samples), step.name());
        let options = format!("{step:?} {columns}×{rows} {fov_degrees}° {samples}: {answer}");
        assert_eq!(answer.verdict, Verdict::OtherOptions, "{options}");
        assert!(answer.causes.is_empty() && !answer.to_string().contains(".rs"), "{options}");
        assert!(!answer.to_json().contains("causes"), "{options}");
    }
}

/// In these pictures, a highlight at the right-hand border is as blue as the sky.
#[test]
fn fields_of_view_are_found_despite_highlights_on_the_border() {
    let step = Step::Phong;
    for (fov_degrees, columns, rows, samples) in [
        (51.63, 640, 360, 1),
        (52.55, 640, 360, 1),
        (53.13, 640, 360, 1),
        (53.13, 640, 360, 2),
        (53.13, 1280, 720, 1),
    ] {
        let camera = Camera::new(columns, rows, f64::to_radians(fov_degrees));
        let answer = check(step.draw_function()(&camera, samples), step.name());
        assert_eq!(answer.verdict, Verdict::OtherOptions, "{fov_degrees}°: {answer}");
        let options = format!("{fov_degrees}° and {samples}×{samples} rays");
        assert!(answer.to_string().contains(&options), "{options}: {answer}");
    }
}

/// No picture rules out a mistake in step 1: even if the sky is right, the camera may be slightly
/// off, or `rgb8` or `Ray::at` may be wrong.
#[test]
fn wrong_picture_of_any_step_names_the_tests_of_step_1() {
    for step in Step::ALL {
        let wrong_byte =
            |_, _, ours: [u8; 3]| ours.map(|byte| if byte < 90 { byte / 2 } else { byte });
        for picture in [map_locked(step.name(), wrong_byte), map_locked("spot", |_, _, ours| ours)]
        {
            let answer = check(picture, step.name());
            let has_step_1 = ["step 1 ", "steps 1 "]
                .iter()
                .any(|words| answer.to_string().contains(&format!("The tests by hand in {words}")));
            assert!(has_step_1 || answer.verdict == Verdict::Right, "{answer}");
        }
    }
}

#[test]
fn difference_is_drawn_only_of_a_wrong_picture_of_the_right_size() {
    let step = Step::Rays;
    let ours = locked_picture(step.name());
    let wrong = map_locked(step.name(), |_, _, [r, g, b]| [b, g, r]);
    let answer = check(wrong.clone(), step.name());
    let difference = answer.draw_comparison().expect("the answer can draw the difference");
    assert_eq!(difference.dimensions(), (3 * 640, 360));
    assert_eq!(
        answer.compared_pictures,
        Some(ComparedPictures { yours: wrong, ours: ours.clone() })
    );
    let other_options = step.draw_function()(&camera_with_fov(120.0, 640), 1);
    let small = RgbImage::new(64, 36);
    for picture in [ours.clone(), other_options, small] {
        assert_eq!(check(picture, step.name()).draw_comparison(), None);
    }
    let mut transparent = DynamicImage::from(ours).into_rgba8();
    transparent[(9, 9)][3] = 0;
    let answer = check_png(&encode(transparent), "my.png", Some(step.name()), read_locked_picture);
    assert_eq!(answer.expect("the file can be checked").draw_comparison(), None);
}
