//! Quadrics: an ellipsoid, a hyperboloid and a cone from one equation.

use glam::{DMat3, DVec3};
use image::RgbImage;
use step02_sphere::{
    Camera, Ray, Roots, direction_colour, draw_and_save, quadratic, render,
};

/// A quadric, the points p with p·Qp + 2u·p + w = 0.
#[derive(Clone, Copy, Debug)]
pub struct Quadric {
    /// Q, symmetric: the coefficients of x², y² and z², and half of the
    /// coefficients of xy, xz and yz.
    pub squares: DMat3,
    /// u, half of the coefficients of x, y and z.
    pub linear: DVec3,
    /// w, the constant.
    pub constant: f64,
}

impl Quadric {
    /// The quadric p·Qp + w = 0, moved from the origin to `centre`.
    pub fn around(centre: DVec3, q: DMat3, w: f64) -> Self {
        let linear = -(q * centre);
        Self { squares: q, linear, constant: centre.dot(q * centre) + w }
    }

    /// The a, b and c of at² + bt + c = 0. Its roots are the t at which `ray` meets
    /// the quadric.
    pub fn coefficients(&self, ray: &Ray) -> (f64, f64, f64) {
        let Self { squares: q, linear: u, constant: w } = *self;
        let (s, v) = (ray.start, ray.direction);
        let a = v.dot(q * v);
        let b = 2.0 * (v.dot(q * s) + u.dot(v));
        let c = s.dot(q * s) + 2.0 * u.dot(s) + w;
        (a, b, c)
    }

    /// Every t at which `ray` meets the quadric, the smaller one first.
    pub fn intersect(&self, ray: &Ray) -> Roots {
        match self.coefficients(ray) {
            (0.0, 0.0, _) => Roots::Zero,
            (0.0, b, c) => Roots::One(-c / b),
            (a, b, c) if a < 0.0 => quadratic(-a, -b, -c),
            (a, b, c) => quadratic(a, b, c),
        }
    }

    /// The first hit at a height y between `bottom` and `top`.
    pub fn first_between(&self, ray: &Ray, bottom: f64, top: f64) -> Option<f64> {
        let between = |t| (bottom..=top).contains(&ray.at(t).y);
        self.intersect(ray).into_iter().find(|&t| t > 0.0 && between(t))
    }

    /// The gradient of the equation's left side at `p`. It points outwards.
    pub fn gradient(&self, p: DVec3) -> DVec3 {
        2.0 * (self.squares * p + self.linear)
    }
}

/// The three quadrics in the picture, and their colours.
pub fn scene() -> [(Quadric, DVec3); 3] {
    let tilt = DMat3::from_rotation_z(0.6);
    let long = DMat3::from_diagonal(DVec3::new(0.6, 2.0, 2.0));
    let waist = DMat3::from_diagonal(DVec3::new(3.0, -1.4, 3.0));
    let cone = DMat3::from_diagonal(DVec3::new(1.4, -1.0, 1.4));
    let at = |x: f64, q: DMat3, w: f64| Quadric::around(x * DVec3::X, q, w);
    [
        (
            at(-2.5, tilt * long * tilt.transpose(), -1.0),
            DVec3::new(0.91, 0.34, 0.28),
        ),
        (at(0.0, waist, -1.0), DVec3::new(0.99, 0.76, 0.32)),
        (at(2.4, cone, 0.0), DVec3::new(0.16, 0.60, 0.60)),
    ]
}

/// The colour that `ray` sees: rings of two shades, darker on the inside.
fn colour(scene: &[(Quadric, DVec3)], ray: &Ray) -> DVec3 {
    let mut nearest = (f64::INFINITY, direction_colour(ray));
    for (quadric, colour) in scene {
        let Some(t) = quadric.first_between(ray, -1.0, 1.0) else { continue };
        if t < nearest.0 {
            let p = ray.at(t);
            let ring = if p.y.rem_euclid(0.25) < 0.125 { 1.0 } else { 0.85 };
            let inside = quadric.gradient(p).dot(ray.direction) > 0.0;
            nearest = (t, colour * ring * if inside { 0.55 } else { 1.0 });
        }
    }
    nearest.1
}

/// The picture: an ellipsoid, a hyperboloid and a double cone, seen from above.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let down = DMat3::from_rotation_x(-0.5);
    let camera = Camera {
        centre: 6.5 * down.z_axis,
        matrix: down * camera.matrix,
        ..*camera
    };
    let scene = scene();
    render(&camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
