use crate::{
    Camera, Matte, PointLight, Ray, Scene, ambient, diffuse, direction_colour,
    render, scene, visible_point,
};
use glam::DVec3;
use image::RgbImage;

/// The colour that `ray` sees: the lit point, or else its own direction.
pub fn colour(scene: &Scene<Matte, PointLight>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let mut intensity = ambient(point.material, scene.ambient_light);
    for light in &scene.lights {
        let (l, d) = light.direction_from(point.p);
        intensity += diffuse(point.n, l, d, point.material, light);
    }
    intensity
}

/// The picture of step 4: the scene in ambient and diffuse light.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}
