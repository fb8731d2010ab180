//! The scene of step 5 with Blinn's highlights, from the vector halfway between l
//! and v.

use glam::DVec3;
use image::RgbImage;
use step05_phong::{
    Camera, Light, Material, Ray, Scene, direction_colour, phong, render, run,
    scene, visible_point,
};

/// h, the unit vector halfway between the unit vectors `l` and `v`, which are not
/// opposite: h = (l + v) / |l + v|.
pub fn halfway(l: DVec3, v: DVec3) -> DVec3 {
    (l + v).normalize()
}

/// The specular term with the cosine between n and h:
/// I_s = R_s / (a + bd + cd²) · max(n·h, 0)⁴ⁿ · L_s.
///
/// Where light and eye are on nearly the same side, h is half as far from n as v is
/// from r, so the exponent is four times the shininess.
pub fn specular(
    n: DVec3,
    h: DVec3,
    d: f64,
    material: &Material,
    light: &Light,
) -> DVec3 {
    material.specular / light.point_light.attenuation.divisor(d)
        * n.dot(h).max(0.0).powi(4 * material.shininess)
        * light.specular
}

/// The colour that `ray` sees: this step's, but for the highlights.
fn colour(scene: &Scene<Material, Light>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let mut terms = phong(&point, ray, scene.ambient_light, &scene.lights);
    terms.specular = DVec3::ZERO;
    for light in &scene.lights {
        let (l, d) = light.point_light.direction_from(point.p);
        if 0.0 < point.n.dot(l) {
            let h = halfway(l, -ray.direction.normalize());
            terms.specular += specular(point.n, h, d, point.material, light);
        }
    }
    terms.sum()
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
