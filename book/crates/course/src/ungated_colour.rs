use glam::DVec3;
use step01_rays::{Ray, direction_colour};
use step05_phong::{Light, Material, Scene, SurfacePoint, phong, visible_point};

/// The colour of a scene of step 5 without the test of n·l: with each highlight twice, before and
/// behind the surface, as r is the same for n and −n and one of the two passes the gate.
pub fn ungated_colour(scene: &Scene<Material, Light>, ray: &Ray) -> DVec3 {
    let Some(outside) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let inside = SurfacePoint { n: -outside.n, ..outside };
    let [outside, inside] =
        [outside, inside].map(|point| phong(&point, ray, scene.ambient_light, &scene.lights));
    outside.sum() + inside.specular
}
