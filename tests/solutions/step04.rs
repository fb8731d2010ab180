//! Tests of the solutions for step 4.

use course::examples::gamma;
use glam::DVec3;
use support::camera;

#[test]
fn gamma_is_applied_to_the_mean_of_the_samples() {
    let pictures = [gamma::picture, step04_diffuse::picture];
    let [picture, linear_picture] = pictures.map(|draw| draw(&camera(), 4));
    for (pixel, linear_pixel) in picture.pixels().zip(linear_picture.pixels()) {
        let mean = DVec3::from(linear_pixel.0.map(f64::from)) / 255.0;
        // The linear mean was rounded to an integer, with an error of up to 0.5. Near black, the
        // gamma curve magnifies this error about 13 times.
        assert!(course::largest_channel_difference(pixel, &gamma::rgb8(mean)) <= 6);
    }
}

#[test]
fn linear_and_power_parts_of_the_srgb_curve_meet() {
    let [line, power] = [0.0031308, 0.0031309].map(gamma::srgb);
    assert!(line < power && power < line + 2e-6);
}
