//! The scene of step 5 with shadows and mirrors: the whole of the lecture's
//! "Ray-Tracing Algorithm".

use glam::DVec3;
use image::RgbImage;
use step05_phong::{
    Camera, Light, Material, Object, Ray, Scene, SurfacePoint, direction_colour,
    nearest, phong, reflect, render, run, scene, visible_point,
};

/// How far above a surface a ray starts, so that it does not meet that surface again.
const OFFSET: f64 = 1e-9;

/// Says whether one of the `objects` stands between `point` and a light at `q`.
pub fn hidden<M>(objects: &[Object<M>], point: &SurfacePoint<M>, q: DVec3) -> bool {
    let start = point.p + OFFSET * point.n;
    let to_light = Ray { start, direction: q - start };
    nearest(objects, &to_light).is_some_and(|hit| hit.t < 1.0)
}

/// A material that is a mirror in part.
pub struct Mirror {
    /// What it is for the rest.
    pub material: Material,
    /// k, the part of its colour that it mirrors, 0 to 1.
    pub k: f64,
}

/// The scene of step 5, each object with its k.
pub fn mirrors() -> Scene<Mirror, Light> {
    let Scene { objects, ambient_light, lights } = scene();
    // Red, ground, golden, blue, green, teal, white, salmon and cream.
    let k = [0.15, 0.25, 0.4, 0.15, 0.0, 0.25, 0.85, 0.1, 0.0];
    let mirror = |(Object { sphere, material }, k)| {
        let material = Mirror { material, k };
        Object { sphere, material }
    };
    let objects = objects.into_iter().zip(k).map(mirror).collect();
    Scene { objects, ambient_light, lights }
}

/// The colour that `ray` sees by way of at most `depth` mirrors.
pub fn colour(scene: &Scene<Mirror, Light>, ray: &Ray, depth: u32) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let mut lights = scene.lights.clone();
    lights.retain(|light| {
        !hidden(&scene.objects, &point, light.point_light.position)
    });
    let SurfacePoint { p, n, material: Mirror { material, k } } = point;
    let terms =
        phong(&SurfacePoint { p, n, material }, ray, scene.ambient_light, &lights);
    if 0.0 < *k && 0 < depth {
        let direction = reflect(n, -ray.direction);
        let mirrored = Ray { start: p + OFFSET * n, direction };
        return (1.0 - k) * (terms.ambient + terms.diffuse)
            + k * colour(scene, &mirrored, depth - 1)
            + terms.specular;
    }
    terms.sum()
}

/// The picture: a ray may meet ten mirrors, one after the other.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = mirrors();
    render(camera, samples, |ray| colour(&scene, ray, 10))
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
