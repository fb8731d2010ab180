//! Step 5: reflection.

use proptest::prelude::*;
use step05_phong::reflect;
use tests::random_unit_vector;

proptest! {
    #[test]
    fn reflection_keeps_length_and_angle(l in random_unit_vector(), n in random_unit_vector()) {
        let r = reflect(n, l);
        prop_assert!((r.length() - 1.0).abs() < 1e-12);
        prop_assert!((r.dot(n) - l.dot(n)).abs() < 1e-12);
        prop_assert!(r.cross(l).dot(n).abs() < 1e-12);
        prop_assert!(reflect(n, r).distance(l) < 1e-12);
    }
}
