use super::asked::ray;
use crate::live::{Numbers, number, vector};
use crate::{discriminant, roots};
use glam::{DMat3, DVec3};
use step01_rays::{Camera, Ray, direction_colour, render};
use step02_sphere::Sphere;
use step03_nearest::{Hit, Object, nearest};

/// What the chapters call the objects of the scene, in their order.
pub const NAMES: [&str; 9] = [
    "red", "ground", "golden", "blue", "green", "teal", "white", "salmon", "cream",
];

/// Everything on the way from a pixel of a scene to its three bytes; `shading` is what
/// there is between the nearest hit and the sum.
pub fn chain<M>(
    values: &[f64],
    objects: &[Object<M>],
    shading: impl FnOnce(&Ray) -> Numbers,
    colour: impl Fn(&Ray) -> DVec3 + Sync,
) -> Numbers {
    let ray = ray(values);
    let spheres = objects.iter().map(|object| &object.sphere);
    let mut chain = from_pixel(values, spheres);
    let hit = nearest(objects, &ray);
    chain.extend(met(hit.map(|hit| named(objects, hit)), &ray));
    chain.extend(shading(&ray));
    chain.push(("sum".into(), vector(&colour(&ray).to_array())));
    chain.push(bytes(&ray, colour));
    chain
}

/// From the pixel to every root, sphere by sphere.
pub fn from_pixel<'a>(
    values: &[f64],
    spheres: impl Iterator<Item = &'a Sphere>,
) -> Numbers {
    let ray = ray(values);
    let mut numbers: Numbers = vec![
        ("i".into(), number(values[0])),
        ("j".into(), number(values[1])),
        ("V".into(), vector(&ray.direction.to_array())),
    ];
    for (k, sphere) in spheres.enumerate() {
        let (a, b, c) = sphere.coefficients(&ray);
        let [near, far] = roots(sphere, &ray).map(root);
        let d = number(discriminant(sphere, &ray));
        let row = [number(a), number(b), number(c), d, near, far];
        let names = ["a", "b", "c", "D", "near", "far"];
        numbers.extend(names.map(|name| format!("{name}{k}")).into_iter().zip(row));
    }
    numbers
}

/// A root, or what is written where there is none.
fn root(t: f64) -> String {
    if t.is_nan() { "–".to_string() } else { number(t) }
}

/// What the object of a hit is called, and the t of it.
fn named<M>(objects: &[Object<M>], hit: Hit<M>) -> (&'static str, f64) {
    let mut named = objects.iter().zip(NAMES);
    let known = named.find(|(object, _)| std::ptr::eq(*object, hit.object));
    (known.map_or("", |(_, name)| name), hit.t)
}

/// What the ray meets and where, or else the colour of the sky; the one that there is
/// not is empty.
pub fn met(hit: Option<(&str, f64)>, ray: &Ray) -> Numbers {
    let (which, t) =
        hit.map_or_else(Default::default, |(which, t)| (which, number(t)));
    let sky = match hit {
        Some(_) => String::new(),
        None => vector(&direction_colour(ray).to_array()),
    };
    vec![("which".into(), which.into()), ("t".into(), t), ("sky".into(), sky)]
}

/// The three bytes of the pixel through which `ray` goes: a picture of this one ray.
pub fn bytes(ray: &Ray, colour: impl Fn(&Ray) -> DVec3 + Sync) -> (String, String) {
    let matrix = DMat3::from_cols(DVec3::ZERO, DVec3::ZERO, ray.direction);
    let camera = Camera { centre: ray.start, h_res: 1, v_res: 1, matrix };
    let pixel = render(&camera, 1, colour).get_pixel(0, 0).0;
    ("bytes".into(), vector(&pixel.map(f64::from)))
}
