//! The scene of step 5 with Blinn's highlights, computed from the vector halfway
//! between l and v.

use glam::DVec3;
use image::RgbImage;
use step05_phong::{
    Camera, Light, Material, Ray, Scene, Terms, ambient, diffuse, direction_colour,
    draw_and_save, render, scene, visible_point,
};

/// h, the unit vector halfway between the unit vectors `l` and `v`, which must not
/// be opposite: h = (l + v) / |l + v|.
pub fn halfway(l: DVec3, v: DVec3) -> DVec3 {
    (l + v).normalize()
}

/// The specular term, with the cosine of the angle between n and h:
/// I_s = R_s / (a + bd + cd²) · max(n·h, 0)⁴ⁿ · L_s.
///
/// If light and eye are on nearly the same side, the angle between h and n is half
/// the angle between v and r, so the exponent is four times the shininess.
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

/// The colour that `ray` sees: as in this step, except for the highlights.
fn colour(scene: &Scene<Material, Light>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let (n, material) = (point.n, point.material());
    let v = -ray.direction.normalize();
    let mut terms = Terms {
        ambient: ambient(&material.matte, scene.ambient_light),
        ..Terms::default()
    };
    for light in &scene.lights {
        let (l, d) = light.point_light.direction_from(point.p);
        terms.diffuse += diffuse(n, l, d, &material.matte, &light.point_light);
        if n.dot(l) > 0.0 {
            terms.specular += specular(n, halfway(l, v), d, material, light);
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
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
