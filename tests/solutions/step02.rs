use course::examples::lens::inside_all;
use course::examples::plane::Plane;
use course::examples::quadric::Quadric;
use glam::{DMat3, DVec3};
use step02_sphere::{Ray, Roots, Sphere};
use tests::{RandomInputs, test_law};

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

/// A symmetric matrix, of a quadric of any kind.
fn symmetric_matrix(random: &mut RandomInputs) -> DMat3 {
    let DVec3 { x, y, z } = random.point() / 10.0;
    let off_diagonal = DMat3::from_cols_array(&[0., x, y, x, 0., z, y, z, 0.]);
    DMat3::from_diagonal(random.point() / 10.0) + off_diagonal
}

#[test]
fn hits_are_on_the_plane() {
    test_law(256, |random| {
        let (q, n) = (random.point(), random.unit_vector());
        let direction = random.number(0.1, 5.0) * random.unit_vector();
        let ray = Ray { start: random.point(), direction };
        let approaches = 0.0 < n.dot(q - ray.start) * n.dot(direction);
        let hit = Plane { point: q, normal: n }.first_hit(&ray);
        assert_eq!(hit.is_some(), approaches);
        if let Some(t) = hit {
            assert!(n.dot(ray.at(t) - q).abs() < 1e-9 * (1.0 + t));
        }
    });
}

#[test]
fn hits_are_on_the_quadric() {
    test_law(256, |random| {
        let (centre, q, w) = (random.point(), symmetric_matrix(random), random.number(-9.0, 9.0));
        let ray = Ray { start: random.point(), direction: random.unit_vector() };
        let quadric = Quadric::around(centre, q, w);
        if quadric.coefficients(&ray).0.abs() < 1e-3 {
            return;
        }
        let ts: Vec<f64> = quadric.intersect(&ray).iter().collect();
        assert!(ts.is_sorted());
        for t in ts {
            let p = ray.at(t) - centre;
            assert!((p.dot(q * p) + w).abs() < 1e-9 * (1.0 + t * t));
        }
    });
}

#[test]
fn lens_has_the_points_that_are_inside_both_spheres() {
    test_law(256, |random| {
        let ((sphere, ray), radius) = (random.sphere_and_ray(), random.number(0.1, 4.0));
        let offset = 0.7 * (sphere.radius + radius) * random.unit_vector();
        let neighbour = Sphere { centre: sphere.centre + offset, radius };
        let interval = inside_all(&[sphere, neighbour], &ray);
        assert_eq!(interval, inside_all(&[neighbour, sphere], &ray));
        let way = random.number(0.0, 1.5) * (sphere.centre - ray.start).length();
        let t = way / ray.direction.length();
        let depths = [sphere, neighbour].map(|s| s.radius - ray.at(t).distance(s.centre));
        let is_inside_both = depths.iter().all(|depth| 0.0 < *depth);
        assert_eq!(interval.is_some_and(|i| i.enter <= t && t <= i.leave), is_inside_both);
    });
}
