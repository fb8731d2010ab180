//! Step 5 without its test of n·l. A chapter shows what the picture would look like.

use glam::DVec3;
use step01_rays::{Ray, direction_colour};
use step05_phong::{Light, Material, Scene, light_terms, phong, visible_point};

/// The colour that `ray` would see without the test of n·l. Without the test, each light also makes
/// a highlight on surfaces that face away from the light. To get this extra highlight, we call
/// `light_terms` with −n instead of n. The reflected direction r is the same for −n. Where n·l is
/// negative, (−n)·l is positive, so the test lets the highlight through.
pub fn colour_without_highlight_gate(scene: &Scene<Material, Light>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let v = -ray.direction.normalize();
    let extra_highlights = scene
        .lights
        .iter()
        .map(|light| light_terms(point.p, -point.n, v, point.material(), light).specular);
    phong(&point, ray, scene.ambient_light, &scene.lights).sum() + extra_highlights.sum::<DVec3>()
}
