use super::{picture, pixel, step01};
use crate::live::{Handle, Knob, Live, Numbers, number, vector};
use crate::{camera, discriminant, roots};
use glam::{DVec3, dvec2};
use step05_phong::{
    Light, Material, Object, Phong, Point, Ray, Scene, diffuse, direction_colour,
    nearest, reflect, scene, seen, specular, terms,
};

const SWITCH: &[&str] = &["off", "on"];

/// The picture of step 5, with each term to switch off, and a pixel to ask.
pub const STEP05: Live = Live {
    name: "step05_phong",
    knobs: &[
        Knob::new(["i", "column", ""], 470.0, [0.0, 639.0], 1.0),
        Knob::new(["j", "row", ""], 120.0, [0.0, 359.0], 1.0),
        Knob::choice("ambient", 1.0, SWITCH),
        Knob::choice("diffuse", 1.0, SWITCH),
        Knob::choice("specular", 1.0, SWITCH),
        Knob::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0).fixed(),
    ],
    handles: &[Handle {
        words: "the pixel that you ask",
        knobs: [0, 1],
        at: |values| dvec2(values[0], values[1]) + 0.5,
        drag: |values, to| {
            values[..2].copy_from_slice(&(to - 0.5).to_array());
        },
        is_down: true,
    }],
    is_allowed: |values| step01::camera(&[60.0, 1.0, values[5]]).is_ok(),
    sight: |values| {
        let scene = scene();
        picture(&step01::seen(&[60.0, 1.0, values[5]]), |ray| {
            lit(&scene, values, ray)
        })
    },
    numbers: |values| chain(&scene(), values),
};

/// The terms that are switched on; the others are 0.
fn switched(terms: &Phong, values: &[f64]) -> Phong {
    Phong {
        ambient: values[2] * terms.ambient,
        diffuse: values[3] * terms.diffuse,
        specular: values[4] * terms.specular,
    }
}

/// The colour that `ray` sees in the light of these terms.
fn lit(scene: &Scene<Material, Light>, values: &[f64], ray: &Ray) -> DVec3 {
    match terms(scene, ray) {
        Some(terms) => switched(&terms, values).sum(),
        None => direction_colour(ray),
    }
}

/// What is written where a ray has no such number.
const NONE: &str = "–";

/// Everything on the way from a pixel to its three bytes.
fn chain(scene: &Scene<Material, Light>, values: &[f64]) -> Numbers {
    let [i, j] = [values[0], values[1]];
    let ray = camera().ray(i, j);
    let mut chain: Numbers = vec![
        ("i".into(), number(i)),
        ("j".into(), number(j)),
        ("V".into(), vector(&ray.direction.to_array())),
    ];
    for (k, object) in scene.objects.iter().enumerate() {
        let (a, b, c) = object.sphere.coefficients(&ray);
        let d = discriminant(&object.sphere, &ray);
        let [near, far] = roots(&object.sphere, &ray).map(root);
        let row = [number(a), number(b), number(c), number(d), near, far];
        let names = ["a", "b", "c", "D", "near", "far"];
        chain.extend(names.map(|name| format!("{name}{k}")).into_iter().zip(row));
    }
    let hit = nearest(&scene.objects, &ray);
    chain.push(("t".into(), hit.map_or(NONE.into(), |hit| number(hit.t))));
    let which = hit.map_or("none of them", |hit| name(scene, hit.object));
    chain.push(("which".into(), which.into()));
    let point = seen(&scene.objects, &ray);
    chain.extend(match &point {
        Some(point) => shading(scene, values, &ray, point),
        // A ray that meets nothing leaves the rest empty.
        None => NAMES.map(|name| (name.into(), NONE.into())).into(),
    });
    let bytes = pixel(&ray, |ray| lit(scene, values, ray));
    chain.push(("bytes".into(), vector(&bytes.map(f64::from))));
    chain
}

/// What has a number only where a ray meets something, in the order of `shading`.
const NAMES: [&str; 26] = [
    "p",
    "n",
    "v",
    "shininess",
    "l warm",
    "d warm",
    "divisor warm",
    "nl warm",
    "r warm",
    "rv warm",
    "power warm",
    "diffuse warm",
    "specular warm",
    "l cool",
    "d cool",
    "divisor cool",
    "nl cool",
    "r cool",
    "rv cool",
    "power cool",
    "diffuse cool",
    "specular cool",
    "ambient",
    "diffuse",
    "specular",
    "sum",
];

/// From the point that a ray sees to the sum of the terms.
fn shading(
    scene: &Scene<Material, Light>,
    values: &[f64],
    ray: &Ray,
    point: &Point<Material>,
) -> Numbers {
    let Point { p, n, material } = *point;
    let v = -ray.direction.normalize();
    let mut all: Vec<(String, String)> = vec![
        ("p".into(), vector(&p.to_array())),
        ("n".into(), vector(&n.to_array())),
        ("v".into(), vector(&v.to_array())),
        ("shininess".into(), material.shininess.to_string()),
    ];
    for (light, lamp) in scene.lights.iter().zip(["warm", "cool"]) {
        let (l, d) = light.point.seen_from(p);
        let r = reflect(l, n);
        let i_d = diffuse(n, l, d, &material.surface, &light.point);
        let i_s = specular(r, v, d, material, light);
        let i_s = if 0.0 < n.dot(l) { i_s } else { DVec3::ZERO };
        let power = r.dot(v).max(0.0).powi(material.shininess);
        let numbers = [
            ("l", vector(&l.to_array())),
            ("d", number(d)),
            ("divisor", number(light.point.attenuation.at(d))),
            ("nl", number(n.dot(l))),
            ("r", vector(&r.to_array())),
            ("rv", number(r.dot(v))),
            ("power", number(power)),
            ("diffuse", vector(&i_d.to_array())),
            ("specular", vector(&i_s.to_array())),
        ];
        all.extend(numbers.map(|(name, text)| (format!("{name} {lamp}"), text)));
    }
    if let Some(terms) = terms(scene, ray) {
        let terms = switched(&terms, values);
        let terms = [
            ("ambient", terms.ambient),
            ("diffuse", terms.diffuse),
            ("specular", terms.specular),
            ("sum", terms.sum()),
        ];
        let texts =
            terms.map(|(name, term)| (name.into(), vector(&term.to_array())));
        all.extend(texts);
    }
    all
}

fn root(t: f64) -> String {
    if t.is_nan() { NONE.to_string() } else { number(t) }
}

/// What the chapters call the objects of the scene, in their order.
pub const OBJECTS: [&str; 9] = [
    "red", "ground", "golden", "blue", "green", "teal", "white", "salmon", "cream",
];

fn name(scene: &Scene<Material, Light>, object: &Object<Material>) -> &'static str {
    let known = scene.objects.iter().zip(OBJECTS).find(|(one, _)| *one == object);
    known.map_or("", |(_, name)| name)
}
