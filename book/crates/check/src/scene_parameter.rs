use crate::evidence::{Evidence, Pixel};
use crate::explanation::Explanation;
use crate::step_scene::{
    ENCODE, LIGHTS, Scene, intensity_function, object_name_with_article, scene_of_step,
};
use course::Step;
use step05_phong::Matte;

/// One or three numbers of each object or of each light, which stand in one place of a
/// file.
struct Parameter {
    /// Name before that of its owner; empty where it is the owner's place.
    name: &'static str,
    /// The kind of thing that has it.
    owner: OwnerKind,
    /// The first step that has it.
    since: Step,
    /// Such as `step03_nearest/objects.rs`.
    file: &'static str,
    /// How many numbers of the three it has.
    count: usize,
    /// The numbers that a reader may have typed: multiples of 1 / the last number, from the first
    /// number to the second.
    range: (i32, i32, i32),
    /// Reads that of owner k.
    get: fn(&Scene, usize) -> [f64; 3],
    /// Changes it.
    set: fn(&mut Scene, usize, [f64; 3]),
}

/// A kind of thing that has parameters.
#[derive(Clone, Copy, PartialEq)]
enum OwnerKind {
    Object,
    Light,
    Scene,
}

/// A colour of an object; most of the others differ from it in little.
const COLOUR: Parameter = Parameter {
    name: "the colour of ",
    owner: OwnerKind::Object,
    since: Step::Nearest,
    file: "step03_nearest/objects.rs",
    count: 3,
    range: (0, 5, 100),
    get: |scene, k| scene.objects[k].material.matte.diffuse.into(),
    set: |scene, k, v| {
        scene.objects[k].material.matte = Matte::of(v.into());
    },
};

/// All numbers of the scenes.
const PARAMETERS: [Parameter; 10] = [
    Parameter {
        name: "",
        since: Step::Sphere,
        range: (-50, 50, 100),
        get: |scene, k| scene.objects[k].sphere.centre.into(),
        set: |scene, k, v| scene.objects[k].sphere.centre = v.into(),
        ..COLOUR
    },
    Parameter {
        name: "the radius of ",
        since: Step::Sphere,
        count: 1,
        range: (0, 60, 100),
        get: |scene, k| [scene.objects[k].sphere.radius; 3],
        set: |scene, k, [r, ..]| scene.objects[k].sphere.radius = r,
        ..COLOUR
    },
    COLOUR,
    Parameter {
        name: "R_s of ",
        since: Step::Phong,
        file: "step05_phong/scene.rs",
        count: 1,
        get: |scene, k| scene.objects[k].material.specular.into(),
        set: |scene, k, v| scene.objects[k].material.specular = v.into(),
        ..COLOUR
    },
    Parameter {
        name: "n of ",
        since: Step::Phong,
        file: "step05_phong/scene.rs",
        count: 1,
        range: (0, 1000, 1),
        get: |scene, k| [scene.objects[k].material.shininess.into(); 3],
        set: |scene, k, [n, ..]| scene.objects[k].material.shininess = n as i32,
        ..COLOUR
    },
    Parameter {
        name: "L_a of ",
        owner: OwnerKind::Scene,
        get: |scene, _| scene.ambient_light.into(),
        set: |scene, _, v| scene.ambient_light = v.into(),
        ..DIFFUSE
    },
    Parameter {
        name: "",
        range: (-20, 20, 100),
        get: |scene, k| scene.lights[k].point_light.position.into(),
        set: |scene, k, v| scene.lights[k].point_light.position = v.into(),
        ..DIFFUSE
    },
    DIFFUSE,
    Parameter {
        name: "(a, b, c) of ",
        range: (0, 20, 1000),
        get: |scene, k| {
            let attenuation = scene.lights[k].point_light.attenuation;
            [attenuation.a, attenuation.b, attenuation.c]
        },
        set: |scene, k, [a, b, c]| {
            scene.lights[k].point_light.attenuation = step05_phong::Attenuation { a, b, c };
        },
        ..DIFFUSE
    },
    Parameter {
        name: "L_s of ",
        since: Step::Phong,
        file: "step05_phong/scene.rs",
        get: |scene, k| scene.lights[k].specular.into(),
        set: |scene, k, v| scene.lights[k].specular = v.into(),
        ..DIFFUSE
    },
];

/// A colour of a light; most parameters of lights differ from it in little.
const DIFFUSE: Parameter = Parameter {
    name: "L_d of ",
    owner: OwnerKind::Light,
    since: Step::Diffuse,
    file: "step04_diffuse/scene.rs",
    get: |scene, k| scene.lights[k].point_light.diffuse.into(),
    set: |scene, k, v| scene.lights[k].point_light.diffuse = v.into(),
    ..COLOUR
};

