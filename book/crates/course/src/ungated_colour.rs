//! Step 5 without its gate.

use glam::DVec3;
use step01_rays::{Ray, direction_colour};
use step05_phong::{Light, Material, Scene, light_terms, phong, visible_point};

/// The colour of a scene of step 5 without the test of n·l.
///
/// Each highlight is computed twice, for n and for −n. The vector r is the same for both, and one of
/// the two passes the test.
pub fn ungated_colour(scene: &Scene<Material, Light>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let v = -ray.direction.normalize();
    let behind = scene
        .lights
        .iter()
        .map(|light| light_terms(point.p, -point.n, v, point.material(), light).specular);
    phong(&point, ray, scene.ambient_light, &scene.lights).sum() + behind.sum::<DVec3>()
}
