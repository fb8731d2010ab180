//! The answers to the problems on paper, by the steps.

use super::Value::{self, Count, Fixed, Number};
use super::rays::pixel_ray;
use glam::DVec3;
use step01_rays::{AspectRatio, Camera};
use step02_sphere::{Ray, Roots, Sphere};
use step03_nearest::{Object, nearest};
use step04_diffuse::{Attenuation, Matte, PointLight, ambient, diffuse};
use step05_phong::{reflect, rgb8};

/// The value of this name.
pub fn value(name: &str, arguments: &[f64]) -> Option<Value> {
    Some(match (name, arguments) {
        ("problem-far-plane", []) => Fixed(2, 50.0 * pixel_ray([0, 0]).direction.length()),
        ("problem-vertical-view", []) => Fixed(1, vertical_view_degrees()),
        ("problem-rays", []) => Count({
            let v_res = AspectRatio { width: 2.39, height: 1.0 }.v_res(640);
            (640 * v_res * 3 * 3) as usize
        }),
        ("problem-touch", []) => {
            match sphere([0.0, 0.0, -5.0], 3.0).intersect(&ray([0.0; 3], [0.75, 0.0, -1.0])) {
                Roots::One(t) => Number(t),
                _ => return None,
            }
        }
        ("problem-inside", []) => Fixed(3, {
            let ray = ray([0.0; 3], [0.0, 0.0, -2.0]);
            sphere([0.0, 1.0, -2.0], 3.0).intersect(&ray).first_hit()?
        }),
        ("problem-nearest", []) => Number({
            let spheres = [
                sphere([0.0, 0.0, 3.0], 1.0),
                sphere([0.0, 0.0, -1.0], 4.0),
                sphere([0.0, 3.0, -10.0], 5.0),
            ];
            let objects = spheres.map(|sphere| Object { name: "", sphere, material: () });
            nearest(&objects, &ray([0.0; 3], [0.0, 0.0, -1.0]))?.t
        }),
        ("problem-hidden", []) => Number({
            // The ray that touches the front sphere, by its a = b² / (4c).
            let (front, axis) = (sphere([0.0, 0.0, -4.0], 1.0), ray([0.0; 3], [0.0, 0.0, -1.0]));
            let (_, b, c) = front.coefficients(&axis);
            let a = b * b / (4.0 * c);
            let (_, b, c) = sphere([0.0, 0.0, -18.0], 0.0).coefficients(&axis);
            (c - b * b / (4.0 * a)).sqrt()
        }),
        ("problem-sun", []) => Fixed(2, {
            let sun = lamp(DVec3::ZERO, 1.0, [1.0, 0.0, 0.0]);
            let [noon, evening] = [60.0, 10.0].map(|height: f64| {
                let (sin, cos) = height.to_radians().sin_cos();
                let l = DVec3::new(cos, sin, 0.0);
                diffuse(DVec3::Y, l, 1.0, &Matte::of(DVec3::ONE), &sun).x
            });
            noon / evening
        }),
        ("problem-attenuation", []) => Fixed(2, {
            let lamps = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            let left = lamps.map(|[a, b, c]| {
                let attenuation = Attenuation { a, b, c };
                attenuation.divisor(2.0) / attenuation.divisor(6.0)
            });
            100.0 * left.iter().sum::<f64>() / 3.0
        }),
        ("problem-byte", []) => Count({
            let matte = Matte::of(DVec3::splat(0.9));
            let position = DVec3::new(0.0, 3.0, 1.0);
            let light = lamp(position, 0.5, [0.5, 0.1, 0.01]);
            let (p, n) = (DVec3::new(0.0, 0.0, -3.0), DVec3::Z);
            let (l, d) = light.direction_from(p);
            let sum = ambient(&matte, DVec3::splat(0.2)) + diffuse(n, l, d, &matte, &light);
            rgb8(sum).0[0].into()
        }),
        ("problem-reflection", []) => Fixed(3, {
            let n = DVec3::new(2.0, 2.0, 1.0) / 3.0;
            reflect(n, DVec3::Z).dot(DVec3::new(0.6, 0.8, 0.0))
        }),
        ("problem-shininess", []) => Fixed(1, {
            let half_angle = |n: f64| 0.5_f64.powf(1.0 / n).acos();
            half_angle(1.0) / half_angle(256.0)
        }),
        ("problem-shadow-ray", []) => Number({
            let ray = ray([0.0; 3], [0.0, 8.0, 0.0]);
            sphere([0.6, 3.0, 0.0], 1.0).intersect(&ray).first_hit()?
        }),
        _ => return None,
    })
}

fn ray(start: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray { start: start.into(), direction: direction.into() }
}

fn sphere(centre: [f64; 3], radius: f64) -> Sphere {
    Sphere { centre: centre.into(), radius }
}

/// A white lamp.
fn lamp(position: DVec3, intensity: f64, [a, b, c]: [f64; 3]) -> PointLight {
    let attenuation = Attenuation { a, b, c };
    PointLight { position, diffuse: DVec3::splat(intensity), attenuation }
}

/// The angle between the highest and the lowest ray of a 16:9 view, 90° wide.
fn vertical_view_degrees() -> f64 {
    let camera = Camera::new(1921, 1081, 90_f64.to_radians());
    let [top, bottom] = [0.0, 1080.0].map(|j| camera.ray(960.0, j).direction);
    top.angle_between(bottom).to_degrees()
}
