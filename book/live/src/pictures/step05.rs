use super::polish::{SHININESS, SPECULAR, scene};
use super::step04::{self, LAMPS, place};
use super::{asked, chain, lit};
use crate::live::{Knob, Live, Numbers, number, vector};
use glam::DVec3;
use step05_phong::{
    Light, Material, Ray, Scene, SurfacePoint, colour, reflect, specular, terms,
    visible_point,
};

const SWITCH: &[&str] = &["off", "on"];

/// The picture of step 5: each term to switch off, a pixel to ask, and the material
/// of what it shows to set.
pub const STEP05: Live = Live {
    name: "step05_phong",
    knobs: &KNOBS,
    handles: &[asked::PIXEL],
    is_allowed: |values| asked::camera(values[5]).is_ok(),
    sight: |values| lit(&asked::seen(values[5]), &switched(values)),
    numbers: |values| {
        let scene = switched(values);
        let between = |ray: &Ray| between(&scene, ray).unwrap_or_default();
        chain::chain(values, &scene.objects, between, |ray| colour(&scene, ray))
    },
    beside: None,
};

const KNOBS: [Knob; 24] = {
    let mut knobs = [asked::COLUMNS; 24];
    (knobs[0], knobs[1]) = (asked::COLUMN, asked::ROW);
    knobs[2] = Knob::choice("ambient", 1.0, SWITCH);
    knobs[3] = Knob::choice("diffuse", 1.0, SWITCH);
    knobs[4] = Knob::choice("specular", 1.0, SWITCH);
    let mut k = 0;
    while k < 9 {
        (knobs[6 + k], knobs[15 + k]) = (SHININESS[k], SPECULAR[k]);
        k += 1;
    }
    knobs
};

/// The scene in the light of the terms that are switched on; that of the others is 0.
fn switched(values: &[f64]) -> Scene<Material, Light> {
    let mut scene = scene(&values[6..]);
    scene.ambient_light *= values[2];
    for light in &mut scene.lights {
        light.point_light.diffuse *= values[3];
        light.specular *= values[4];
    }
    scene
}

/// Everything between the nearest hit and the sum.
fn between(scene: &Scene<Material, Light>, ray: &Ray) -> Option<Numbers> {
    let mut numbers = shading(scene, ray, &visible_point(&scene.objects, ray)?);
    let terms = terms(scene, ray)?;
    let terms = [
        ("ambient", terms.ambient),
        ("diffuse", terms.diffuse),
        ("specular", terms.specular),
    ];
    let texts = terms.map(|(name, term)| (name, vector(&term.to_array())));
    numbers.extend(texts.map(|(name, text)| (name.into(), text)));
    Some(numbers)
}

/// From the point that a ray sees to what each lamp adds.
fn shading(
    scene: &Scene<Material, Light>,
    ray: &Ray,
    point: &SurfacePoint<Material>,
) -> Numbers {
    let SurfacePoint { p, n, material } = *point;
    let v = -ray.direction.normalize();
    let mut all = place(point);
    all.push(("v".into(), vector(&v.to_array())));
    all.push(("shininess".into(), material.shininess.to_string()));
    for (light, lamp) in scene.lights.iter().zip(LAMPS) {
        all.extend(step04::lit(point, &material.surface, &light.point_light, lamp));
        let (l, d) = light.point_light.direction_from(p);
        let r = reflect(n, l);
        let i_s = specular(r, v, d, material, light);
        let i_s = if 0.0 < n.dot(l) { i_s } else { DVec3::ZERO };
        let power = r.dot(v).max(0.0).powi(material.shininess);
        let numbers = [
            ("r", vector(&r.to_array())),
            ("rv", number(r.dot(v))),
            ("power", number(power)),
            ("specular", vector(&i_s.to_array())),
        ];
        all.extend(numbers.map(|(name, text)| (format!("{name} {lamp}"), text)));
    }
    all
}
