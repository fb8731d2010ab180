//! Step 4: the normal, ambient and diffuse light.

use glam::DVec3;
use proptest::prelude::*;
use step04_diffuse::{
    Attenuation, COOL, Matte, OBJECTS, Object, PointLight, Ray, Sphere, WARM,
    ambient, colour, diffuse, normal, scene, visible_point,
};
use tests::{assert_program, point, rays};

const GREY: Matte =
    Matte { ambient: DVec3::splat(0.5), diffuse: DVec3::splat(0.5) };

/// A light of colour (1, 0.5, 0.25) with the given a, b and c.
fn light(a: f64, b: f64, c: f64) -> PointLight {
    PointLight {
        position: DVec3::new(0.0, 3.0, 4.0),
        diffuse: DVec3::new(1.0, 0.5, 0.25),
        attenuation: Attenuation { a, b, c },
    }
}

#[test]
fn the_program_draws_helps_and_refuses() {
    assert_program("step04_diffuse");
}

#[test]
fn ambient_light_is_r_a_times_l_a() {
    let material = Matte { ambient: DVec3::new(1.0, 0.5, 0.0), ..GREY };
    assert_eq!(ambient(&material, GREY.ambient), DVec3::new(0.5, 0.25, 0.0));
}

#[test]
fn a_surface_of_one_colour_reflects_it_in_both_terms() {
    let colour = DVec3::new(0.1, 0.2, 0.3);
    assert_eq!(Matte::of(colour), Matte { ambient: colour, diffuse: colour });
}

#[test]
fn each_of_a_b_and_c_attenuates_alone() {
    let at_3 = |a, b, c| Attenuation { a, b, c }.divisor(3.0);
    assert_eq!(
        [at_3(2.0, 0.0, 0.0), at_3(0.0, 2.0, 0.0), at_3(0.0, 0.0, 2.0)],
        [2.0, 6.0, 18.0]
    );
    assert_eq!(at_3(1.0, 2.0, 3.0), 34.0);
    let white = Matte::of(DVec3::ONE);
    let lit = |a, b, c| diffuse(DVec3::Y, DVec3::Y, 4.0, &white, &light(a, b, c)).x;
    assert_eq!(
        [lit(2.0, 0.0, 0.0), lit(0.0, 1.0, 0.0), lit(0.0, 0.0, 1.0)],
        [0.5, 0.25, 0.0625]
    );
}

#[test]
fn the_scene_is_that_of_step_3_in_two_lights() {
    let scene = scene();
    assert_eq!(scene.lights, [WARM, COOL]);
    for (lit, flat) in scene.objects.iter().zip(OBJECTS) {
        assert_eq!(*lit, flat.with_material(Matte::of(flat.material)));
    }
    assert_eq!(scene.objects.len(), 9);
}

#[test]
fn a_pixel_is_the_sum_of_the_ambient_term_and_every_light() {
    // The ray through the middle of the largest sphere meets it head-on.
    let [Object { sphere, material: r, .. }, ..] = OBJECTS;
    let ray = Ray { start: DVec3::ZERO, direction: sphere.centre };
    let p = sphere.centre * (1.0 - sphere.radius / sphere.centre.length());
    let n = (p - sphere.centre) / sphere.radius;
    let mut sum = r * scene().ambient_light;
    for light in scene().lights {
        let Attenuation { a, b, c } = light.attenuation;
        let d = light.position.distance(p);
        let cosine = (light.position - p).dot(n) / d;
        sum += r / (a + b * d + c * d * d) * cosine.max(0.0) * light.diffuse;
    }
    assert!(colour(&scene(), &ray).distance(sum) < 1e-12);
}

#[test]
fn a_ray_that_meets_nothing_sees_no_point() {
    let up = Ray { start: DVec3::ZERO, direction: DVec3::Y };
    assert_eq!(visible_point(&OBJECTS, &up), None);
}

proptest! {
    #[test]
    fn the_normal_is_a_unit_vector_away_from_the_centre((sphere, ray) in rays()) {
        let Some(t) = sphere.intersect(&ray).first_hit() else { return Ok(()) };
        let n = normal(&sphere, ray.at(t));
        prop_assert!((n.length() - 1.0).abs() < 1e-5);
        prop_assert!((sphere.centre + sphere.radius * n).distance(ray.at(t)) < 1e-9);
        let behind = Sphere { centre: ray.start - 9.0 * ray.direction, radius: 0.1 };
        let objects = [(behind, 'b'), (sphere, 's')];
        let objects = objects.map(|(sphere, material)| Object { name: "ball", sphere, material });
        let point = visible_point(&objects, &ray).map(|point| (point.p, point.n, *point.material));
        prop_assert_eq!(point, Some((ray.at(t), n, 's')));
    }

    #[test]
    fn from_anywhere_l_has_length_1_and_leads_to_the_light(p in point()) {
        let light = light(1.0, 0.0, 0.0);
        prop_assume!(0.01 < p.distance(light.position));
        let (l, d) = light.direction_from(p);
        prop_assert!((l.length() - 1.0).abs() < 1e-12);
        prop_assert!((p + d * l).distance(light.position) < 1e-9);
    }
}
