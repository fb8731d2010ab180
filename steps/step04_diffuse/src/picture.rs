use crate::{
    Camera, Matte, PointLight, Ray, Scene, ambient, diffuse_at, direction_colour,
    render, scene, visible_point,
};
use glam::DVec3;
use image::RgbImage;

/// The colour that `ray` sees: that of the lit point, or else that of the sky.
pub fn colour(scene: &Scene<Matte, PointLight>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let mut intensity = ambient(point.material(), scene.ambient_light);
    for light in &scene.lights {
        intensity += diffuse_at(point.p, point.n, point.material(), light);
    }
    intensity
}

/// The picture of step 4: the scene in ambient and diffuse light.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}
