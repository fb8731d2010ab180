use crate::evidence::Evidence;
use crate::explanation::Explanation;
use crate::step_scene::{
    ENCODE, LIGHTS, Scene, intensity_function, object_name_with_article, scene_of_step,
};
use course::Step;
use step05_phong::terms;

const NEAREST: &str = "step03_nearest/nearest.rs";
const OBJECTS: &str = "step03_nearest/objects.rs";
const PICTURE: &str = "step03_nearest/picture.rs";

/// Explanations, not yet tried: our scene without one object, or without the last ones.
pub(crate) fn missing_object_candidates(
    evidence: &Evidence,
) -> impl Iterator<Item = Explanation<'_>> {
    let step = evidence.step.filter(|step| Step::Nearest <= *step);
    step.into_iter().flat_map(move |step| {
        let ours = scene_of_step(step);
        let count = ours.objects.len();
        let one_missing = (0..count).map(move |k| {
            let name = object_name_with_article(step, k);
            (k..k + 1, format!("In your picture {name} is missing."))
        });
        let only_first = (1..count - 1).map(move |first| {
            let sentence = format!("In your picture only the first {first} objects are there.");
            (first..count, sentence)
        });
        one_missing.chain(only_first).map(move |(missing, sentence)| {
            let mut scene = ours.clone();
            scene.objects.drain(missing);
            let intensity = intensity_function(step, &scene);
            let files = [OBJECTS, NEAREST, PICTURE];
            Explanation::exact(sentence, &files, move |pixel| {
                ENCODE(intensity(&evidence.our_ray(pixel)))
            })
        })
    })
}

/// Explanations, not yet tried: terms of the light left out or counted twice; first those
/// of which few are changed.
pub(crate) fn term_candidates(evidence: &Evidence) -> impl Iterator<Item = Explanation<'_>> {
    let step = evidence.step.filter(|step| Step::Diffuse <= *step);
    step.into_iter().flat_map(move |step| {
        let names = names_and_files_of_terms(step);
        let count = names.len() as u32;
        let mut all: Vec<Vec<u32>> = (0..3_u32.pow(count))
            .map(|choice| (0..count).map(|k| (choice / 3_u32.pow(k) + 1) % 3).collect())
            .collect();
        all.sort_by_key(|factors| factors.iter().filter(|one| **one != 1).count());
        let changed = all.into_iter().skip(1);
        changed.map(move |factors| term_candidate(evidence, step, &names, factors))
    })
}

/// The terms of a step: the ambient one, those of each light, and their files.
fn names_and_files_of_terms(step: Step) -> Vec<(String, &'static str)> {
    let mut all = vec![("the ambient term".to_owned(), "step04_diffuse/ambient.rs")];
    for (kind, since, file) in [
        ("diffuse", Step::Diffuse, "step04_diffuse/diffuse.rs"),
        ("specular", Step::Phong, "step05_phong/specular.rs"),
    ] {
        let lights = LIGHTS.iter().filter(|_| since <= step);
        all.extend(lights.map(|light| (format!("the {kind} term of {light}"), file)));
    }
    all
}

/// Explanation, not yet tried: each term of the light so many times.
fn term_candidate<'a>(
    evidence: &'a Evidence,
    step: Step,
    names: &[(String, &'static str)],
    factors: Vec<u32>,
) -> Explanation<'a> {
    let changed = names.iter().zip(&factors).filter(|(_, factor)| **factor != 1);
    let words = changed.clone().map(|((name, _), factor)| match factor {
        0 => format!("without {name}"),
        _ => format!("with {name} twice"),
    });
    let sentence = format!("Your picture is ours {}.", words.collect::<Vec<_>>().join(", "));
    let mut files: Vec<_> = changed.map(|((_, file), _)| *file).collect();
    files.push(match step {
        Step::Phong => "step05_phong/phong.rs",
        _ => "step04_diffuse/picture.rs",
    });
    files.dedup();
    let ours = scene_of_step(step);
    let scenes = [0, 1].map(|k| Scene { lights: vec![ours.lights[k]], ..ours.clone() });
    let mut explanation = Explanation::exact(sentence, &files, move |pixel| {
        let ray = evidence.our_ray(pixel);
        let [Some(warm), Some(cool)] = [0, 1].map(|k| terms(&scenes[k], &ray)) else {
            return pixel.ours;
        };
        let terms = [warm.ambient, warm.diffuse, cool.diffuse, warm.specular, cool.specular];
        let scaled = terms.iter().zip(&factors).map(|(term, factor)| *term * f64::from(*factor));
        ENCODE(scaled.sum())
    });
    explanation.rays = 2;
    explanation
}
