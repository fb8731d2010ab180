use exercises::*;
use glam::DVec3;
use image::Rgb;
use proptest::prelude::*;
use step04_diffuse::{
    Attenuation, COOL, Matte, Object, PointLight, Ray, SurfacePoint, WARM, diffuse,
    scene, visible_point,
};
use tests::{camera, point, rays_of_camera, unit};

const GREY: DVec3 = DVec3::splat(0.5);

// gamma

#[test]
fn half_the_light_is_the_byte_188_and_too_much_is_white() {
    assert_eq!(gamma::rgb8(GREY), Rgb([188; 3]));
    assert_eq!(gamma::rgb8(DVec3::new(-1.0, 2.0, 1e9)), Rgb([0, 255, 255]));
}

#[test]
fn the_curve_comes_after_the_mean() {
    let pictures = [gamma::picture, step04_diffuse::picture];
    let [ours, linear] = pictures.map(|picture| picture(&camera(), 4));
    for (ours, linear) in ours.pixels().zip(linear.pixels()) {
        let linear = DVec3::from(linear.0.map(f64::from)) / 255.0;
        // A dark one that is rounded before the curve may be off by 6.
        assert!(compare::apart(ours, &gamma::rgb8(linear)) <= 6);
    }
}

// shadows

/// The objects of the scene, each with its place in the list.
fn numbered() -> Vec<Object<usize>> {
    let objects = scene().objects.into_iter().enumerate();
    objects.map(|(place, object)| object.with_material(place)).collect()
}

#[test]
fn a_sphere_hides_a_light_behind_it_and_none_before_it() {
    let objects = numbered();
    let sphere = objects[0].sphere;
    let at = |radii: f64| sphere.centre + radii * sphere.radius * DVec3::Z;
    let point = SurfacePoint { p: at(4.0), n: DVec3::Z, material: &0 };
    assert!(shadows::hidden(&objects, &point, at(-1.1)));
    assert!(shadows::hidden(&objects, &point, at(0.9)));
    assert!(!shadows::hidden(&objects, &point, at(2.0)));
}

#[test]
fn a_surface_that_faces_a_light_is_hidden_by_other_objects_only() {
    let (objects, mut hidden_by_itself) = (numbered(), 0);
    for ray in rays_of_camera() {
        let Some(point) = visible_point(&objects, &ray) else { continue };
        for q in [WARM.position, COOL.position] {
            if point.n.dot(q - point.p) <= 0.0 {
                continue;
            }
            let ray = Ray { start: point.p, direction: q - point.p };
            let hides = |object: &Object<usize>| {
                object.sphere.intersect(&ray).first_hit().is_some_and(|t| t < 1.0)
            };
            let own = *point.material;
            let other = objects.iter().any(|one| one.material != own && hides(one));
            assert_eq!(shadows::hidden(&objects, &point, q), other, "{point:?}");
            hidden_by_itself += u32::from(hides(&objects[own]));
        }
    }
    // Without the offset there would be this many wrong shadows.
    assert!(50_000 < hidden_by_itself, "{hidden_by_itself}");
}

proptest! {
    #[test]
    fn the_curve_rises_and_has_its_inverse(i in 0.0..1.0) {
        let v = gamma::srgb(i);
        prop_assert!(i <= v && v < gamma::srgb(i + 1e-6));
        let back =
            if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
        prop_assert!((back - i).abs() < 1e-7);
    }

    #[test]
    fn the_sun_is_a_point_light_far_away_that_does_not_fade(p in point(), n in unit()) {
        let sun::Sun { direction, diffuse: l_d } = sun::SUN;
        let attenuation = Attenuation { a: 1.0, b: 0.0, c: 0.0 };
        let light = PointLight { position: 1e9 * direction, diffuse: l_d, attenuation };
        let ((l, d), grey) = (light.direction_from(p), Matte::of(GREY));
        let far = diffuse(n, l, d, &grey, &light);
        prop_assert!(sun::SUN.diffuse(n, &grey).distance(far) < 1e-7);
    }
}
