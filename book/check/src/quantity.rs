use crate::Step;
use crate::scenes::{LIGHTS, OBJECTS, Scenes};
use glam::DVec3;

type Get = Box<dyn Fn(&Scenes) -> Vec<f64>>;
type Set = Box<dyn Fn(&mut Scenes, &[f64])>;

/// One or three numbers of a scene, which stand in one line of a file.
pub(crate) struct Quantity {
    /// What "is at" or "is" the value.
    pub subject: String,
    /// "at " before the value of a place, or nothing.
    pub at: &'static str,
    /// Such as `step03_nearest/objects.rs`.
    pub file: &'static str,
    /// Values that a reader may have typed for one of the numbers.
    pub values: Vec<f64>,
    /// Of what sort it is: those of one sort may have changed places.
    pub sort: &'static str,
    /// Reads it.
    pub get: Get,
    /// Changes it.
    pub set: Set,
}

/// All multiples of 1 / `parts` from `start` to `end`.
fn multiples(start: i32, end: i32, parts: i32) -> impl Iterator<Item = f64> {
    let all = start * parts..=end * parts;
    all.map(move |k| f64::from(k) / f64::from(parts))
}

const OBJECTS_FILE: &str = "step03_nearest/objects.rs";
const LIGHTS_FILE: &str = "step04_diffuse/scene.rs";
const MATERIALS_FILE: &str = "step05_phong/scene.rs";

/// All quantities of a step's scene.
pub(crate) fn quantities(step: Step, scenes: &Scenes) -> Vec<Quantity> {
    let mut all = vec![];
    let count = scenes.spheres(step).len();
    for (k, name) in OBJECTS.into_iter().enumerate().take(count) {
        all.extend(sphere(step, k));
        if Step::Nearest <= step {
            all.push(quantity(
                "the colour of",
                name,
                OBJECTS_FILE,
                move |s| s.flat[k].material.to_array().into(),
                move |s, v| s.set_colour(k, DVec3::from_slice(v)),
            ));
        }
        if step == Step::Phong {
            all.extend(material(k));
        }
    }
    if Step::Diffuse <= step {
        all.push(quantity(
            "L_a of",
            "the scene",
            LIGHTS_FILE,
            |s| s.matt.ambient_light.to_array().into(),
            |s, v| s.set_ambient(DVec3::from_slice(v)),
        ));
        for (k, name) in LIGHTS.into_iter().enumerate() {
            all.extend(light(k));
            if step == Step::Phong {
                all.push(quantity(
                    "L_s of",
                    name,
                    MATERIALS_FILE,
                    move |s| s.shiny.lights[k].specular.to_array().into(),
                    move |s, v| s.shiny.lights[k].specular = DVec3::from_slice(v),
                ));
            }
        }
    }
    all
}

/// Numbers that are colours, of 0 to 5.
fn quantity(
    sort: &'static str,
    owner: &str,
    file: &'static str,
    get: impl Fn(&Scenes) -> Vec<f64> + 'static,
    set: impl Fn(&mut Scenes, &[f64]) + 'static,
) -> Quantity {
    let values = multiples(0, 5, 100).collect();
    let subject = format!("{sort} {owner}");
    let (get, set) = (Box::new(get), Box::new(set));
    Quantity { subject, at: "", file, values, sort, get, set }
}

fn sphere(step: Step, k: usize) -> [Quantity; 2] {
    let (name, file) = match step {
        Step::Sphere => ("the sphere", "step02_sphere/picture.rs"),
        _ => (OBJECTS[k], OBJECTS_FILE),
    };
    let centre = quantity(
        "the centre of",
        name,
        file,
        move |s| s.spheres(step)[k].centre.to_array().into(),
        move |s, v| s.set_sphere(step, k, |one| one.centre = DVec3::from_slice(v)),
    );
    let radius = quantity(
        "the radius of",
        name,
        file,
        move |s| vec![s.spheres(step)[k].radius],
        move |s, v| s.set_sphere(step, k, |one| one.radius = v[0]),
    );
    let places = multiples(-50, 50, 100).collect();
    [
        Quantity { subject: name.to_owned(), at: "at ", values: places, ..centre },
        Quantity { values: multiples(0, 60, 100).skip(1).collect(), ..radius },
    ]
}

fn material(k: usize) -> [Quantity; 2] {
    let specular = quantity(
        "R_s of",
        OBJECTS[k],
        MATERIALS_FILE,
        move |s| vec![s.shiny.objects[k].material.specular.x],
        move |s, v| s.shiny.objects[k].material.specular = DVec3::splat(v[0]),
    );
    let shininess = quantity(
        "n of",
        OBJECTS[k],
        MATERIALS_FILE,
        move |s| vec![s.shiny.objects[k].material.shininess.into()],
        move |s, v| s.shiny.objects[k].material.shininess = v[0] as i32,
    );
    [specular, Quantity { values: multiples(0, 1000, 1).collect(), ..shininess }]
}

fn light(k: usize) -> [Quantity; 3] {
    let position = quantity(
        "the position of",
        LIGHTS[k],
        LIGHTS_FILE,
        move |s| s.matt.lights[k].position.to_array().into(),
        move |s, v| s.set_light(k, |one| one.position = DVec3::from_slice(v)),
    );
    let diffuse = quantity(
        "L_d of",
        LIGHTS[k],
        LIGHTS_FILE,
        move |s| s.matt.lights[k].diffuse.to_array().into(),
        move |s, v| s.set_light(k, |one| one.diffuse = DVec3::from_slice(v)),
    );
    let attenuation = quantity(
        "(a, b, c) of",
        LIGHTS[k],
        LIGHTS_FILE,
        move |s| {
            let one = s.matt.lights[k].attenuation;
            vec![one.a, one.b, one.c]
        },
        move |s, v| {
            s.set_light(k, |one| {
                let parts = &mut one.attenuation;
                (parts.a, parts.b, parts.c) = (v[0], v[1], v[2]);
            });
        },
    );
    let places = multiples(-20, 20, 100).collect();
    let parts = multiples(0, 1, 1000).chain(multiples(1, 20, 10)).collect();
    [
        Quantity {
            subject: LIGHTS[k].to_owned(),
            at: "at ",
            values: places,
            ..position
        },
        diffuse,
        Quantity { values: parts, ..attenuation },
    ]
}
