//! Step 1: the rays, the camera, the render loop and the program around the
//! picture.

use exercises::row::Row;
use glam::DVec3;
use image::Rgb;
use std::fs;
use std::sync::Mutex;
use step01_rays::{AspectRatio, Camera, render, rgb8};
use tests::{Program, assert_program, camera};

/// Fields of view in degrees, from narrow to wide.
const ANGLES: [f64; 5] = [1.0, 30.0, 60.0, 90.0, 150.0];

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * (1.0 + a.abs())
}

#[test]
fn the_program_draws_helps_and_refuses() {
    assert_program("step01_rays");
}

#[test]
fn the_program_says_what_it_wrote() {
    let program = Program::new("step01_rays", "says");
    let output =
        program.run("--width 64 --aspect 4:3 --samples 2 --output small.png");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.starts_with("small.png: 64×48 pixels in "), "{text}");
    assert!(output.stderr.is_empty(), "{output:?}");
    assert!(text.ends_with("s\n") && text.lines().count() == 1, "{text}");
}

#[test]
fn the_program_replaces_an_existing_file() {
    let program = Program::new("step01_rays", "replaces");
    let file = program.folder.join("a.png");
    fs::write(&file, "old").expect("a file");
    assert!(program.run("--width 2 --output a.png").status.success());
    assert!(image::open(file).is_ok());
    assert_eq!(program.files(), ["a.png"]);
}

#[test]
fn the_program_allows_the_limits() {
    let program = Program::new("step01_rays", "limits");
    for line in [
        "--width 2",
        "--width 8192 --aspect 8192:1",
        "--width 2 --aspect 1:4",
        "--aspect 1e9:1",
        "--fov 0.001 --width 2",
        "--fov 179.999 --width 2",
        "--samples 16 --width 2",
        "--width 20 --output UPPER.PNG",
        "--width 20 --output .png",
        "--width 20 --output -dash.png",
        &format!("--width 20 --output {}.png", "x".repeat(251)),
    ] {
        let output = program.run(line);
        assert!(output.status.success(), "{line}: {output:?}");
    }
}

#[test]
fn outermost_columns_enclose_theta_and_are_mirror_images() {
    for degrees in ANGLES {
        let camera = Camera::new(101, 75, f64::to_radians(degrees));
        let (left, right) =
            (camera.ray(0.0, 37.0).direction, camera.ray(100.0, 37.0).direction);
        assert!(close(left.angle_between(right).to_degrees(), degrees));
        let (top, bottom) =
            (camera.ray(0.0, 0.0).direction, camera.ray(100.0, 74.0).direction);
        assert!(top.distance(-bottom.with_z(1.0)) < 1e-12, "{top} {bottom}");
        assert!(top.x < 0.0 && 0.0 < top.y && top.z == -1.0);
    }
}

#[test]
fn pixels_are_square_for_the_four_aspect_ratios() {
    for (width, height, rows) in
        [(4.0, 3.0, 480), (16.0, 9.0, 360), (2.35, 1.0, 272), (2.59, 1.0, 247)]
    {
        assert_eq!(AspectRatio { width, height }.v_res(640), rows);
        let camera = Camera::new(640, rows, 1.0);
        assert_eq!(camera.matrix.x_axis.length(), camera.matrix.y_axis.length());
        let (top, bottom) =
            (camera.ray(9.0, 0.0), camera.ray(9.0, f64::from(rows - 1)));
        assert!(close(top.direction.y, -bottom.direction.y));
    }
}

#[test]
fn the_rows_of_a_ratio_are_rounded_and_at_least_one() {
    let rows =
        |text: &str| text.parse::<AspectRatio>().map(|ratio| ratio.v_res(640));
    assert_eq!(rows("2.35:1"), Ok(272));
    assert_eq!(rows("1281:1"), Ok(1));
    assert_eq!(rows("1:4"), Ok(2560));
    assert_eq!([rows("1e9:1"), rows("1e308:1e308")], [Ok(1), Ok(640)]);
    for text in [
        "", "16", "16:0", "0:9", "-4:-3", "1:2:3", "nan:1", "1:inf", "inf:inf",
        "1:4.1",
    ] {
        assert!(rows(text).is_err(), "{text}");
    }
}

#[test]
fn the_middle_row_of_the_camera_is_the_row_in_2d() {
    for theta in ANGLES.map(f64::to_radians) {
        let (camera, row) = (Camera::new(9, 5, theta), Row::new(9, theta));
        for i in (0..9).map(f64::from) {
            let (v, flat) = (camera.ray(i, 2.0).direction, row.direction(i));
            assert!(close(v.x, flat.x) && v.y.abs() < 1e-12 && v.z == -flat.y);
        }
    }
}

#[test]
fn every_ray_starts_at_c() {
    let camera = Camera { centre: DVec3::new(1.0, 2.0, 3.0), ..camera() };
    assert_eq!(camera.ray(3.0, 4.0).start, camera.centre);
    assert_eq!(Camera::new(4, 3, 1.0).centre, DVec3::ZERO);
}

#[test]
fn samples_are_the_centres_of_the_sub_pixels() {
    for samples in 1..=4_u32 {
        let camera = Camera::new(4, 3, 1.0);
        let seen = Mutex::new(vec![]);
        render(&camera, samples, |ray| {
            let place = camera.matrix.inverse() * ray.direction;
            // In halves of a sub-pixel, from the corner of the picture.
            let place = (place + 0.5) * f64::from(2 * samples);
            assert!((place - place.round()).truncate().length() < 1e-9);
            let place = [place.x.round() as u32, place.y.round() as u32];
            seen.lock().expect("no panic").push(place);
            DVec3::ZERO
        });
        let mut seen = seen.into_inner().expect("no panic");
        seen.sort_unstable();
        let odd = |pixels: u32| (1..2 * samples * pixels).step_by(2);
        let all = odd(4).flat_map(|x| odd(3).map(move |y| [x, y]));
        assert_eq!(seen, all.collect::<Vec<_>>());
    }
}

#[test]
fn intensities_are_clamped_and_rounded_to_8_bits() {
    for (intensity, byte) in [
        (-1.0, 0),
        (0.0, 0),
        (0.49 / 255.0, 0),
        (0.51 / 255.0, 1),
        (0.5, 128),
        (254.49 / 255.0, 254),
        (254.51 / 255.0, 255),
        (1.0, 255),
        (7.0, 255),
    ] {
        assert_eq!(rgb8(DVec3::splat(intensity)), Rgb([byte; 3]), "{intensity}");
    }
}

#[test]
#[should_panic(expected = "1×1 is not 2×1 or more")]
fn a_camera_needs_two_columns() {
    Camera::new(1, 1, 1.0);
}

#[test]
#[should_panic(expected = "a pixel needs a ray")]
fn a_pixel_needs_a_sample() {
    render(&camera(), 0, |_| DVec3::ZERO);
}
