//! The scene of step 4 with a moon, and with shadows: a light only counts if
//! nothing is in its way.

use glam::DVec3;
use image::RgbImage;
use step04_diffuse::{
    Camera, Matte, Object, PointLight, Ray, Scene, Sphere, SurfacePoint, ambient,
    diffuse_at, direction_colour, draw_and_save, nearest, render, scene,
    visible_point,
};

/// How far above the surface a ray to a light starts.
///
/// If it started at `p` itself, whose last digits are rounded, it might hit the
/// surface that `p` lies on.
pub const OFFSET: f64 = 1e-9;

/// Whether one of the `objects` is between `point` and a light at `q`.
///
/// The ray starts `offset` above the surface. V leads from the start to the light,
/// so the light is at t = 1.
pub fn hidden<M>(
    objects: &[Object<M>],
    point: &SurfacePoint<M>,
    q: DVec3,
    offset: f64,
) -> bool {
    let start = point.p + offset * point.n;
    let to_light = Ray { start, direction: q - start };
    nearest(objects, &to_light).is_some_and(|hit| hit.t < 1.0)
}

/// The colour that `ray` sees.
fn colour(scene: &Scene<Matte, PointLight>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let mut intensity = ambient(point.material(), scene.ambient_light);
    for light in &scene.lights {
        if !hidden(&scene.objects, &point, light.position, OFFSET) {
            intensity += diffuse_at(point.p, point.n, point.material(), light);
        }
    }
    intensity
}

/// The picture: the colour of every ray. There is a moon behind the cool light.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let mut scene = scene();
    let sphere = Sphere::new([6.4, 3.4, -15.5], 1.3);
    let material = Matte::of(DVec3::new(0.76, 0.66, 0.5));
    scene.objects.push(Object { name: "moon", sphere, material });
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
