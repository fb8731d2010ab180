use super::numbers::numbers;
use super::{object_names, pixel};
use crate::live::{Handle, Knob, Live, Numbers, Sight, named, number, vector};
use glam::{DVec2, DVec3};
use step04_diffuse::{
    COOL, PointLight, Ray, Scene, Surface, SurfacePoint, WARM, ambient, colour,
    diffuse, render, visible_point,
};

/// What the lights of the scene are called, in their order.
pub const LAMPS: [&str; 2] = ["warm", "cool"];

/// The scene with its lamps where these values have them.
fn scene(values: &[f64]) -> Scene<Surface, PointLight> {
    let mut scene = step04_diffuse::scene();
    for (light, first) in scene.lights.iter_mut().zip([3, 6]) {
        light.position = DVec3::from_slice(&values[first..]);
    }
    scene
}

/// A lamp whose x, y and z are three values; it stays as deep as it is.
fn handle(words: &str, x: usize) -> Handle {
    Handle::new(
        words,
        [x, x + 1],
        |handle, values| {
            let position = DVec3::from_slice(&values[handle.knobs[0]..]);
            pixel::place(&crate::camera(), position)
        },
        |handle, values, to| {
            let inside = to.clamp(DVec2::splat(24.0), pixel::SIZE - 24.0);
            pixel::point(&crate::camera(), inside, values[handle.knobs[1] + 1])
        },
    )
}

/// From the point that a ray sees to the terms of its light.
fn shading(scene: &Scene<Surface, PointLight>, ray: &Ray) -> Option<Numbers> {
    let point = visible_point(&scene.objects, ray)?;
    let mut numbers = place(&point);
    let mut sum = DVec3::ZERO;
    for (light, lamp) in scene.lights.iter().zip(LAMPS) {
        numbers.extend(lit(&point, point.material, light, lamp));
        let (l, d) = light.direction_from(point.p);
        sum += diffuse(point.n, l, d, point.material, light);
    }
    let ambient = ambient(point.material, scene.ambient_light);
    numbers.extend(named([("ambient", vector(ambient)), ("diffuse", vector(sum))]));
    Some(numbers)
}

/// Where a point is, and which way its surface faces.
pub fn place<M>(point: &SurfacePoint<M>) -> Numbers {
    named([("p", vector(point.p)), ("n", vector(point.n))])
}

/// A lamp as it is seen from a point, and the light that it scatters there.
pub fn lit<M>(
    point: &SurfacePoint<M>,
    surface: &Surface,
    light: &PointLight,
    lamp: &str,
) -> Numbers {
    let (l, d) = light.direction_from(point.p);
    let diffuse = diffuse(point.n, l, d, surface, light);
    of_lamp(
        lamp,
        [
            ("l", vector(l)),
            ("d", number(d)),
            ("divisor", number(light.attenuation.at(d))),
            ("nl", number(point.n.dot(l))),
            ("diffuse", vector(diffuse)),
        ],
    )
}

/// The numbers of a lamp of this name.
pub fn of_lamp<const N: usize>(
    lamp: &str,
    numbers: [(&str, String); N],
) -> Numbers {
    numbers.map(|(name, text)| (format!("{name} {lamp}"), text)).into()
}

/// The picture of step 4: its lamps to move, and a pixel to ask.
pub fn picture() -> Live {
    let mut knobs = pixel::knobs(470.0, 120.0);
    let (warm, cool) = (WARM.position, COOL.position);
    let positions = [
        (["x", "of the warm light", ""], warm.x, [-8.0, 8.0]),
        (["y", "of the warm light", ""], warm.y, [-1.0, 8.0]),
        (["z", "of the warm light", ""], warm.z, [-12.0, 2.0]),
        // Wherever these bring it, the cool light is in the picture.
        (["x", "of the cool light", ""], cool.x, [-6.0, 6.0]),
        (["y", "of the cool light", ""], cool.y, [-3.4, 3.4]),
        (["z", "of the cool light", ""], cool.z, [-16.0, -11.0]),
    ];
    knobs.extend(
        positions.map(|(words, value, range)| Knob::new(words, value, range, 10.0)),
    );
    let lamps = [handle("the warm light", 3), handle("the cool light", 6)];
    Live {
        knobs,
        handles: [pixel::cross()].into_iter().chain(lamps).collect(),
        numbers: |values| {
            let scene = scene(values);
            let shading = |ray: &Ray| shading(&scene, ray);
            let colour = |ray: &Ray| colour(&scene, ray);
            numbers(values, &scene.objects, &object_names(), shading, colour)
        },
        ..Live::new("step04_diffuse", |values| {
            let (camera, scene) = (pixel::camera(values), scene(values));
            Sight::Picture(render(&camera, 1, |ray| colour(&scene, ray)))
        })
    }
}
