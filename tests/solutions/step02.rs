use course::examples::plane::Plane;
use course::examples::quadric::Quadric;
use glam::{DMat3, DVec3};
use step02_sphere::{Ray, Roots};
use tests::test_law;

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
