use course::examples::look_at::look_at;
use course::examples::*;
use glam::DVec3;
use proptest::prelude::*;
use tests::{camera, random_point};

#[test]
fn jittered_rays_stay_in_their_sub_pixels() {
    let (camera, side) = (camera(), 4);
    let inverse = camera.matrix.inverse();
    for (x, y) in (0..400).flat_map(|y| (0..400).map(move |x| (x, y))) {
        let centre = |k: i32| (f64::from(k) + 0.5) / f64::from(side) - 0.5;
        let place = DVec3::new(centre(x), centre(y), 1.0);
        let ray = jitter::jittered(&camera, side, place.x, place.y);
        let offset = (inverse * ray.direction - place) * f64::from(side);
        assert!(offset.abs().max_element() < 0.5 + 1e-9, "{x}, {y}: {offset}");
    }
}

proptest! {
    #[test]
    fn ray_through_the_middle_passes_the_target(from in random_point(), to in random_point(), roll in -3.0..3.0) {
        prop_assume!(0.1 < from.distance(to));
        let ray = look_at(&camera(), from, to, roll).ray(319.5, 179.5);
        prop_assert_eq!(ray.start, from);
        prop_assert!(look_at::passes(&ray, to).is_some_and(|distance| distance < 1e-9));
    }

    #[test]
    fn look_at_keeps_lengths_and_angles(from in random_point(), to in random_point(), roll in -3.0..3.0) {
        prop_assume!(0.1 < from.distance(to));
        let (matrix, turned_matrix) = (camera().matrix, look_at(&camera(), from, to, roll).matrix);
        let change = turned_matrix.transpose() * turned_matrix - matrix.transpose() * matrix;
        prop_assert!(change.to_cols_array().iter().all(|x| x.abs() < 1e-12));
        prop_assert!(turned_matrix.determinant() * matrix.determinant() > 0.0);
    }
}
