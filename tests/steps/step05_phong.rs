//! Step 5: reflection, and the Phong sum as a whole.

use proptest::prelude::*;
use step05_phong::{Ray, phong, reflect, scene, terms, visible_point};
use tests::{camera, random_unit_vector};

#[test]
fn terms_do_not_depend_on_the_length_of_the_ray() {
    // A ray to the highlight of the red sphere.
    let (scene, ray) = (scene(), camera().ray(245.0, 155.0));
    let point = visible_point(&scene.objects, &ray).expect("the red sphere");
    let long_ray = Ray { direction: 3.0 * ray.direction, ..ray };
    let long_ray_terms = phong(&point, &long_ray, scene.ambient_light, &scene.lights);
    let terms = terms(&scene, &ray).expect("a hit");
    assert!(0.1 < terms.specular.max_element());
    assert!(terms.specular.distance(long_ray_terms.specular) < 1e-12);
}

proptest! {
    #[test]
    fn reflection_keeps_length_and_angle(l in random_unit_vector(), n in random_unit_vector()) {
        let r = reflect(n, l);
        prop_assert!((r.length() - 1.0).abs() < 1e-12);
        prop_assert!((r.dot(n) - l.dot(n)).abs() < 1e-12);
        prop_assert!(r.cross(l).dot(n).abs() < 1e-12);
        prop_assert!(reflect(n, r).distance(l) < 1e-12);
    }
}
