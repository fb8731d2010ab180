use super::{asked, chain, picture};
use crate::live::{Handle, Knob, Live, Numbers, number, vector};
use glam::{DVec2, DVec3};
use step04_diffuse::{
    COOL, PointLight, Ray, Scene, Surface, SurfacePoint, WARM, ambient, colour,
    diffuse, visible_point,
};

/// The picture of step 4: its lamps to move, and a pixel to ask.
pub const STEP04: Live = Live {
    name: "step04_diffuse",
    knobs: &[
        asked::COLUMN,
        asked::ROW,
        asked::COLUMNS,
        lamp(["x", "of the warm light", ""], WARM.position.x, [-8.0, 8.0]),
        lamp(["y", "of the warm light", ""], WARM.position.y, [-1.0, 8.0]),
        lamp(["z", "of the warm light", ""], WARM.position.z, [-12.0, 2.0]),
        // Wherever these bring it, the cool light is in the picture.
        lamp(["x", "of the cool light", ""], COOL.position.x, [-6.0, 6.0]),
        lamp(["y", "of the cool light", ""], COOL.position.y, [-3.4, 3.4]),
        lamp(["z", "of the cool light", ""], COOL.position.z, [-16.0, -11.0]),
    ],
    handles: &[
        asked::PIXEL,
        Handle::new("the warm light", [3, 4], place_of::<3>, drag::<3>),
        Handle::new("the cool light", [6, 7], place_of::<6>, drag::<6>),
    ],
    is_allowed: |values| asked::camera(values[2]).is_ok(),
    sight: |values| {
        let scene = scene(values);
        picture(&asked::seen(values[2]), |ray| colour(&scene, ray))
    },
    numbers: |values| {
        let scene = scene(values);
        let shading = |ray: &Ray| match visible_point(&scene.objects, ray) {
            Some(point) => shading(&scene, &point),
            None => vec![],
        };
        chain::chain(values, &scene.objects, shading, |ray| colour(&scene, ray))
    },
    beside: None,
};

const fn lamp(words: [&'static str; 3], value: f64, range: [f64; 2]) -> Knob {
    Knob::new(words, value, range, 10.0)
}

/// The scene with its lamps where these values have them.
fn scene(values: &[f64]) -> Scene<Surface, PointLight> {
    let mut scene = step04_diffuse::scene();
    for (light, first) in scene.lights.iter_mut().zip([3, 6]) {
        light.position = DVec3::from_slice(&values[first..]);
    }
    scene
}

/// Where in the picture the lamp is whose x is the value `FIRST`.
fn place_of<const FIRST: usize>(values: &[f64]) -> DVec2 {
    asked::place(DVec3::from_slice(&values[FIRST..]))
}

/// Brings that lamp to a place in the picture; it stays as deep as it is.
fn drag<const FIRST: usize>(values: &mut [f64], to: DVec2) {
    let inside = to.clamp(DVec2::splat(24.0), asked::SIZE - 24.0);
    let position = asked::point(inside, -values[FIRST + 2]);
    position.write_to_slice(&mut values[FIRST..]);
}

/// What the lights of the scene are called, in their order.
pub const LAMPS: [&str; 2] = ["warm", "cool"];

/// From the point that a ray sees to the terms of its light.
fn shading(
    scene: &Scene<Surface, PointLight>,
    point: &SurfacePoint<Surface>,
) -> Numbers {
    let mut all = place(point);
    let mut sum = DVec3::ZERO;
    for (light, lamp) in scene.lights.iter().zip(LAMPS) {
        all.extend(lit(point, point.material, light, lamp));
        let (l, d) = light.direction_from(point.p);
        sum += diffuse(point.n, l, d, point.material, light);
    }
    let ambient = ambient(point.material, scene.ambient_light);
    all.push(("ambient".into(), vector(&ambient.to_array())));
    all.push(("diffuse".into(), vector(&sum.to_array())));
    all
}

/// Where a point is, and which way its surface faces.
pub fn place<M>(point: &SurfacePoint<M>) -> Numbers {
    vec![
        ("p".into(), vector(&point.p.to_array())),
        ("n".into(), vector(&point.n.to_array())),
    ]
}

/// A lamp as it is seen from a point, and the light that it scatters there.
pub fn lit<M>(
    point: &SurfacePoint<M>,
    surface: &Surface,
    light: &PointLight,
    lamp: &str,
) -> Numbers {
    let (l, d) = light.direction_from(point.p);
    let numbers = [
        ("l", vector(&l.to_array())),
        ("d", number(d)),
        ("divisor", number(light.attenuation.at(d))),
        ("nl", number(point.n.dot(l))),
        ("diffuse", vector(&diffuse(point.n, l, d, surface, light).to_array())),
    ];
    numbers.map(|(name, text)| (format!("{name} {lamp}"), text)).into()
}
