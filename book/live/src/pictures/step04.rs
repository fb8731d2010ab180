use super::step03::named;
use super::{asked, picture};
use crate::live::{Live, Numbers, number, vector};
use glam::DVec3;
use step04_diffuse::{
    Point, PointLight, Scene, Surface, ambient, colour, diffuse, nearest, scene,
    seen,
};

/// The picture of step 4, with a pixel to ask.
pub const STEP04: Live = Live {
    name: "step04_diffuse",
    knobs: &[asked::COLUMN, asked::ROW, asked::COLUMNS],
    handles: &[asked::PIXEL],
    is_allowed: |values| asked::camera(values[2]).is_ok(),
    sight: |values| {
        let scene = scene();
        picture(&asked::seen(values[2]), |ray| colour(&scene, ray))
    },
    numbers: |values| {
        let (scene, ray) = (scene(), asked::ray(values));
        let spheres = scene.objects.iter().map(|object| &object.sphere);
        let mut numbers = asked::from_pixel(values, spheres);
        let hit = nearest(&scene.objects, &ray);
        numbers.extend(asked::met(hit.map(|hit| named(&scene.objects, hit)), &ray));
        if let Some(point) = seen(&scene.objects, &ray) {
            numbers.extend(shading(&scene, &point));
        }
        let sum = colour(&scene, &ray);
        numbers.push(("sum".into(), vector(&sum.to_array())));
        numbers.push(asked::bytes(&ray, |ray| colour(&scene, ray)));
        numbers
    },
};

/// What the lights of the scene are called, in their order.
pub const LAMPS: [&str; 2] = ["warm", "cool"];

/// From the point that a ray sees to the terms of its light.
fn shading(scene: &Scene<Surface, PointLight>, point: &Point<Surface>) -> Numbers {
    let mut all = place(point);
    let mut sum = DVec3::ZERO;
    for (light, lamp) in scene.lights.iter().zip(LAMPS) {
        all.extend(lit(point, point.material, light, lamp));
        let (l, d) = light.seen_from(point.p);
        sum += diffuse(point.n, l, d, point.material, light);
    }
    let ambient = ambient(point.material.ambient, scene.ambient_light);
    all.push(("ambient".into(), vector(&ambient.to_array())));
    all.push(("diffuse".into(), vector(&sum.to_array())));
    all
}

/// Where a point is, and which way its surface faces.
pub fn place<M>(point: &Point<M>) -> Numbers {
    vec![
        ("p".into(), vector(&point.p.to_array())),
        ("n".into(), vector(&point.n.to_array())),
    ]
}

/// A lamp as it is seen from a point, and the light that it scatters there.
pub fn lit<M>(
    point: &Point<M>,
    surface: &Surface,
    light: &PointLight,
    lamp: &str,
) -> Numbers {
    let (l, d) = light.seen_from(point.p);
    let numbers = [
        ("l", vector(&l.to_array())),
        ("d", number(d)),
        ("divisor", number(light.attenuation.at(d))),
        ("nl", number(point.n.dot(l))),
        ("diffuse", vector(&diffuse(point.n, l, d, surface, light).to_array())),
    ];
    numbers.map(|(name, text)| (format!("{name} {lamp}"), text)).into()
}
