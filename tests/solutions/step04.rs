use course::examples::*;
use glam::DVec3;
use image::Rgb;
use proptest::prelude::*;
use step04_diffuse::{
    Attenuation, COOL, Matte, Object, PointLight, Ray, SurfacePoint, WARM, diffuse, scene,
    visible_point,
};
use tests::{camera, primary_rays, random_point, random_unit_vector};

const GREY: DVec3 = DVec3::splat(0.5);

// gamma

#[test]
fn gamma_gives_byte_188_for_half_the_light_and_white_above_1() {
    assert_eq!(gamma::rgb8(GREY), Rgb([188; 3]));
    assert_eq!(gamma::rgb8(DVec3::new(-1.0, 2.0, 1e9)), Rgb([0, 255, 255]));
}

#[test]
fn gamma_is_applied_to_the_mean_of_the_samples() {
    let pictures = [gamma::picture, step04_diffuse::picture];
    let [picture, linear_picture] = pictures.map(|draw| draw(&camera(), 4));
    for (pixel, linear_pixel) in picture.pixels().zip(linear_picture.pixels()) {
        let mean = DVec3::from(linear_pixel.0.map(f64::from)) / 255.0;
        // The mean was rounded to a byte: where it is dark, the curve makes 6 of it.
        assert!(course::largest_channel_difference(pixel, &gamma::rgb8(mean)) <= 6);
    }
}

// shadows

/// The objects of the scene, each with its index as its material.
fn objects_with_index() -> Vec<Object<usize>> {
    let objects = scene().objects.into_iter().enumerate();
    objects.map(|(index, object)| object.with_material(index)).collect()
}

#[test]
fn sphere_hides_lights_behind_it_and_not_before_it() {
    let objects = objects_with_index();
    let sphere = objects[0].sphere;
    let position = |radii: f64| sphere.centre + radii * sphere.radius * DVec3::Z;
    let point = SurfacePoint { p: position(4.0), n: DVec3::Z, material: &0 };
    assert!(shadows::hidden(&objects, &point, position(-1.1), shadows::OFFSET));
    assert!(shadows::hidden(&objects, &point, position(0.9), shadows::OFFSET));
    assert!(!shadows::hidden(&objects, &point, position(2.0), shadows::OFFSET));
}

#[test]
fn surface_facing_a_light_is_hidden_by_other_objects_only() {
    let (objects, mut self_hits) = (objects_with_index(), 0);
    for ray in primary_rays() {
        let Some(point) = visible_point(&objects, &ray) else { continue };
        for q in [WARM.position, COOL.position] {
            if point.n.dot(q - point.p) <= 0.0 {
                continue;
            }
            let ray = Ray { start: point.p, direction: q - point.p };
            let hides = |object: &Object<usize>| {
                object.sphere.intersect(&ray).first_hit().is_some_and(|t| t < 1.0)
            };
            let index = *point.material;
            let mut others = objects.iter().filter(|object| object.material != index);
            let is_hidden = others.any(hides);
            assert_eq!(
                shadows::hidden(&objects, &point, q, shadows::OFFSET),
                is_hidden,
                "{point:?}"
            );
            self_hits += u32::from(hides(&objects[index]));
        }
    }
    // Rays that start without the offset would give this many wrong shadows.
    assert!(50_000 < self_hits, "{self_hits}");
}

proptest! {
    #[test]
    fn srgb_rises_and_its_inverse_gives_the_intensity_back(i in 0.0..1.0) {
        let v = gamma::srgb(i);
        prop_assert!(i <= v && v < gamma::srgb(i + 1e-6));
        let intensity =
            if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
        prop_assert!((intensity - i).abs() < 1e-7);
    }

    #[test]
    fn sun_lights_like_a_distant_point_light_without_attenuation(p in random_point(), n in random_unit_vector()) {
        let sun::Sun { direction, diffuse: l_d } = sun::SUN;
        let attenuation = Attenuation { a: 1.0, b: 0.0, c: 0.0 };
        let light = PointLight { position: 1e9 * direction, diffuse: l_d, attenuation };
        let ((l, d), grey) = (light.direction_from(p), Matte::of(GREY));
        let point_light_diffuse = diffuse(n, l, d, &grey, &light);
        prop_assert!(sun::SUN.diffuse(n, &grey).distance(point_light_diffuse) < 1e-7);
    }
}
