use course::examples::look_at::look_at;
use course::examples::*;
use glam::DVec3;
use tests::{camera, test_law};

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

#[test]
fn look_at_passes_its_target_and_keeps_lengths_and_angles() {
    test_law(256, |random| {
        let (from, to, roll) = (random.point(), random.point(), random.number(-3.0, 3.0));
        let turned = look_at(&camera(), from, to, roll);
        let ray = turned.ray(319.5, 179.5);
        assert_eq!(ray.start, from);
        assert!(look_at::passes(&ray, to).is_some_and(|distance| distance < 1e-9));
        let (matrix, turned) = (camera().matrix, turned.matrix);
        let change = turned.transpose() * turned - matrix.transpose() * matrix;
        assert!(change.to_cols_array().iter().all(|x| x.abs() < 1e-12));
        assert!(turned.determinant() * matrix.determinant() > 0.0);
    });
}
