//! Step 2: the quadratic, the sphere, and t of the first hit.

use glam::DVec3;
use proptest::prelude::*;
use step02_sphere::{Ray, Roots, Sphere, quadratic};
use tests::{assert_program_works, random_sphere_and_ray};

const SPHERE: Sphere = Sphere { centre: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };

/// The ray from (x, 0, 0) along −z.
fn ray_ahead(x: f64) -> Ray {
    Ray { start: DVec3::new(x, 0.0, 0.0), direction: DVec3::NEG_Z }
}

#[test]
fn program_draws_the_locked_picture_and_rejects_invalid_arguments() {
    assert_program_works("step02_sphere");
}

#[test]
fn tangent_ray_hits_once_and_ray_outside_never() {
    assert_eq!(SPHERE.intersect(&ray_ahead(1.0)), Roots::One(5.0));
    assert_eq!(SPHERE.intersect(&ray_ahead(1.0)).first_hit(), Some(5.0));
    assert_eq!(SPHERE.intersect(&ray_ahead(1.1)), Roots::Zero);
    assert_eq!(SPHERE.intersect(&ray_ahead(1.1)).first_hit(), None);
}

#[cfg(debug_assertions)]
#[test]
#[should_panic(expected = "a is not above 0")]
fn quadratic_panics_when_a_is_zero() {
    quadratic(0.0, 1.0, 1.0);
}

proptest! {
    #[test]
    fn hits_are_on_the_sphere((sphere, ray) in random_sphere_and_ray()) {
        for t in sphere.intersect(&ray).iter() {
            let distance = ray.at(t).distance(sphere.centre);
            prop_assert!((distance - sphere.radius).abs() < 1e-6 * (1.0 + sphere.radius));
        }
    }

    #[test]
    fn ray_has_hits_if_its_line_passes_through_the_sphere((sphere, ray) in random_sphere_and_ray()) {
        let v = ray.direction.normalize();
        let distance = (sphere.centre - ray.start).cross(v).length();
        prop_assume!((distance - sphere.radius).abs() > 1e-6);
        let count = sphere.intersect(&ray).iter().count();
        prop_assert_eq!(count, if distance < sphere.radius { 2 } else { 0 });
    }

    #[test]
    fn first_hit_is_the_smallest_positive_root((sphere, ray) in random_sphere_and_ray()) {
        let roots = sphere.intersect(&ray);
        let positive_roots = roots.iter().filter(|t| 0.0 < *t);
        prop_assert_eq!(roots.first_hit(), positive_roots.reduce(f64::min));
    }
}
