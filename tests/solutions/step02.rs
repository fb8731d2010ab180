use course::examples::lens::inside_all;
use course::examples::plane::Plane;
use course::examples::quadric::Quadric;
use glam::{DMat3, DVec3};
use proptest::prelude::*;
use step02_sphere::{Ray, Roots, Sphere};
use tests::{random_point, random_sphere_and_ray, random_unit_vector};

#[test]
fn quadric_has_at_most_one_root_when_a_is_zero() {
    let x2_plus_y2 = DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0));
    let cylinder = Quadric::around(DVec3::ZERO, x2_plus_y2, -1.0);
    let ray_along_axis = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };
    assert_eq!(cylinder.intersect(&ray_along_axis), Roots::Zero);
    let cone = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
    let cone = Quadric::around(DVec3::new(0.0, 0.0, -4.0), cone, 0.0);
    let ray_along_side = Ray { direction: DVec3::new(1.0, 0.0, -1.0), ..ray_along_axis };
    assert_eq!(cone.coefficients(&ray_along_side).0, 0.0);
    assert_eq!(cone.intersect(&ray_along_side), Roots::One(2.0));
}

/// Symmetric matrices, of quadrics of all kinds.
fn random_symmetric_matrix() -> impl Strategy<Value = DMat3> {
    (random_point(), random_point()).prop_map(|(diagonal, products)| {
        let DVec3 { x, y, z } = products / 10.0;
        let off_diagonal = DMat3::from_cols_array(&[0., x, y, x, 0., z, y, z, 0.]);
        DMat3::from_diagonal(diagonal / 10.0) + off_diagonal
    })
}

proptest! {
    #[test]
    fn hits_are_on_the_plane(
        q in random_point(), n in random_unit_vector(), start in random_point(), v in random_unit_vector(), length in 0.1..5.0
    ) {
        let (plane, ray) =
            (Plane { point: q, normal: n }, Ray { start, direction: length * v });
        let approaches = 0.0 < n.dot(q - start) * n.dot(v);
        prop_assume!(1e-3 < n.dot(v).abs());
        let hit = plane.first_hit(&ray);
        prop_assert_eq!(hit.is_some(), approaches);
        if let Some(t) = hit {
            prop_assert!(n.dot(ray.at(t) - q).abs() < 1e-9 * (1.0 + t));
        }
    }

    #[test]
    fn hits_are_on_the_quadric(
        centre in random_point(), q in random_symmetric_matrix(), w in -9.0..9.0, start in random_point(), v in random_unit_vector()
    ) {
        let (quadric, ray) = (Quadric::around(centre, q, w), Ray { start, direction: v });
        prop_assume!(1e-3 < quadric.coefficients(&ray).0.abs());
        let ts: Vec<f64> = quadric.intersect(&ray).iter().collect();
        prop_assert!(ts.is_sorted());
        for t in ts {
            let p = ray.at(t) - centre;
            prop_assert!((p.dot(q * p) + w).abs() < 1e-9 * (1.0 + t * t));
        }
    }

    #[test]
    fn lens_has_the_points_that_are_inside_both_spheres(
        (sphere, ray) in random_sphere_and_ray(),
        (unit_vector, radius) in (random_unit_vector(), 0.1..4.0), k in 0.0..1.5
    ) {
        let offset = 0.7 * (sphere.radius + radius) * unit_vector;
        let neighbour = Sphere { centre: sphere.centre + offset, radius };
        let interval = inside_all(&[sphere, neighbour], &ray);
        prop_assert_eq!(interval, inside_all(&[neighbour, sphere], &ray));
        let t = k * (sphere.centre - ray.start).length() / ray.direction.length();
        let depths = [sphere, neighbour].map(|s| s.radius - ray.at(t).distance(s.centre));
        prop_assume!(depths.iter().all(|depth| 1e-6 < depth.abs()));
        let is_inside_both = depths.iter().all(|depth| 0.0 < *depth);
        let is_in_interval = interval.is_some_and(|i| i.enter <= t && t <= i.leave);
        prop_assert_eq!(is_in_interval, is_inside_both);
    }
}
