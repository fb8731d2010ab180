//! Step 2: cases of the quadratic that no worked example or picture covers.

use step02_sphere::{Roots, quadratic};

#[test]
fn first_hit_of_a_tangent_ray_is_its_one_root_unless_negative() {
    assert_eq!(Roots::One(5.0).first_hit(), Some(5.0));
    assert_eq!(Roots::One(-5.0).first_hit(), None);
}

#[test]
fn one_root_is_divided_by_2a() {
    assert_eq!(quadratic(4.0, -8.0, 4.0), Roots::One(1.0));
}

#[cfg(debug_assertions)]
#[test]
#[should_panic(expected = "a is not above 0")]
fn quadratic_panics_when_a_is_zero() {
    quadratic(0.0, 1.0, 1.0);
}
