//! The scene of step 5 with shadows and mirrors: the whole of the lecture's
//! "Ray-Tracing Algorithm".

#[path = "../../step04_diffuse/examples/shadows.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod shadows;

use glam::DVec3;
use image::RgbImage;
pub use shadows::{OFFSET, hidden};
use step05_phong::{
    Camera, Light, Material, Ray, Scene, SurfacePoint, Terms, ambient,
    direction_colour, draw_and_save, light_terms, reflect, render, scene,
    visible_point,
};

/// The terms at `point` for this material, as `phong` computes them, but without
/// the lights that are hidden from the point.
pub fn shadowed_phong<M>(
    point: &SurfacePoint<M>,
    ray: &Ray,
    material: &Material,
    scene: &Scene<M, Light>,
    is_hidden: impl Fn(&Light) -> bool,
) -> Terms {
    let v = -ray.direction.normalize();
    let mut terms = Terms {
        ambient: ambient(&material.matte, scene.ambient_light),
        ..Terms::default()
    };
    for light in &scene.lights {
        if !is_hidden(light) {
            terms += light_terms(point.p, point.n, v, material, light);
        }
    }
    terms
}

/// A material that is partly a mirror.
#[derive(Debug)]
pub struct Mirror {
    /// Its own material, whose paint has the weight 1 − k.
    pub material: Material,
    /// k, how much of its colour is a mirror image, from 0 to 1.
    pub k: f64,
}

/// The scene of step 5, each object with its k.
pub fn mirrors() -> Scene<Mirror, Light> {
    let Scene { objects, ambient_light, lights } = scene();
    let k = |name| match name {
        "white sphere" => 0.85,
        "golden sphere" => 0.4,
        "ground" | "teal sphere" => 0.25,
        "red sphere" | "blue sphere" => 0.15,
        "salmon sphere" => 0.1,
        _ => 0.0,
    };
    let objects = objects.into_iter().map(|object| {
        let material = object.material;
        object.with_material(Mirror { material, k: k(object.name) })
    });
    Scene { objects: objects.collect(), ambient_light, lights }
}

/// The colour that `ray` sees after meeting at most `depth` mirrors. New rays start
/// `offset` above a surface.
pub fn colour(
    scene: &Scene<Mirror, Light>,
    ray: &Ray,
    depth: u32,
    offset: f64,
) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let is_hidden = |light: &Light| {
        hidden(&scene.objects, &point, light.point_light.position, offset)
    };
    let Mirror { material, k } = point.material();
    let terms = shadowed_phong(&point, ray, material, scene, is_hidden);
    if *k == 0.0 || depth == 0 {
        return terms.sum();
    }
    let mirrored = Ray {
        start: point.p + offset * point.n,
        direction: reflect(point.n, -ray.direction),
    };
    (1.0 - k) * (terms.ambient + terms.diffuse)
        + k * colour(scene, &mirrored, depth - 1, offset)
        + terms.specular
}

/// The picture: a ray may meet ten mirrors, one after the other.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = mirrors();
    render(camera, samples, |ray| colour(&scene, ray, 10, OFFSET))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
