//! Tests of the solutions for step 1.

use course::examples::look_at::{look_at, passes};
use support::{camera, test_law};

#[test]
fn look_at_passes_its_target_and_keeps_lengths_and_angles() {
    test_law(256, |random| {
        let (position, target, roll) = (random.point(), random.point(), random.number(-3.0, 3.0));
        let turned_camera = look_at(&camera(), position, target, roll);
        let ray = turned_camera.ray(319.5, 179.5);
        assert_eq!(ray.start, position);
        assert!(passes(&ray, target).is_some_and(|distance| distance < 1e-9));
        let (matrix, turned_matrix) = (camera().matrix, turned_camera.matrix);
        let change = turned_matrix.transpose() * turned_matrix - matrix.transpose() * matrix;
        assert!(change.to_cols_array().iter().all(|x| x.abs() < 1e-12));
        assert!(turned_matrix.determinant() * matrix.determinant() > 0.0);
    });
}
