//! Step 1: rays and the camera.

use course::examples::{directions, row::Row};
use glam::DVec3;
use step01_rays::{Camera, render};
use support::camera;

/// Fields of view in degrees, from narrow to wide.
const FIELDS_OF_VIEW: [f64; 5] = [1.0, 30.0, 60.0, 90.0, 150.0];

fn nearly_equal(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * (1.0 + a.abs())
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
        assert!(first.x < 0.0 && first.y > 0.0 && first.z == -1.0);
    }
}

#[test]
fn rays_of_the_middle_row_are_those_of_the_row_in_2d() {
    for theta in FIELDS_OF_VIEW.map(f64::to_radians) {
        let (camera, row) = (Camera::new(9, 5, theta), Row::new(9, theta));
        for i in (0..9).map(f64::from) {
            let (v, v_in_2d) = (camera.ray(i, 2.0).direction, row.direction(i));
            assert!(nearly_equal(v.x, v_in_2d.x) && v.y.abs() < 1e-12 && v.z == -v_in_2d.y);
        }
    }
}

#[test]
fn loops_on_one_processor_draw_the_picture_of_all_processors() {
    for camera in [camera(), Camera::new(2, 1, 1.0), Camera::new(37, 53, 2.0)] {
        assert_eq!(directions::picture(&camera), step01_rays::picture(&camera, 1));
    }
}

#[test]
#[should_panic(expected = "a picture has at least 2×1 pixels, not 1×1")]
fn camera_panics_with_one_column() {
    Camera::new(1, 1, 1.0);
}

#[test]
#[should_panic(expected = "a pixel needs a ray")]
fn render_panics_without_samples() {
    render(&camera(), 0, |_| DVec3::ZERO);
}
