//! Step 1: rays, the camera, and the program around the picture.

use crate::step_program::StepProgram;
use course::examples::row::Row;
use glam::DVec3;
use step01_rays::{AspectRatio, Camera, render};
use tests::camera;

/// Fields of view in degrees, from narrow to wide.
const FIELDS_OF_VIEW: [f64; 5] = [1.0, 30.0, 60.0, 90.0, 150.0];

fn nearly_equal(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * (1.0 + a.abs())
}

#[test]
fn program_accepts_the_limits_of_its_options() {
    let program = StepProgram::new("step01_rays", "limits");
    for arguments in [
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
        let output = program.run(arguments);
        assert!(output.status.success(), "{arguments}: {output:?}");
    }
}

#[test]
fn angle_between_outermost_rays_is_the_field_of_view() {
    for degrees in FIELDS_OF_VIEW {
        let camera = Camera::new(101, 75, f64::to_radians(degrees));
        let v = |i, j| camera.ray(i, j).direction;
        let angle = v(0.0, 37.0).angle_between(v(100.0, 37.0));
        assert!(nearly_equal(angle.to_degrees(), degrees));
        let (first, last) = (v(0.0, 0.0), v(100.0, 74.0));
        assert!(first.distance(-last.with_z(1.0)) < 1e-12, "{first} {last}");
        assert!(first.x < 0.0 && 0.0 < first.y && first.z == -1.0);
    }
}

#[test]
fn rows_of_an_aspect_ratio_are_rounded_and_at_least_one() {
    let rows = |text: &str| text.parse::<AspectRatio>().map(|ratio| ratio.v_res(640));
    assert_eq!(rows("2.35:1"), Ok(272));
    assert_eq!(rows("1281:1"), Ok(1));
    assert_eq!(rows("1:4"), Ok(2560));
    assert_eq!([rows("1e9:1"), rows("1e308:1e308")], [Ok(1), Ok(640)]);
    for text in ["", "16", "16:0", "0:9", "-4:-3", "1:2:3", "nan:1", "1:inf", "inf:inf", "1:4.1"] {
        assert!(rows(text).is_err(), "{text}");
    }
}

#[test]
fn middle_row_of_the_camera_is_the_row_in_2d() {
    for theta in FIELDS_OF_VIEW.map(f64::to_radians) {
        let (camera, row) = (Camera::new(9, 5, theta), Row::new(9, theta));
        for i in (0..9).map(f64::from) {
            let (v, v_in_2d) = (camera.ray(i, 2.0).direction, row.direction(i));
            assert!(nearly_equal(v.x, v_in_2d.x) && v.y.abs() < 1e-12 && v.z == -v_in_2d.y);
        }
    }
}

#[test]
#[should_panic(expected = "1×1 is not 2×1 or more")]
fn camera_panics_with_one_column() {
    Camera::new(1, 1, 1.0);
}

#[test]
#[should_panic(expected = "a pixel needs a ray")]
fn render_panics_without_samples() {
    render(&camera(), 0, |_| DVec3::ZERO);
}
