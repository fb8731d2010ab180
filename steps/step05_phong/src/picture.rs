use crate::{
    Camera, Light, Material, Ray, Scene, Terms, direction_colour, phong, render,
    scene, visible_point,
};
use glam::DVec3;
use image::RgbImage;

/// The terms of the light that comes back along `ray`, or None if it meets nothing.
pub fn terms(scene: &Scene<Material, Light>, ray: &Ray) -> Option<Terms> {
    let point = visible_point(&scene.objects, ray)?;
    Some(phong(&point, ray, scene.ambient_light, &scene.lights))
}

/// The colour that `ray` sees: the sum of the terms, or else the colour of the sky.
/// ```
/// use step05_phong::{Camera, colour, render, scene};
/// let camera = Camera::new(64, 36, 60_f64.to_radians());
/// let mut warm_scene = scene();
/// warm_scene.lights.truncate(1); // Only the first light is left, the warm one.
/// let image = render(&camera, 1, |ray| colour(&warm_scene, ray));
/// assert_ne!(image, step05_phong::picture(&camera, 1));
/// ```
pub fn colour(scene: &Scene<Material, Light>, ray: &Ray) -> DVec3 {
    match terms(scene, ray) {
        Some(terms) => terms.sum(),
        None => direction_colour(ray),
    }
}

/// The picture of step 5, the final one: the scene in the whole Phong sum.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}
