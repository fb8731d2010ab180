//! Tests of the solutions for step 2.

use course::examples::plane::Plane;
use course::examples::quadric::Quadric;
use glam::{DMat3, DVec3};
use step02_sphere::{Ray, Roots};
use support::test_law;

#[test]
fn quadric_roots_are_in_order_if_coefficient_a_is_0_or_negative() {
    let x2_plus_y2 = DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0));
    let cylinder = Quadric::around(DVec3::ZERO, x2_plus_y2, -1.0);
    let ray_along_axis = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };
    assert_eq!(cylinder.intersect(&ray_along_axis), Roots::Zero);
    let matrix = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
    let [cone, bowls] = [0.0, 1.0].map(|w| Quadric::around(-4.0 * DVec3::Z, matrix, w));
    let ray_along_side = Ray { direction: DVec3::new(1.0, 0.0, -1.0), ..ray_along_axis };
    assert_eq!(cone.coefficients(&ray_along_side).0, 0.0);
    assert_eq!(cone.intersect(&ray_along_side), Roots::One(2.0));
    assert_eq!(bowls.intersect(&ray_along_axis), Roots::Two(3.0, 5.0));
}

#[test]
fn hits_are_on_the_plane() {
    test_law(256, |random| {
        let (q, n) = (random.point(), random.unit_vector());
        let direction = random.number(0.1, 5.0) * random.unit_vector();
        let ray = Ray { start: random.point(), direction };
        let approaches = n.dot(q - ray.start) * n.dot(direction) > 0.0;
        let hit = Plane { point: q, normal: n }.first_hit(&ray);
        assert_eq!(hit.is_some(), approaches);
        if let Some(t) = hit {
            assert!(n.dot(ray.at(t) - q).abs() < 1e-9 * (1.0 + t));
        }
    });
    let wall = Plane { point: DVec3::Z, normal: DVec3::Z };
    assert_eq!(wall.first_hit(&Ray { start: DVec3::ZERO, direction: DVec3::X }), None);
}
