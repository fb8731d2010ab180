//! Step 5: reflection.

use step05_phong::reflect;
use tests::test_law;

#[test]
fn reflection_keeps_length_and_angle() {
    test_law(256, |random| {
        let (l, n) = (random.unit_vector(), random.unit_vector());
        let r = reflect(n, l);
        assert!((r.length() - 1.0).abs() < 1e-12);
        assert!((r.dot(n) - l.dot(n)).abs() < 1e-12);
        assert!(r.cross(l).dot(n).abs() < 1e-12);
        assert!(reflect(n, r).distance(l) < 1e-12);
    });
}
