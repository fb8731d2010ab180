use exercises::look_at::look_at;
use exercises::panorama::{direction, panoramic};
use exercises::*;
use glam::DVec3;
use image::Rgb;
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;
use step01_rays::Camera;
use tests::{camera, point};

#[test]
fn the_equator_and_the_meridians_are_where_they_should_be() {
    let (camera, picture) = (camera(), graticule::picture(&camera(), 1));
    for degrees in [-30.0, -10.0, 0.0, 15.0, 30.0] {
        let x = f64::to_radians(degrees).tan();
        let i = (x - camera.matrix.z_axis.x) / camera.matrix.x_axis.x;
        let pixel = picture.get_pixel(i.round() as u32, 20);
        assert!(240 < pixel[0], "{degrees} degrees: {pixel:?}");
    }
    assert!((0..640).all(|i| picture.get_pixel(i, 179) == &Rgb([255; 3])));
}

#[test]
fn the_rings_are_round_about_the_middle() {
    // Four pixels at one distance from the middle see rays of one length.
    let picture = rings::picture(&Camera::new(361, 361, 1.0), 1);
    let is_bright = |i: u32, j: u32| 128 < picture.get_pixel(i, j)[2];
    for away in 0..=180 {
        let [near, far] = [180 - away, 180 + away];
        let four = [(near, 180), (far, 180), (180, near), (180, far)];
        assert!(
            four.iter().all(|(i, j)| is_bright(*i, *j) == is_bright(near, 180)),
            "{away}"
        );
    }
    // |V| is 1 in the middle, and 1.015 where its other part is 0.1738.
    let column = |x: f64| (180.0 + x * 180.0 / 0.5_f64.tan()).round() as u32;
    assert!(is_bright(180, 180) && !is_bright(column(0.1738), 180));
}

#[test]
fn cameras_that_one_knows_without_the_formula() {
    assert_eq!(look_at(&camera(), DVec3::ZERO, DVec3::NEG_Z, 0.0), camera());
    let rolled = look_at(&camera(), DVec3::ZERO, DVec3::NEG_Z, FRAC_PI_2);
    let up = camera().matrix.x_axis.length() * DVec3::Y;
    assert!(rolled.matrix.x_axis.distance(up) < 1e-12);
    let down = look_at(&camera(), DVec3::Y, DVec3::ZERO, 0.0);
    assert!(down.ray(319.5, 179.5).direction.distance(DVec3::NEG_Y) < 1e-12);
    assert!(0.0 < down.matrix.determinant().abs());
}

#[test]
fn the_four_ways_of_the_panorama() {
    for (longitude, latitude, v) in [
        (0.0, 0.0, DVec3::NEG_Z),
        (FRAC_PI_2, 0.0, DVec3::X),
        (2.0 * FRAC_PI_2, 0.0, DVec3::Z),
        (1.0, FRAC_PI_2, DVec3::Y),
    ] {
        assert!(direction(longitude, latitude).distance(v) < 1e-12, "{v}");
    }
}

#[test]
fn the_panorama_closes_at_its_left_and_right_edges() {
    let camera = Camera::new(64, 32, 1.0);
    for j in 0..32 {
        let at = |i| panoramic(&camera, DVec3::new(i, f64::from(j), 1.0));
        assert!(at(-0.5).distance(at(63.5)) < 1e-12);
        assert!((at(10.0) + at(42.0)).with_y(0.0).length() < 1e-12);
    }
}

proptest! {
    #[test]
    fn the_target_is_in_the_middle(from in point(), to in point(), roll in -3.0..3.0) {
        prop_assume!(0.1 < from.distance(to));
        let ray = look_at(&camera(), from, to, roll).ray(319.5, 179.5);
        prop_assert_eq!(ray.start, from);
        prop_assert!(look_at::passes(&ray, to).is_some_and(|away| away < 1e-9));
    }

    #[test]
    fn turning_keeps_lengths_and_angles(from in point(), to in point(), roll in -3.0..3.0) {
        prop_assume!(0.1 < from.distance(to));
        let (own, turned) = (camera().matrix, look_at(&camera(), from, to, roll).matrix);
        let apart = turned.transpose() * turned - own.transpose() * own;
        prop_assert!(apart.to_cols_array().iter().all(|x| x.abs() < 1e-12));
        prop_assert!(turned.determinant() * own.determinant() > 0.0);
    }

    #[test]
    fn without_roll_the_horizon_is_level(from in point(), to in point()) {
        prop_assume!(0.1 < (from - to).with_y(0.0).length());
        let turned = look_at(&camera(), from, to, 0.0).matrix;
        prop_assert!(turned.x_axis.y.abs() < 1e-15 && turned.y_axis.y < 0.0);
    }
}
