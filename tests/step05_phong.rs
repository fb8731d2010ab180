//! Step 5: reflection, the specular term and the whole Phong sum.

use glam::{DVec3, Vec3Swizzles};
use proptest::prelude::*;
use step05_phong::{
    Attenuation, Light, Material, Matte, OBJECTS, Phong, PointLight, Ray,
    SurfacePoint, ambient, colour, diffuse, phong, reflect, scene, specular, terms,
    visible_point,
};
use tests::{assert_program, camera, point, unit};

const MATERIAL: Material = Material {
    matte: Matte {
        ambient: DVec3::new(0.1, 0.2, 0.3),
        diffuse: DVec3::new(0.4, 0.5, 0.6),
    },
    specular: DVec3::new(0.7, 0.8, 0.9),
    shininess: 3,
};

/// A light at `position`, with attenuation 1/2.
fn light(position: DVec3) -> Light {
    let attenuation = Attenuation { a: 2.0, b: 0.0, c: 0.0 };
    let point_light =
        PointLight { position, diffuse: DVec3::new(1.0, 0.5, 0.25), attenuation };
    Light { point_light, specular: DVec3::new(0.25, 0.5, 1.0) }
}

/// The light from `p`, whose unit normal is `n`, along the unit vector `v` to the eye.
fn from(p: DVec3, n: DVec3, v: DVec3, l_a: DVec3, lights: &[Light]) -> Phong {
    let ray = Ray { start: p + 3.0 * v, direction: -v };
    phong(&SurfacePoint { p, n, material: &MATERIAL }, &ray, l_a, lights)
}

#[test]
fn the_program_draws_helps_and_refuses() {
    assert_program("step05_phong");
}

#[test]
fn nothing_is_mirrored_away_from_the_eye() {
    assert_eq!(
        specular(DVec3::Y, DVec3::NEG_Y, 9.0, &MATERIAL, &light(DVec3::Y)),
        DVec3::ZERO
    );
}

#[test]
fn attenuation_fades_highlights_too() {
    let mut light = light(DVec3::Y);
    light.point_light.attenuation = Attenuation { a: 1.0, b: 2.0, c: 3.0 };
    let lit = specular(DVec3::Y, DVec3::Y, 3.0, &MATERIAL, &light);
    assert!(lit.distance(MATERIAL.specular * light.specular / 34.0) < 1e-15);
}

#[test]
fn a_light_behind_the_surface_gives_neither_diffuse_nor_specular_light() {
    // Behind the surface y = 0, low over the horizon: r·v is 0.28 although n·l < 0.
    let (n, v) = (DVec3::Y, DVec3::new(-0.8, 0.6, 0.0));
    let behind = light(DVec3::new(4.0, -3.0, 0.0));
    let (l, _) = behind.point_light.direction_from(DVec3::ZERO);
    assert!(n.dot(l) < 0.0 && 0.2 < reflect(n, l).dot(v));
    let sum = from(DVec3::ZERO, n, v, DVec3::ONE, &[behind]);
    assert_eq!(sum.sum(), MATERIAL.matte.ambient);
}

#[test]
fn a_light_on_the_horizon_gives_no_highlight() {
    let beside = light(DVec3::X);
    let sum = from(DVec3::ZERO, DVec3::Y, DVec3::NEG_X, DVec3::ONE, &[beside]);
    assert_eq!(sum.specular, DVec3::ZERO);
}

#[test]
fn the_sum_runs_over_all_lights_and_all_terms() {
    let lights =
        [light(DVec3::new(0.0, 4.0, 3.0)), light(DVec3::new(-4.0, 4.0, 2.0))];
    let (p, n, v) =
        (DVec3::new(0.0, 1.0, 0.0), DVec3::Y, DVec3::new(0.0, 0.8, -0.6));
    let sum = from(p, n, v, GREY, &lights);
    let mut expected = [MATERIAL.matte.ambient * GREY, DVec3::ZERO, DVec3::ZERO];
    for light in &lights {
        let (l, d) = light.point_light.direction_from(p);
        expected[1] += diffuse(n, l, d, &MATERIAL.matte, &light.point_light);
        expected[2] += specular(reflect(n, l), v, d, &MATERIAL, light);
    }
    assert_eq!([sum.ambient, sum.diffuse, sum.specular], expected);
    assert!(0.0 < sum.specular.min_element() && 0.0 < sum.diffuse.min_element());
    assert!(sum.sum().distance(expected.iter().sum()) < 1e-15);
}

