use course::examples::*;
use glam::DVec3;
use proptest::prelude::*;
use step04_diffuse::{Attenuation, Matte, PointLight, SurfacePoint, diffuse, scene};
use tests::{camera, random_point, random_unit_vector};

const GREY: DVec3 = DVec3::splat(0.5);

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

#[test]
fn sphere_hides_lights_behind_it_and_not_before_it() {
    let objects = scene().objects;
    let sphere = objects[0].sphere;
    let position = |radii: f64| sphere.centre + radii * sphere.radius * DVec3::Z;
    let point = SurfacePoint { p: position(4.0), n: DVec3::Z, material: &objects[0].material };
    assert!(shadows::hidden(&objects, &point, position(-1.1), shadows::OFFSET));
    assert!(shadows::hidden(&objects, &point, position(0.9), shadows::OFFSET));
    assert!(!shadows::hidden(&objects, &point, position(2.0), shadows::OFFSET));
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
