//! The scene of step 4 in plaster: a first try at its light.

use image::RgbImage;
use step04_diffuse::{
    Camera, direction_colour, draw_and_save, render, scene, visible_point,
};

/// The picture: the light that reaches each point, as white plaster would show it.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| {
        let Some(point) = visible_point(&scene.objects, ray) else {
            return direction_colour(ray);
        };
        let mut intensity = scene.ambient_light;
        for light in &scene.lights {
            let (l, d) = light.direction_from(point.p);
            let cosine = l.dot(point.n);
            intensity += cosine * light.diffuse / light.attenuation.divisor(d);
        }
        0.8 * intensity
    })
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
