//! The scene of step 4 at night, in the light of four spotlights.

use glam::DVec3;
use image::RgbImage;
use step04_diffuse::{
    Attenuation, Camera, Matte, PointLight, Ray, Scene, ambient, diffuse_at,
    direction_colour, draw_and_save, render, scene, visible_point,
};

/// A point light that shines only into a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLight {
    /// Its position, L_d and attenuation.
    pub point_light: PointLight,
    /// e, the unit vector along the axis of the cone, away from the light.
    pub axis: DVec3,
    /// The angle from the axis within which the light has its full strength, in
    /// radians.
    pub inner: f64,
    /// The angle beyond which there is no light, greater than `inner`.
    pub outer: f64,
}

impl SpotLight {
    /// The fraction of its light that goes along −l: 1 within `inner`, 0 beyond
    /// `outer`.
    pub fn cone(&self, l: DVec3) -> f64 {
        let (inner, outer) = (self.inner.cos(), self.outer.cos());
        let x = ((self.axis.dot(-l) - outer) / (inner - outer)).clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    }
}

/// How bright the night is, compared with the day of step 4.
const NIGHT: f64 = 0.4;

/// The scene of step 4 at night.
pub fn night() -> Scene<Matte, SpotLight> {
    let Scene { objects, ambient_light, .. } = scene();
    let lights = vec![
        spot([-1.5, 4.5, -3.0], [-0.5, -1.4, -6.4], [1.0, 0.7, 0.4]),
        spot([-5.0, 4.0, -5.5], [-3.2, -1.0, -8.6], [0.3, 0.6, 1.0]),
        spot([3.0, 4.5, -5.0], [1.8, -0.6, -9.0], [0.9, 0.35, 0.6]),
        spot([3.5, 4.0, -3.0], [3.2, -1.5, -6.2], [0.4, 0.9, 0.8]),
    ];
    Scene { objects, ambient_light: NIGHT * ambient_light, lights }
}

fn spot(position: [f64; 3], target: [f64; 3], diffuse: [f64; 3]) -> SpotLight {
    let [position, target, diffuse] = [position, target, diffuse].map(DVec3::from);
    let attenuation = Attenuation { a: 0.5, b: 0.0, c: 0.01 };
    let point_light = PointLight { position, diffuse, attenuation };
    let (inner, outer) = (8_f64.to_radians(), 20_f64.to_radians());
    SpotLight { point_light, axis: (target - position).normalize(), inner, outer }
}

/// The colour that `ray` sees.
fn colour(scene: &Scene<Matte, SpotLight>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return NIGHT * direction_colour(ray);
    };
    let (p, n, material) = (point.p, point.n, point.material());
    let mut intensity = ambient(material, scene.ambient_light);
    for light in &scene.lights {
        let (l, _) = light.point_light.direction_from(p);
        intensity += light.cone(l) * diffuse_at(p, n, material, &light.point_light);
    }
    intensity
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = night();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
