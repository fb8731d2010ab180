//! Step 2: the quadratic, the sphere, and t of the first hit.

use step02_sphere::{Roots, quadratic};
use tests::test_law;

#[test]
fn first_hit_of_a_tangent_ray_is_the_one_root() {
    assert_eq!(Roots::One(5.0).first_hit(), Some(5.0));
    assert_eq!(Roots::One(-5.0).first_hit(), None);
}

#[cfg(debug_assertions)]
#[test]
#[should_panic(expected = "a is not above 0")]
fn quadratic_panics_when_a_is_zero() {
    quadratic(0.0, 1.0, 1.0);
}

#[test]
fn hits_are_on_the_sphere() {
    test_law(256, |random| {
        let (sphere, ray) = random.sphere_and_ray();
        for t in sphere.intersect(&ray).iter() {
            let distance = ray.at(t).distance(sphere.centre);
            assert!((distance - sphere.radius).abs() < 1e-6 * (1.0 + sphere.radius));
        }
    });
}

#[test]
fn ray_has_hits_if_its_line_passes_through_the_sphere() {
    test_law(256, |random| {
        let (sphere, ray) = random.sphere_and_ray();
        let v = ray.direction.normalize();
        let margin = sphere.radius - (sphere.centre - ray.start).cross(v).length();
        if 1e-6 < margin.abs() {
            let count = sphere.intersect(&ray).iter().count();
            assert_eq!(count, if 0.0 < margin { 2 } else { 0 });
        }
    });
}

#[test]
fn first_hit_is_the_smallest_positive_root() {
    test_law(256, |random| {
        let (sphere, ray) = random.sphere_and_ray();
        let roots = sphere.intersect(&ray);
        let positive_roots = roots.iter().filter(|t| 0.0 < *t);
        assert_eq!(roots.first_hit(), positive_roots.reduce(f64::min));
    });
}
