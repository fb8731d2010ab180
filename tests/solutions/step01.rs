use course::examples::look_at::{look_at, passes};
use tests::{camera, test_law};

#[test]
fn look_at_passes_its_target_and_keeps_lengths_and_angles() {
    test_law(256, |random| {
        let (from, to, roll) = (random.point(), random.point(), random.number(-3.0, 3.0));
        let turned = look_at(&camera(), from, to, roll);
        let ray = turned.ray(319.5, 179.5);
        assert_eq!(ray.start, from);
        assert!(passes(&ray, to).is_some_and(|distance| distance < 1e-9));
        let (matrix, turned) = (camera().matrix, turned.matrix);
        let change = turned.transpose() * turned - matrix.transpose() * matrix;
        assert!(change.to_cols_array().iter().all(|x| x.abs() < 1e-12));
        assert!(turned.determinant() * matrix.determinant() > 0.0);
    });
}
