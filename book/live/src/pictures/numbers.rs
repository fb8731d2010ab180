use super::{met, pixel, short_name};
use crate::discriminant;
use crate::live::{Numbers, named, number, vector};
use glam::DVec3;
use step01_rays::{Ray, direction_colour, rgb8};
use step05_phong::{
    Light, Material, Object, Scene, SurfacePoint, phong, reflect, visible_point,
};

/// Everything on the way from a pixel of a scene to its three bytes; `shading` is what
/// there is between the nearest hit and the sum.
pub fn numbers<M>(
    values: &[f64],
    objects: &[Object<M>],
    shading: impl FnOnce(&Ray) -> Option<Numbers>,
    colour: impl Fn(&Ray) -> DVec3,
) -> Numbers {
    let ray = pixel::ray(values);
    let mut numbers = named([
        ("i", number(values[0])),
        ("j", number(values[1])),
        ("V", vector(ray.direction)),
        ("sum", vector(colour(&ray))),
        ("bytes", vector(rgb8(colour(&ray)).0.map(f64::from))),
    ]);
    for (k, Object { sphere, .. }) in objects.iter().enumerate() {
        let (a, b, c) = sphere.coefficients(&ray);
        let d = discriminant(sphere, &ray);
        let row = ["a", "b", "c", "D"].into_iter().zip([a, b, c, d].map(number));
        let roots = sphere.intersect(&ray);
        let roots = [roots.iter().next(), roots.iter().last()].map(root);
        let roots = ["near", "far"].into_iter().zip(roots);
        let row = row.chain(roots);
        numbers.extend(row.map(|(name, text)| (format!("{name}{k}"), text)));
    }
    // What the ray meets, or else the colour of the sky; what there is not is empty.
    let (mut which, mut t, mut sky) = Default::default();
    if let Some((k, hit)) = met(objects, &ray) {
        (which, t) = (short_name(objects[k].name), number(hit));
    } else {
        sky = vector(direction_colour(&ray));
    }
    numbers.extend(named([("which", which.into()), ("t", t), ("sky", sky)]));
    numbers.extend(shading(&ray).unwrap_or_default());
    numbers
}

/// A root, or what is written where there is none.
fn root(t: Option<f64>) -> String {
    t.map_or("–".to_string(), number)
}

/// From the point that a ray sees to what each lamp adds, and the terms.
pub fn shading(scene: &Scene<Material, Light>, ray: &Ray) -> Option<Numbers> {
    let point = visible_point(&scene.objects, ray)?;
    let SurfacePoint { p, n, material } = point;
    let terms = phong(&point, ray, scene.ambient_light, &scene.lights);
    let v = -ray.direction.normalize();
    let mut all = named([
        ("p", vector(p)),
        ("n", vector(n)),
        ("v", vector(v)),
        ("shininess", material.shininess.to_string()),
        ("ambient", vector(terms.ambient)),
        ("diffuse", vector(terms.diffuse)),
        ("specular", vector(terms.specular)),
    ]);
    for (light, lamp) in scene.lights.iter().zip(["warm", "cool"]) {
        let (l, d) = light.point_light.direction_from(p);
        let r = reflect(n, l);
        let power = r.dot(v).max(0.0).powi(material.shininess);
        let alone = phong(&point, ray, DVec3::ZERO, &[*light]);
        let numbers = [
            ("l", vector(l)),
            ("d", number(d)),
            ("divisor", number(light.point_light.attenuation.divisor(d))),
            ("nl", number(n.dot(l))),
            ("diffuse", vector(alone.diffuse)),
            ("r", vector(r)),
            ("rv", number(r.dot(v))),
            ("power", number(power)),
            ("specular", vector(alone.specular)),
        ];
        all.extend(numbers.map(|(name, text)| (format!("{name} {lamp}"), text)));
    }
    Some(all)
}
