//! Step 2: the quadratic, the sphere, the meaning of t.

use glam::DVec3;
use proptest::prelude::*;
use step02_sphere::{Ray, Roots, Sphere, quadratic};
use tests::{assert_program, rays};

const SPHERE: Sphere = Sphere { centre: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };

fn ahead(x: f64, z: f64) -> Ray {
    Ray { start: DVec3::new(x, 0.0, z), direction: DVec3::NEG_Z }
}

fn ts(roots: Roots) -> Vec<f64> {
    roots.iter().collect()
}

#[test]
fn the_program_draws_helps_and_refuses() {
    assert_program("step02_sphere");
}

#[test]
fn the_discriminant_tells_three_cases_apart() {
    assert_eq!(quadratic(1.0, 0.0, 1.0), Roots::Zero);
    assert_eq!(quadratic(2.0, -8.0, 8.0), Roots::One(2.0));
    assert_eq!(quadratic(2.0, -10.0, 8.0), Roots::Two(1.0, 4.0));
    assert_eq!(quadratic(0.5, 1.0, -4.0), Roots::Two(-4.0, 2.0));
}

#[test]
fn a_tangent_touches_once_and_a_miss_not_at_all() {
    assert_eq!(SPHERE.intersect(&ahead(1.0, 0.0)), Roots::One(5.0));
    assert_eq!(SPHERE.intersect(&ahead(1.0, 0.0)).first_hit(), Some(5.0));
    assert_eq!(SPHERE.intersect(&ahead(1.1, 0.0)), Roots::Zero);
    assert_eq!(SPHERE.intersect(&ahead(1.1, 0.0)).first_hit(), None);
}

#[cfg(debug_assertions)]
#[test]
#[should_panic(expected = "a is not above 0")]
fn a_quadratic_needs_its_square() {
    quadratic(0.0, 1.0, 1.0);
}

proptest! {
    #[test]
    fn a_hit_satisfies_the_equation_of_the_sphere((sphere, ray) in rays()) {
        for t in ts(sphere.intersect(&ray)) {
            let distance = ray.at(t).distance(sphere.centre);
            prop_assert!((distance - sphere.radius).abs() < 1e-6 * (1.0 + sphere.radius));
        }
    }

    #[test]
    fn a_ray_misses_when_its_line_passes_outside((sphere, ray) in rays()) {
        let v = ray.direction.normalize();
        let apart = (sphere.centre - ray.start).cross(v).length();
        prop_assume!((apart - sphere.radius).abs() > 1e-6);
        let count = ts(sphere.intersect(&ray)).len();
        prop_assert_eq!(count, if apart < sphere.radius { 2 } else { 0 });
    }

    #[test]
    fn the_first_hit_is_the_smallest_root_above_0((sphere, ray) in rays()) {
        let roots = sphere.intersect(&ray);
        let above = ts(roots).into_iter().filter(|t| 0.0 < *t);
        prop_assert_eq!(roots.first_hit(), above.reduce(f64::min));
    }
}