/// How many pixels are asked of a number before all are.
const FIRST: usize = 32;

/// The most numbers of one parameter that are asked of all pixels.
const MOST_NUMBERS: usize = 8;

/// Explanations, tried in a few pixels: our scene with one other number.
pub(crate) fn changed_number_candidates(
    evidence: &Evidence,
) -> impl Iterator<Item = Explanation<'_>> {
    let step = evidence.step.filter(|step| Step::Sphere <= *step);
    step.into_iter().flat_map(move |step| {
        let parameters = PARAMETERS.iter().filter(move |one| one.since <= step);
        parameters.flat_map(move |parameter| {
            let names = names_of_kind(parameter.owner, step).into_iter().enumerate();
            names
                .filter(|(k, _)| may_cause_wrong_pixels(parameter, *k, evidence))
                .flat_map(move |(k, name)| number_candidates(evidence, step, parameter, k, &name))
        })
    })
}

/// Whether all wrong pixels are where the parameter of owner `k` can change one.
fn may_cause_wrong_pixels(parameter: &Parameter, owner_index: usize, evidence: &Evidence) -> bool {
    let is_shape = parameter.since == Step::Sphere;
    evidence.wrong_pixels().iter().all(|pixel| match parameter.owner {
        OwnerKind::Object if is_shape => true,
        OwnerKind::Object => pixel.region.object == u8::try_from(owner_index).ok(),
        _ => !pixel.is_sky(),
    })
}

/// Explanations by other numbers of one parameter that give some of the wrong pixels.
fn number_candidates<'a>(
    evidence: &'a Evidence,
    step: Step,
    parameter: &Parameter,
    owner_index: usize,
    owner_name: &str,
) -> Vec<Explanation<'a>> {
    let mut scene = scene_of_step(step);
    let old = (parameter.get)(&scene, owner_index);
    let mut draw_with = |new: [f64; 3]| {
        (parameter.set)(&mut scene, owner_index, new);
        let intensity = intensity_function(step, &scene);
        move |pixel: &Pixel| ENCODE(intensity(&evidence.our_ray(pixel)))
    };
    let some = evidence.some_wrong_pixels(FIRST);
    let fits = all_with_one_number_changed(parameter, old).into_iter();
    let fits = fits.map(|new| (new, draw_with(new)));
    let fits = fits.filter(|(_, colour)| some.iter().all(|pixel| colour(pixel) == pixel.yours));
    let fits: Vec<_> = fits.take(MOST_NUMBERS).collect();
    let file = match step {
        Step::Sphere => "step02_sphere/picture.rs",
        _ => parameter.file,
    };
    let preposition = if parameter.name.is_empty() { "at " } else { "" };
    let verb = if fits.len() == 1 { "is" } else { "may be" };
    let explanation = |(new, colour)| {
        let [new, old] = [new, old].map(|one: [f64; 3]| format_numbers(&one[..parameter.count]));
        let sentence = format!(
            "In your picture {}{owner_name} {verb} {preposition}{new}; it should be \
             {preposition}{old}.",
            parameter.name
        );
        Explanation::exact(sentence, &[file], colour)
    };
    fits.into_iter().map(explanation).collect()
}

/// The names of all that has a parameter of a kind.
fn names_of_kind(owner: OwnerKind, step: Step) -> Vec<String> {
    match owner {
        OwnerKind::Object => {
            let count = scene_of_step(step).objects.len();
            (0..count).map(|k| object_name_with_article(step, k)).collect()
        }
        OwnerKind::Light => LIGHTS.map(str::to_owned).into(),
        OwnerKind::Scene => vec!["the scene".to_owned()],
    }
}

/// A parameter with one of its numbers changed, the nearest first.
fn all_with_one_number_changed(parameter: &Parameter, old: [f64; 3]) -> Vec<[f64; 3]> {
    let (start, end, parts) = parameter.range;
    let values = (start * parts..=end * parts).map(|value| f64::from(value) / f64::from(parts));
    let mut all = vec![];
    for k in 0..parameter.count {
        all.extend(values.clone().filter(|value| *value != old[k]).map(|value| {
            let mut new = if parameter.count == 1 { [value; 3] } else { old };
            new[k] = value;
            new
        }));
    }
    let distance = |new: &[f64; 3]| (0..3).map(|k| (new[k] - old[k]).abs()).sum();
    all.sort_by(|a, b| f64::total_cmp(&distance(a), &distance(b)));
    all
}

/// (1, −2.5, 0), or the number alone.
fn format_numbers(numbers: &[f64]) -> String {
    let all: Vec<_> = numbers.iter().map(f64::to_string).collect();
    let all = all.join(", ").replace('-', "−");
    if numbers.len() == 1 { all } else { format!("({all})") }
}
