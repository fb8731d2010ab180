use exercises::lens::{Interval, inside_all};
use exercises::plane::Plane;
use exercises::quadric::Quadric;
use exercises::*;
use glam::{DMat3, DVec3};
use proptest::prelude::*;
use step02_sphere::{Ray, Roots, Sphere};
use tests::{point, rays, unit};

const AHEAD: Ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };

#[test]
fn a_ray_along_the_plane_or_away_from_it_misses() {
    let wall = |z| Plane { point: DVec3::new(7.0, 8.0, z), normal: 2.0 * DVec3::Z };
    assert_eq!(wall(-3.0).first_hit(&AHEAD), Some(3.0));
    assert_eq!(wall(0.0).first_hit(&AHEAD), None);
    assert_eq!(wall(3.0).first_hit(&AHEAD), None);
    let along = Ray { direction: DVec3::X, ..AHEAD };
    assert_eq!(wall(-3.0).first_hit(&along), None);
    assert_eq!(wall(0.0).first_hit(&along), None);
}

#[test]
fn a_ray_parallel_to_a_cylinder_or_a_side_of_a_cone_is_no_quadratic() {
    let round = DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0));
    let cylinder = Quadric::around(DVec3::ZERO, round, -1.0);
    assert_eq!(cylinder.intersect(&AHEAD), Roots::Zero);
    let cone = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
    let cone = Quadric::around(DVec3::new(0.0, 0.0, -4.0), cone, 0.0);
    let side = Ray { direction: DVec3::new(1.0, 0.0, -1.0), ..AHEAD };
    assert_eq!(cone.coefficients(&side).0, 0.0);
    assert_eq!(cone.intersect(&side), Roots::One(2.0));
}

#[test]
fn where_a_is_below_0_the_smaller_root_still_comes_first() {
    let bowls = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
    let bowls = Quadric::around(DVec3::new(0.0, 0.0, -4.0), bowls, 1.0);
    assert_eq!(bowls.intersect(&AHEAD), Roots::Two(3.0, 5.0));
}

#[test]
fn the_lens_of_a_sphere_with_itself_is_the_sphere() {
    let sphere = Sphere { centre: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
    let whole = Interval { enter: 4.0, leave: 6.0 };
    assert_eq!(inside_all(&[sphere; 2], &AHEAD), Some(whole));
    assert_eq!(inside_all(&[], &AHEAD), Some(lens::RAY));
    let within = Ray { start: sphere.centre, ..AHEAD };
    let half = Interval { enter: 0.0, leave: 1.0 };
    assert_eq!(inside_all(&[sphere], &within), Some(half));
    let beyond = Ray { start: 9.0 * DVec3::NEG_Z, ..AHEAD };
    assert_eq!(inside_all(&[sphere], &beyond), None);
}

/// Symmetric matrices of all kinds of quadrics.
fn symmetric() -> impl Strategy<Value = DMat3> {
    (point(), point()).prop_map(|(diagonal, other)| {
        let DVec3 { x, y, z } = other / 10.0;
        let products = DMat3::from_cols_array(&[0., x, y, x, 0., z, y, z, 0.]);
        DMat3::from_diagonal(diagonal / 10.0) + products
    })
}

proptest! {
    #[test]
    fn hits_satisfy_the_equation_of_the_plane(
        q in point(), n in unit(), start in point(), v in unit(), length in 0.1..5.0
    ) {
        let (plane, ray) =
            (Plane { point: q, normal: n }, Ray { start, direction: length * v });
        let towards = n.dot(q - start) * n.dot(v);
        prop_assume!(1e-3 < n.dot(v).abs());
        let hit = plane.first_hit(&ray);
        prop_assert_eq!(hit.is_some(), 0.0 < towards);
        if let Some(t) = hit {
            prop_assert!(n.dot(ray.at(t) - q).abs() < 1e-9 * (1.0 + t));
        }
    }

    #[test]
    fn hits_satisfy_the_equation_of_the_quadric(
        centre in point(), q in symmetric(), w in -9.0..9.0, start in point(), v in unit()
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
    fn a_point_is_in_the_lens_where_it_is_in_both(
        (one, ray) in rays(), (off, r) in (unit(), 0.1..4.0), k in 0.0..1.5
    ) {
        let other = Sphere { centre: one.centre + 0.7 * (one.radius + r) * off, radius: r };
        let piece = inside_all(&[one, other], &ray);
        prop_assert_eq!(piece, inside_all(&[other, one], &ray));
        let t = k * (one.centre - ray.start).length() / ray.direction.length();
        let deep = |s: &Sphere| s.radius - ray.at(t).distance(s.centre);
        prop_assume!(1e-6 < deep(&one).abs() && 1e-6 < deep(&other).abs());
        let inside = 0.0 < deep(&one) && 0.0 < deep(&other);
        prop_assert_eq!(piece.is_some_and(|p| p.enter <= t && t <= p.leave), inside);
    }
}
