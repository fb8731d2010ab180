//! The trace of a pixel: every number from its ray to its three bytes.

use crate::probe::{I, J, probe_ray};
use crate::{
    ParameterValues, Readouts, collect_readouts, format_number, format_vector, row_readout_name,
    short_name,
};
use course::{LIGHT_NAMES, discriminant};
use glam::DVec3;
use step01_rays::{Ray, direction_colour, rgb8};
use step05_phong::{
    Hit, Light, Material, Object, Scene, light_terms, nearest, phong, reflect, visible_point,
};

/// Describes the first hit of a ray: the object's short name and the t of the hit. Returns “sky” if
/// the ray hits no object.
pub fn describe_hit<M>(objects: &[Object<M>], ray: &Ray) -> String {
    match nearest(objects, ray) {
        Some(Hit { object, t }) => {
            format!("{}, t = {}", short_name(object.name), format_number(t))
        }
        None => "sky".to_owned(),
    }
}

/// The trace of the probe's pixel, without the shading. [`trace_phong_terms`] returns the trace of
/// the shading.
pub fn trace_pixel<M>(
    values: &ParameterValues,
    objects: &[Object<M>],
    colour: impl Fn(&Ray) -> DVec3,
) -> Readouts {
    let ray = probe_ray(values);
    let mut readouts = collect_readouts([
        ("i", format_number(values[I])),
        ("j", format_number(values[J])),
        ("V", format_vector(ray.direction)),
        ("length", format_number(ray.direction.length())),
        ("sum", format_vector(colour(&ray))),
        ("bytes", format_vector(rgb8(colour(&ray)).0.map(f64::from))),
        ("seen", describe_hit(objects, &ray)),
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
        readouts.extend(row.map(|(column, text)| (row_readout_name(column, k), text)));
    }
    // If the ray hits an object, the readout for the sky is empty. Otherwise, the readouts for the
    // hit are empty.
    let [object, t, p, sky] = match nearest(objects, &ray) {
        Some(Hit { object, t }) => {
            [short_name(object.name).into(), format_number(t), format_vector(ray.at(t)), "".into()]
        }
        None => ["".into(), "".into(), "".into(), format_vector(direction_colour(&ray))],
    };
    readouts.extend(collect_readouts([("object", object), ("t", t), ("p", p), ("sky", sky)]));
    readouts
}

/// The trace of the shading at the probe: n, v, the shininess and the three Phong terms, then the
/// numbers for each light. Returns no readouts if the probe is on the sky.
pub fn trace_phong_terms(values: &ParameterValues, scene: &Scene<Material, Light>) -> Readouts {
    let ray = &probe_ray(values);
    let Some(point) = visible_point(&scene.objects, ray) else { return Readouts::new() };
    let (p, n, material) = (point.p, point.n, point.material());
    let terms = phong(&point, ray, scene.ambient_light, &scene.lights);
    let v = -ray.direction.normalize();
    let mut readouts = collect_readouts([
        ("n", format_vector(n)),
        ("v", format_vector(v)),
        ("shininess", material.shininess.to_string()),
        ("ambient", format_vector(terms.ambient)),
        ("diffuse", format_vector(terms.diffuse)),
        ("specular", format_vector(terms.specular)),
    ]);
    for (light, light_name) in scene.lights.iter().zip(LIGHT_NAMES) {
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
        readouts
            .extend(column.map(|(name, text)| (format!("{name} {}", light_name.adjective), text)));
    }
    readouts
}
