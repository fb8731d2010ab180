//! The trace of a pixel: every number on the way from its ray to its three bytes.

use crate::probe::probe_ray;
use crate::{Numbers, collect_numbers, format_number, format_vector, short_name};
use glam::DVec3;
use step01_rays::{Ray, direction_colour, rgb8};
use step02_sphere::Sphere;
use step05_phong::{
    Hit, Light, Material, Object, Scene, light_terms, nearest, phong, reflect, visible_point,
};

/// b² − 4ac of a ray and a sphere.
pub fn discriminant(sphere: &Sphere, ray: &Ray) -> f64 {
    let (a, b, c) = sphere.coefficients(ray);
    b * b - 4.0 * a * c
}

/// The trace of the probe's pixel, but for what lies between the point and the colour.
pub fn trace_pixel<M>(
    values: &[f64],
    objects: &[Object<M>],
    colour: impl Fn(&Ray) -> DVec3,
) -> Numbers {
    let ray = probe_ray(values);
    let mut numbers = collect_numbers([
        ("i", format_number(values[0])),
        ("j", format_number(values[1])),
        ("V", format_vector(ray.direction)),
        ("length", format_number(ray.direction.length())),
        ("sum", format_vector(colour(&ray))),
        ("bytes", format_vector(rgb8(colour(&ray)).0.map(f64::from))),
    ]);
    for (k, Object { sphere, .. }) in objects.iter().enumerate() {
        let (a, b, c) = sphere.coefficients(&ray);
        let d = discriminant(sphere, &ray);
        let roots = sphere.intersect(&ray);
        let format_root = |t: Option<f64>| t.map_or("–".into(), format_number);
        let row = [
            ("a", format_number(a)),
            ("b", format_number(b)),
            ("c", format_number(c)),
            ("D", format_number(d)),
            ("near", format_root(roots.into_iter().next())),
            ("far", format_root(roots.into_iter().last())),
        ];
        numbers.extend(row.map(|(name, text)| (format!("{name}{k}"), text)));
    }
    // A ray has either a nearest hit or a colour of the sky; the other is empty.
    let [object, t, p, sky] = match nearest(objects, &ray) {
        Some(Hit { object, t }) => {
            [short_name(object.name).into(), format_number(t), format_vector(ray.at(t)), "".into()]
        }
        None => ["".into(), "".into(), "".into(), format_vector(direction_colour(&ray))],
    };
    numbers.extend(collect_numbers([("object", object), ("t", t), ("p", p), ("sky", sky)]));
    numbers
}

/// The numbers from the point at the probe to the terms, and those of each light;
/// empty for the sky.
pub fn trace_shading(values: &[f64], scene: &Scene<Material, Light>) -> Numbers {
    let ray = &probe_ray(values);
    let Some(point) = visible_point(&scene.objects, ray) else { return Numbers::new() };
    let (p, n, material) = (point.p, point.n, point.material());
    let terms = phong(&point, ray, scene.ambient_light, &scene.lights);
    let v = -ray.direction.normalize();
    let mut numbers = collect_numbers([
        ("n", format_vector(n)),
        ("v", format_vector(v)),
        ("shininess", material.shininess.to_string()),
        ("ambient", format_vector(terms.ambient)),
        ("diffuse", format_vector(terms.diffuse)),
        ("specular", format_vector(terms.specular)),
    ]);
    for (light, name_of_light) in scene.lights.iter().zip(["warm", "cool"]) {
        let (l, d) = light.point_light.direction_from(p);
        let r = reflect(n, l);
        let power = r.dot(v).max(0.0).powi(material.shininess);
        let divisor = light.point_light.attenuation.divisor(d);
        let terms = light_terms(p, n, v, material, light);
        let column = [
            ("l", format_vector(l)),
            ("d", format_number(d)),
            ("divisor", format_number(divisor)),
            ("nl", format_number(n.dot(l))),
            ("diffuse", format_vector(terms.diffuse)),
            ("r", format_vector(r)),
            ("rv", format_number(r.dot(v))),
            ("power", format_number(power)),
            ("specular", format_vector(terms.specular)),
        ];
        numbers.extend(column.map(|(name, text)| (format!("{name} {name_of_light}"), text)));
    }
    numbers
}
