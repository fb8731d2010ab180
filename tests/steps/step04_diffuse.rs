//! Step 4: surface points, and the direction to a light.

use glam::DVec3;
use step04_diffuse::{Object, PointLight, Sphere, WARM, normal, visible_point};
use tests::test_law;

#[test]
fn visible_point_has_the_nearest_hit_and_a_unit_normal() {
    test_law(256, |random| {
        let (sphere, ray) = random.sphere_and_ray();
        let Some(t) = sphere.intersect(&ray).first_hit() else { return };
        let n = normal(&sphere, ray.at(t));
        assert!((n.length() - 1.0).abs() < 1e-5);
        assert!((sphere.centre + sphere.radius * n).distance(ray.at(t)) < 1e-9);
        let sphere_behind = Sphere { centre: ray.start - 9.0 * ray.direction, radius: 0.1 };
        let objects = [(sphere_behind, 'b'), (sphere, 's')];
        let objects = objects.map(|(sphere, material)| Object { name: "ball", sphere, material });
        let point = visible_point(&objects, &ray).map(|point| (point.p, point.n, *point.material));
        assert_eq!(point, Some((ray.at(t), n, 's')));
    });
}

#[test]
fn direction_to_a_light_has_length_1_and_leads_there() {
    test_law(256, |random| {
        let light = PointLight { position: DVec3::new(0.0, 3.0, 4.0), ..WARM };
        let p = random.point();
        let (l, d) = light.direction_from(p);
        assert!((l.length() - 1.0).abs() < 1e-12);
        assert!((p + d * l).distance(light.position) < 1e-9);
    });
}
