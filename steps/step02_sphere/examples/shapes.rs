//! Shapes of three kinds in one list: balls and an egg, on an endless floor.

#[path = "plane.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod plane;
#[path = "quadric.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod quadric;

use glam::{DMat3, DVec3};
use image::RgbImage;
use plane::{GROUND, Plane};
use quadric::Quadric;
use step02_sphere::{Camera, Ray, Sphere, direction_colour, draw_and_save, render};

/// A shape of any kind that this program knows.
pub enum Shape {
    /// A ball.
    Sphere(Sphere),
    /// An infinite plane.
    Plane(Plane),
    /// A whole quadric, such as an egg.
    Quadric(Quadric),
}

impl Shape {
    /// The smallest t above 0 at which `ray` meets the shape, if there is one.
    pub fn first_hit(&self, ray: &Ray) -> Option<f64> {
        match self {
            Shape::Sphere(sphere) => sphere.intersect(ray).first_hit(),
            Shape::Plane(plane) => plane.first_hit(ray),
            Shape::Quadric(quadric) => quadric.intersect(ray).first_hit(),
        }
    }

    /// n, the unit normal at a point `p` on the shape.
    pub fn normal(&self, p: DVec3) -> DVec3 {
        match self {
            Shape::Sphere(sphere) => (p - sphere.centre) / sphere.radius,
            Shape::Plane(plane) => plane.normal.normalize(),
            Shape::Quadric(quadric) => quadric.gradient(p).normalize(),
        }
    }
}

/// The shapes in the picture, and their colours.
fn scene() -> [(Shape, DVec3); 4] {
    let ball = |centre, radius| Shape::Sphere(Sphere::new(centre, radius));
    // 0.9 wide to each side, 1.3 up and down.
    let egg = DMat3::from_diagonal(DVec3::new(0.9, 1.3, 0.9).powf(-2.0));
    let egg = Quadric::around(DVec3::new(1.1, 0.3, -5.4), egg, -1.0);
    [
        (Shape::Plane(GROUND), DVec3::new(0.80, 0.76, 0.82)),
        (ball([-1.3, 0.2, -6.4], 1.2), DVec3::new(0.91, 0.34, 0.28)),
        (ball([-0.25, -0.6, -4.6], 0.4), DVec3::new(0.16, 0.60, 0.60)),
        (Shape::Quadric(egg), DVec3::new(0.99, 0.87, 0.62)),
    ]
}

/// The colour that `ray` sees: that of the nearest shape, in the light of a sun, or
/// else that of the sky.
fn colour(scene: &[(Shape, DVec3)], ray: &Ray) -> DVec3 {
    let mut nearest: Option<(f64, DVec3)> = None;
    for (shape, colour) in scene {
        if let Some(t) = shape.first_hit(ray)
            && nearest.is_none_or(|(best, _)| t < best)
        {
            let l = DVec3::new(-1.0, 1.5, 1.0).normalize();
            let cosine = shape.normal(ray.at(t)).dot(l).max(0.0);
            nearest = Some((t, (0.3 + 0.7 * cosine) * colour));
        }
    }
    nearest.map_or(direction_colour(ray), |(_, colour)| colour)
}

/// The picture: two balls and an egg on a floor.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
