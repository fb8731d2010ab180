//! Shapes of three kinds in one list: balls and an egg, on an endless floor.

use glam::DVec3;
use image::RgbImage;
use step02_sphere::{
    Camera, Ray, Sphere, direction_colour, draw_and_save, quadratic, render,
};

/// A shape of any kind that this program knows.
#[derive(Debug)]
pub enum Shape {
    /// A ball.
    Sphere(Sphere),
    /// An endless floor at this height y.
    Floor(f64),
    /// A ball of radius 1, stretched and then moved.
    Egg {
        /// Where its centre is.
        centre: DVec3,
        /// How much it is stretched along each axis.
        radii: DVec3,
    },
}

impl Shape {
    /// The smallest t above 0 at which `ray` meets the shape, if there is one.
    pub fn first_hit(&self, ray: &Ray) -> Option<f64> {
        match self {
            Shape::Sphere(sphere) => sphere.intersect(ray).first_hit(),
            Shape::Floor(y) => {
                let t = (y - ray.start.y) / ray.direction.y;
                // A ray along the floor would give an infinite t.
                (0.0 < t && t < f64::INFINITY).then_some(t)
            }
            Shape::Egg { centre, radii } => {
                // Squeeze the world until the egg is a ball of radius 1.
                let (s, v) = ((ray.start - centre) / radii, ray.direction / radii);
                quadratic(v.dot(v), 2.0 * s.dot(v), s.dot(s) - 1.0).first_hit()
            }
        }
    }

    /// n, the unit normal at a point `p` on the shape.
    pub fn normal(&self, p: DVec3) -> DVec3 {
        match self {
            Shape::Sphere(sphere) => (p - sphere.centre) / sphere.radius,
            Shape::Floor(_) => DVec3::Y,
            Shape::Egg { centre, radii } => {
                ((p - centre) / (radii * radii)).normalize()
            }
        }
    }
}

/// The shapes in the picture, and their colours.
fn scene() -> [(Shape, DVec3); 4] {
    let ball = |centre, radius| Shape::Sphere(Sphere::new(centre, radius));
    let egg = Shape::Egg {
        centre: DVec3::new(1.1, 0.3, -5.4),
        radii: DVec3::new(0.9, 1.3, 0.9),
    };
    [
        (Shape::Floor(-1.0), DVec3::new(0.80, 0.76, 0.82)),
        (ball([-1.3, 0.2, -6.4], 1.2), DVec3::new(0.91, 0.34, 0.28)),
        (ball([-0.25, -0.6, -4.6], 0.4), DVec3::new(0.16, 0.60, 0.60)),
        (egg, DVec3::new(0.99, 0.87, 0.62)),
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
