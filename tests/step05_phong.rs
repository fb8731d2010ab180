//! Step 5: reflection, and the Phong sum as a whole.

use glam::DVec3;
use proptest::prelude::*;
use step05_phong::{
    Attenuation, Light, Material, Matte, Phong, PointLight, Ray, SurfacePoint, phong, reflect,
    scene, terms, visible_point,
};
use tests::{assert_program_works, camera, random_point, random_unit_vector};

const GREY: DVec3 = DVec3::splat(0.5);

const MATERIAL: Material = Material {
    matte: Matte { ambient: DVec3::new(0.1, 0.2, 0.3), diffuse: DVec3::new(0.4, 0.5, 0.6) },
    specular: DVec3::new(0.7, 0.8, 0.9),
    shininess: 3,
};

/// A light at `position`, half as bright at any distance.
fn light_at(position: DVec3) -> Light {
    let attenuation = Attenuation { a: 2.0, b: 0.0, c: 0.0 };
    let point_light = PointLight { position, diffuse: DVec3::new(1.0, 0.5, 0.25), attenuation };
    Light { point_light, specular: DVec3::new(0.25, 0.5, 1.0) }
}

/// The Phong terms at `p`, whose unit normal is `n`, seen along the unit vector `v` to the
/// eye, in ambient light `l_a` and one light.
fn phong_terms(p: DVec3, n: DVec3, v: DVec3, l_a: DVec3, light: Light) -> Phong {
    let ray = Ray { start: p + 3.0 * v, direction: -v };
    phong(&SurfacePoint { p, n, material: &MATERIAL }, &ray, l_a, &[light])
}

#[test]
fn program_draws_the_locked_picture_and_rejects_invalid_arguments() {
    assert_program_works("step05_phong");
}

#[test]
fn light_behind_the_surface_adds_neither_diffuse_nor_specular_light() {
    // Seen low over the horizon of the surface y = 0, r·v is 0.28 although n·l < 0.
    let (n, v) = (DVec3::Y, DVec3::new(-0.8, 0.6, 0.0));
    let light = light_at(DVec3::new(4.0, -3.0, 0.0));
    let (l, _) = light.point_light.direction_from(DVec3::ZERO);
    assert!(n.dot(l) < 0.0 && 0.2 < reflect(n, l).dot(v));
    let terms = phong_terms(DVec3::ZERO, n, v, DVec3::ONE, light);
    assert_eq!(terms.sum(), MATERIAL.matte.ambient);
}

#[test]
fn light_on_the_horizon_adds_no_specular_light() {
    let (v, light) = (DVec3::NEG_X, light_at(DVec3::X));
    let terms = phong_terms(DVec3::ZERO, DVec3::Y, v, DVec3::ONE, light);
    assert_eq!(terms.specular, DVec3::ZERO);
}

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

    #[test]
    fn no_term_is_negative(
        p in random_point(), n in random_unit_vector(), v in random_unit_vector(),
        position in random_point()
    ) {
        prop_assume!(0.01 < p.distance(position));
        let terms = phong_terms(p, n, v, GREY, light_at(position));
        for term in [terms.ambient, terms.diffuse, terms.specular] {
            prop_assert!(0.0 <= term.min_element());
        }
    }

    #[test]
    fn moving_all_positions_by_one_offset_keeps_the_sum(
        p in random_point(), n in random_unit_vector(), v in random_unit_vector(),
        position in random_point(), offset in random_point()
    ) {
        prop_assume!(0.1 < p.distance(position));
        let terms = phong_terms(p, n, v, GREY, light_at(position));
        let moved_terms = phong_terms(p + offset, n, v, GREY, light_at(position + offset));
        prop_assert!(terms.sum().distance(moved_terms.sum()) < 1e-9);
    }
}
