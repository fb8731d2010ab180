//! The answers to the problems on paper, by the steps.

use super::Values;
use super::rays::{first_hit, half_angle, pixel_ray};
use figures::{format_count, format_fixed, format_number};
use glam::DVec3;
use step01_rays::{AspectRatio, Camera};
use step02_sphere::{Ray, Sphere};
use step03_nearest::{Object, nearest};
use step04_diffuse::{Attenuation, Matte, PointLight, ambient, diffuse};
use step05_phong::{reflect, rgb8};

pub const VALUES: &Values = &[
    ("problem-far-plane", || format_fixed(50.0 * pixel_ray([0, 0]).direction.length(), 2)),
    ("problem-vertical-view", || format_fixed(vertical_view_degrees(), 1)),
    ("problem-rays", || {
        format_count((640 * AspectRatio { width: 2.39, height: 1.0 }.v_res(640) * 3 * 3) as usize)
    }),
    ("problem-touch", || {
        format_number(first_hit(&sphere([0.0, 0.0, -5.0], 3.0), &ray([0.0; 3], [0.75, 0.0, -1.0])))
    }),
    ("problem-inside", || {
        format_fixed(first_hit(&sphere([0.0, 1.0, -2.0], 3.0), &ray([0.0; 3], [0.0, 0.0, -2.0])), 3)
    }),
    ("problem-nearest", || {
        let centres_and_radii =
            [([0.0, 0.0, 3.0], 1.0), ([0.0, 0.0, -1.0], 4.0), ([0.0, 3.0, -10.0], 5.0)];
        let objects = centres_and_radii.map(|(centre, radius)| Object {
            name: "",
            sphere: sphere(centre, radius),
            material: (),
        });
        format_number(nearest(&objects, &ray([0.0; 3], [0.0, 0.0, -1.0])).expect("a hit").t)
    }),
    ("problem-hidden", || {
        // The ray that touches the front sphere, by its a = b² / (4c).
        let (front, axis) = (sphere([0.0, 0.0, -4.0], 1.0), ray([0.0; 3], [0.0, 0.0, -1.0]));
        let (_, b, c) = front.coefficients(&axis);
        let a = b * b / (4.0 * c);
        let (_, b, c) = sphere([0.0, 0.0, -18.0], 0.0).coefficients(&axis);
        format_number((c - b * b / (4.0 * a)).sqrt())
    }),
    ("problem-sun", || format_fixed(sunlight(60.0) / sunlight(10.0), 2)),
    ("problem-attenuation", || {
        let lamps = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let shares = lamps.map(|[a, b, c]| {
            let attenuation = Attenuation { a, b, c };
            attenuation.divisor(2.0) / attenuation.divisor(6.0)
        });
        format_fixed(100.0 * shares.iter().sum::<f64>() / 3.0, 2)
    }),
    ("problem-byte", || {
        let matte = Matte::of(DVec3::splat(0.9));
        let light = lamp(DVec3::new(0.0, 3.0, 1.0), 0.5, [0.5, 0.1, 0.01]);
        let (l, d) = light.direction_from(DVec3::new(0.0, 0.0, -3.0));
        let sum = ambient(&matte, DVec3::splat(0.2)) + diffuse(DVec3::Z, l, d, &matte, &light);
        format_count(rgb8(sum).0[0].into())
    }),
    ("problem-reflection", || {
        let r = reflect(DVec3::new(2.0, 2.0, 1.0) / 3.0, DVec3::Z);
        format_fixed(r.dot(DVec3::new(0.6, 0.8, 0.0)), 3)
    }),
    ("problem-shininess", || format_fixed(half_angle(1.0) / half_angle(256.0), 1)),
    ("problem-shadow-ray", || {
        format_number(first_hit(&sphere([0.6, 3.0, 0.0], 1.0), &ray([0.0; 3], [0.0, 8.0, 0.0])))
    }),
];

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

/// The diffuse light on the ground when the sun is so many degrees above the horizon.
fn sunlight(height: f64) -> f64 {
    let (sin, cos) = height.to_radians().sin_cos();
    let sun = lamp(DVec3::ZERO, 1.0, [1.0, 0.0, 0.0]);
    diffuse(DVec3::Y, DVec3::new(cos, sin, 0.0), 1.0, &Matte::of(DVec3::ONE), &sun).x
}

/// The angle between the highest and the lowest ray of a 16:9 view, 90° wide.
fn vertical_view_degrees() -> f64 {
    let camera = Camera::new(1921, 1081, 90_f64.to_radians());
    let [top, bottom] = [0.0, 1080.0].map(|j| camera.ray(960.0, j).direction);
    top.angle_between(bottom).to_degrees()
}
