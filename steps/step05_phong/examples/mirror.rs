//! The scene of step 5 with shadows and mirrors: the whole of the lecture's
//! "Ray-Tracing Algorithm".

#[path = "../../step04_diffuse/examples/shadows.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod shadows;

use glam::DVec3;
use image::RgbImage;
pub use shadows::{OFFSET, hidden};
use step05_phong::{
    Camera, Light, Material, Phong, Ray, Scene, SurfacePoint, direction_colour,
    phong, reflect, render, run, scene, visible_point,
};

/// The terms at `point`, without the light of the lamps that are hidden from it.
pub fn shadowed_phong(
    point: &SurfacePoint<Material>,
    ray: &Ray,
    ambient_light: DVec3,
    lights: &[Light],
    is_hidden: impl Fn(&Light) -> bool,
) -> Phong {
    let mut terms = phong(point, ray, ambient_light, &[]);
    for light in lights {
        if !is_hidden(light) {
            let added = phong(point, ray, DVec3::ZERO, &[*light]);
            terms.diffuse += added.diffuse;
            terms.specular += added.specular;
        }
    }
    terms
}

/// A material that is partly a mirror.
pub struct Mirror {
    /// Its own material, whose paint counts for 1 − k.
    pub material: Material,
    /// k, how much of its colour is a mirror image, 0 to 1.
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

/// The colour that `ray` sees by way of at most `depth` mirrors. New rays start
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
    let SurfacePoint { p, n, material: Mirror { material, k } } = point;
    let point = SurfacePoint { p, n, material };
    let (l_a, lights) = (scene.ambient_light, &scene.lights);
    let terms = shadowed_phong(&point, ray, l_a, lights, is_hidden);
    if 0.0 < *k && 0 < depth {
        let direction = reflect(n, -ray.direction);
        let mirrored = Ray { start: p + offset * n, direction };
        return (1.0 - k) * (terms.ambient + terms.diffuse)
            + k * colour(scene, &mirrored, depth - 1, offset)
            + terms.specular;
    }
    terms.sum()
}

/// The picture: a ray may meet ten mirrors, one after the other.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = mirrors();
    render(camera, samples, |ray| colour(&scene, ray, 10, OFFSET))
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
