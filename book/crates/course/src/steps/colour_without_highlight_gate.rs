//! Step 5 without its test of n·l. A chapter shows what the picture would look like.

use glam::DVec3;
use step01_rays::{Ray, direction_colour};
use step05_phong::{Light, Material, Scene, light_terms, phong, visible_point};

/// The colour that `ray` would see without the test of n·l. Without the test, each light also makes
/// a highlight on surfaces that face away from the light. We compute this extra highlight by
/// passing −n instead of n: both give the same r, and −n passes the test where n·l is negative.
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
