//! Step 5 without the test of n·l, which a chapter shows.

use glam::DVec3;
use step01_rays::{Ray, direction_colour};
use step05_phong::{Light, Material, Scene, light_terms, phong, visible_point};

/// The colour that `ray` would see without the test of n·l. Then each light also makes a highlight
/// behind the surface. That highlight is the one of −n, for which r is the same, and which the test
/// lets through exactly where it stops that of n.
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