const GREY: DVec3 = DVec3::splat(0.5);

#[test]
fn v_is_a_unit_vector_to_the_eye() {
    let (scene, ray) = (scene(), camera().ray(245.0, 155.0));
    let point = visible_point(&scene.objects, &ray)
        .expect("the highlight of the red sphere");
    let long = Ray { direction: 3.0 * ray.direction, ..ray };
    let sum = phong(&point, &long, scene.ambient_light, &scene.lights);
    let found = terms(&scene, &ray).expect("a hit");
    assert!(0.1 < found.specular.max_element());
    assert!(found.specular.distance(sum.specular) < 1e-12);
    assert_eq!(colour(&scene, &ray), found.sum());
    assert_eq!(found.ambient, ambient(&point.material.matte, scene.ambient_light));
}

#[test]
fn each_object_has_the_place_and_the_colour_that_step_3_gave_it() {
    let scene = scene();
    assert_eq!(scene.objects.len(), 9);
    for (shiny, flat) in scene.objects.iter().zip(OBJECTS) {
        assert_eq!((shiny.name, shiny.sphere), (flat.name, flat.sphere));
        assert_eq!(shiny.material.matte, Matte::of(flat.material));
    }
    let matte = step04_diffuse::scene();
    let lights: Vec<_> =
        scene.lights.iter().map(|light| light.point_light).collect();
    assert_eq!((scene.ambient_light, lights), (matte.ambient_light, matte.lights));
}

proptest! {
    #[test]
    fn reflection_keeps_length_and_angle(l in unit(), n in unit()) {
        let r = reflect(n, l);
        prop_assert!((r.length() - 1.0).abs() < 1e-12);
        prop_assert!((r.dot(n) - l.dot(n)).abs() < 1e-12);
        prop_assert!(r.cross(l).dot(n).abs() < 1e-12);
        prop_assert!(reflect(n, r).distance(l) < 1e-12);
    }

    #[test]
    fn light_is_never_negative(p in point(), n in unit(), v in unit(), at in point()) {
        prop_assume!(0.01 < p.distance(at));
        let sum = from(p, n, v, GREY, &[light(at)]);
        for term in [sum.ambient, sum.diffuse, sum.specular] {
            prop_assert!(0.0 <= term.min_element());
        }
    }

    #[test]
    fn swapping_red_and_blue_everywhere_swaps_them_in_the_result(
        p in point(), n in unit(), v in unit(), at in point()
    ) {
        prop_assume!(0.01 < p.distance(at));
        let (white, m) = (light(at), MATERIAL);
        let swapped = Light {
            point_light: PointLight { diffuse: white.point_light.diffuse.zyx(), ..white.point_light },
            specular: white.specular.zyx(),
        };
        let matte = Matte { ambient: m.matte.ambient.zyx(), diffuse: m.matte.diffuse.zyx() };
        let material = Material { matte, specular: m.specular.zyx(), ..m };
        let l_a = DVec3::new(0.1, 0.2, 0.3);
        let ray = Ray { start: p + v, direction: -v };
        let sum = phong(&SurfacePoint { p, n, material: &m }, &ray, l_a, &[white]).sum();
        let again = phong(&SurfacePoint { p, n, material: &material }, &ray, l_a.zyx(), &[swapped]);
        prop_assert_eq!(again.sum(), sum.zyx());
    }

    #[test]
    fn moving_everything_by_one_offset_changes_nothing(
        p in point(), n in unit(), v in unit(), at in point(), by in point()
    ) {
        prop_assume!(0.1 < p.distance(at));
        let sum = from(p, n, v, GREY, &[light(at)]).sum();
        let moved = from(p + by, n, v, GREY, &[light(at + by)]).sum();
        prop_assert!(sum.distance(moved) < 1e-9);
    }
}
