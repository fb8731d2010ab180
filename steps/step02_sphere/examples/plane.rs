//! An infinite checkered plane under the sphere.

use glam::DVec3;
use image::RgbImage;
use step02_sphere::{
    Camera, Ray, SPHERE, Sphere, direction_colour, draw_and_save, render,
};

/// A plane, the points p with n·(p − q) = 0.
#[derive(Debug)]
pub struct Plane {
    /// q, any point on it.
    pub point: DVec3,
    /// n, perpendicular to it, of any length except 0.
    pub normal: DVec3,
}

impl Plane {
    /// The positive t at which `ray` meets the plane, t = n·(q − S) / n·V. Returns
    /// None if there is no such t.
    pub fn first_hit(&self, ray: &Ray) -> Option<f64> {
        let along = self.normal.dot(ray.direction);
        if along == 0.0 {
            return None;
        }
        let t = self.normal.dot(self.point - ray.start) / along;
        (t > 0.0).then_some(t)
    }
}

/// The ground, on which the sphere stands.
pub const GROUND: Plane =
    Plane { point: DVec3::new(0.0, -1.0, 0.0), normal: DVec3::Y };

/// The colour of the ground at the point `p`: squares of side 1, in two colours.
/// The sphere stands in the middle of one.
fn checker(p: DVec3) -> DVec3 {
    let square = p.x.round() + p.z.round();
    if square.rem_euclid(2.0) == 0.0 {
        DVec3::new(0.97, 0.94, 0.90)
    } else {
        DVec3::new(0.44, 0.47, 0.78)
    }
}

/// The colour that `ray` sees: the nearer of sphere and ground, or else the sky.
fn colour(sphere: &Sphere, ground: &Plane, ray: &Ray) -> DVec3 {
    let sphere = sphere.intersect(ray).first_hit();
    let ground = ground.first_hit(ray);
    match (sphere, ground) {
        (Some(t), _) if ground.is_none_or(|u| t < u) => {
            DVec3::new(0.91, 0.34, 0.28)
        }
        (_, Some(t)) => {
            // Far away, the squares are smaller than pixels, so fade to the sky.
            let far = ray.at(t).distance(ray.start) / 12.0;
            direction_colour(ray).lerp(checker(ray.at(t)), 1.0 / (1.0 + far * far))
        }
        _ => direction_colour(ray),
    }
}

/// The picture: the sphere of step 2 on an endless ground.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(&SPHERE, &GROUND, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
