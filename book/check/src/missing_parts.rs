use crate::Step;
use crate::evidence::{Evidence, Pixel};
use crate::explanation::Explanation;
use crate::step_scene::{
    LIGHTS, Scene, hits_nearest_first, intensity_function,
    object_name_with_article, scene_of_step,
};
use glam::DVec3;
use std::collections::{BTreeMap, HashSet};
use std::f64::consts::{FRAC_1_PI, PI};
use step05_phong::{Phong, Ray, terms};

const NEAREST: &str = "step03_nearest/nearest.rs";
const OBJECTS: &str = "step03_nearest/objects.rs";
const AMBIENT: &str = "step04_diffuse/ambient.rs";
const DIFFUSE: &str = "step04_diffuse/diffuse.rs";
const SPECULAR: &str = "step05_phong/specular.rs";
const RENDER: &str = "step01_rays/render.rs";

/// Explanations, not yet tried: our scene without one object, without the last ones, without the
/// rule that the nearest is in front.
pub(crate) fn object_candidates<'a>(
    evidence: &'a Evidence,
) -> impl Iterator<Item = Explanation<'a>> {
    let step = evidence.step.filter(|step| Step::Nearest <= *step);
    step.into_iter().flat_map(move |step| {
        let count = scene_of_step(step).objects.len();
        let one_missing = (0..count).map(move |k| {
            let sentence = format!(
                "In your picture {} is missing.",
                object_name_with_article(step, k)
            );
            missing_objects_candidate(evidence, step, sentence, &[OBJECTS], |n| {
                n == k
            })
        });
        let only_first = (1..count - 1).map(move |first| {
            let sentence = format!(
                "In your picture only the first {first} objects are there."
            );
            missing_objects_candidate(
                evidence,
                step,
                sentence,
                &[OBJECTS, NEAREST],
                |n| first <= n,
            )
        });
        let only_last = (1..count - 1).map(move |first| {
            let sentence =
                format!("In your picture the first {first} objects are missing.");
            missing_objects_candidate(
                evidence,
                step,
                sentence,
                &[OBJECTS, NEAREST],
                |n| n < first,
            )
        });
        let wrong_orders = wrong_order_candidates(evidence, step);
        one_missing.chain(only_first).chain(only_last).chain(wrong_orders)
    })
}

fn missing_objects_candidate<'a>(
    evidence: &'a Evidence,
    step: Step,
    sentence: String,
    files: &[&'static str],
    is_missing_index: impl Fn(usize) -> bool,
) -> Explanation<'a> {
    let mut scene = scene_of_step(step);
    let mut k = 0;
    scene.objects.retain(|_| {
        k += 1;
        !is_missing_index(k - 1)
    });
    let intensity = intensity_function(step, &scene);
    Explanation::exact(sentence, files, move |pixel| {
        evidence.encode(intensity(&evidence.our_ray(pixel)))
    })
}

/// Explanations, not yet tried: another of the objects that a ray meets is in front.
fn wrong_order_candidates<'a>(
    evidence: &'a Evidence,
    step: Step,
) -> Vec<Explanation<'a>> {
    type Choice = fn(&[(f64, usize)]) -> Option<usize>;
    let choices: [(&str, Choice); 3] = [
        ("the farthest", |hits| hits.last().map(|hit| hit.1)),
        ("the first in the list", |hits| hits.iter().map(|hit| hit.1).min()),
        ("the last in the list", |hits| hits.iter().map(|hit| hit.1).max()),
    ];
    let explanation = |(words, choose): (&str, Choice)| {
        let scene = scene_of_step(step);
        let alone = (0..scene.objects.len()).map(|k| {
            let objects = vec![scene.objects[k]];
            intensity_function(step, &Scene { objects, ..scene.clone() })
        });
        let alone: Vec<_> = alone.collect();
        let sky = intensity_function(Step::Rays, &scene);
        let sentence = format!(
            "Of the objects that a ray meets, {words} is in front, not the nearest."
        );
        Explanation::exact(sentence, &[NEAREST], move |pixel| {
            let ray = evidence.our_ray(pixel);
            let front_object = choose(&hits_nearest_first(&scene, &ray));
            evidence
                .encode(front_object.map_or_else(|| sky(&ray), |k| alone[k](&ray)))
        })
    };
    choices.map(explanation).into()
}

/// Explanations, not yet tried: terms of the light left out or counted twice.
pub(crate) fn missing_or_doubled_term_candidates<'a>(
    evidence: &'a Evidence,
) -> impl Iterator<Item = Explanation<'a>> {
    let step = evidence.step.filter(|step| Step::Diffuse <= *step);
    step.into_iter().flat_map(move |step| {
        let names = term_names(step);
        let choices = 3_u32.pow(names.len() as u32);
        // Each factor is 1, 0 or 2; first those of which few are changed.
        let factors = |choice: u32| -> Vec<f64> {
            let digit = |k: usize| choice / 3_u32.pow(k as u32) % 3;
            (0..names.len()).map(|k| [1.0, 0.0, 2.0][digit(k) as usize]).collect()
        };
        let mut all: Vec<_> = (1..choices).map(factors).collect();
        all.sort_by_key(|factors| {
            factors.iter().filter(|factor| **factor != 1.0).count()
        });
        all.into_iter()
            .map(move |factors| term_factors_candidate(evidence, step, factors))
    })
}

/// How many pixels are asked of a factor before all are.
const FIRST: usize = 8;

/// Explanations, tried in a few pixels: one term, or that of one light, times a factor.
pub(crate) fn scaled_term_candidates<'a>(
    evidence: &'a Evidence,
) -> impl Iterator<Item = Explanation<'a>> {
    let step = evidence.step.filter(|step| Step::Diffuse <= *step);
    step.into_iter().flat_map(move |step| {
        let count = term_names(step).len();
        let groups: &[&[usize]] = match step {
            Step::Phong => &[&[0], &[1, 2], &[3, 4], &[1], &[2], &[3], &[4]],
            _ => &[&[0], &[1, 2], &[1], &[2]],
        };
        let wrong = evidence.wrong_pixels();
        let first: Vec<_> =
            wrong.iter().step_by(wrong.len().div_ceil(FIRST).max(1)).collect();
        groups.iter().flat_map(move |group| {
            let hundredths = (1..=400).map(|k| f64::from(k) / 100.0);
            let parts = [1.0 / 3.0, 2.0 / 3.0, FRAC_1_PI, PI, 5.0, 10.0];
            let numbers = hundredths.chain(parts).filter(|number| *number != 1.0);
            let first = first.clone();
            numbers.filter_map(move |number| {
                let factor = |k| if group.contains(&k) { number } else { 1.0 };
                let factors = (0..count).map(factor).collect();
                let explanation = term_factors_candidate(evidence, step, factors);
                let is_it = first
                    .iter()
                    .all(|pixel| (explanation.colours)(pixel) == [pixel.yours; 2]);
                is_it.then_some(explanation)
            })
        })
    })
}

fn term_names(step: Step) -> Vec<String> {
    let mut names = vec!["the ambient term".to_owned()];
    names.extend(LIGHTS.map(|light| format!("the diffuse term of {light}")));
    if step == Step::Phong {
        names.extend(LIGHTS.map(|light| format!("the specular term of {light}")));
    }
    names
}

/// The scene of a step, with one of its lights alone.
fn scene_with_one_light(step: Step, light_index: usize) -> Scene {
    let mut scene = scene_of_step(step);
    scene.lights = vec![scene.lights[light_index]];
    scene
}

fn term_factors_candidate<'a>(
    evidence: &'a Evidence,
    step: Step,
    factors: Vec<f64>,
) -> Explanation<'a> {
    let names = term_names(step);
    let mut changes: Vec<(f64, Vec<&str>)> = vec![];
    for (name, factor) in
        names.iter().zip(&factors).filter(|(_, factor)| **factor != 1.0)
    {
        match changes.iter_mut().find(|(known, _)| known == factor) {
            Some((_, names)) => names.push(name),
            None => changes.push((*factor, vec![name])),
        }
    }
    let words = changes.iter().map(|(factor, names)| {
        let names = join_with_and(names);
        match factor {
            0.0 => format!("without {names}"),
            2.0 => format!("with {names} twice"),
            factor => {
                format!("with {names} times {}", format_2_decimals_trimmed(*factor))
            }
        }
    });
    let words: Vec<_> = words.collect();
    let sentence = match (&factors[..], step) {
        ([a, b, c, 0.0, 0.0], _) if [*a, *b, *c] == [1.0; 3] => {
            "Your highlights are missing: all but the specular term is right."
                .to_owned()
        }
        ([1.0, rest @ ..], _) if rest.iter().all(|factor| *factor == 0.0) => {
            "Only the ambient term is there: no light falls on anything.".to_owned()
        }
        _ => format!("Your picture is ours {}.", words.join(" and ")),
    };
    let mut files = vec![];
    for (k, factor) in
        factors.iter().enumerate().filter(|(_, factor)| **factor != 1.0)
    {
        let is_whole = [0.0, 2.0].contains(factor);
        let files_of_term: &[_] = match k {
            0 if is_whole => &[AMBIENT],
            0 => &[AMBIENT, "step04_diffuse/scene.rs"],
            1 | 2 if is_whole => &[DIFFUSE],
            1 | 2 => &[
                DIFFUSE,
                "step04_diffuse/light.rs",
                "step04_diffuse/surface_point.rs",
            ],
            _ if is_whole => &[SPECULAR],
            _ => &[SPECULAR, "step05_phong/scene.rs"],
        };
        files.extend(
            files_of_term
                .iter()
                .filter(|file| !files.contains(*file))
                .collect::<Vec<_>>(),
        );
    }
    files.push(match step {
        Step::Phong => "step05_phong/phong.rs",
        _ => "step04_diffuse/picture.rs",
    });
    let scenes = [scene_with_one_light(step, 0), scene_with_one_light(step, 1)];
    let mut explanation = Explanation::exact(sentence, &files, move |pixel| {
        let ray = evidence.our_ray(pixel);
        match sum_scaled_terms(&scenes, &ray, &factors) {
            Some(intensity) => evidence.encode(intensity),
            None => pixel.ours,
        }
    });
    explanation.rays = 2;
    explanation
}

fn sum_scaled_terms(
    scenes: &[Scene; 2],
    ray: &Ray,
    factors: &[f64],
) -> Option<DVec3> {
    let terms_of_light = |k: usize| -> Option<Phong> { terms(&scenes[k], ray) };
    let (warm, cool) = (terms_of_light(0)?, terms_of_light(1)?);
    let mut sum = factors[0] * warm.ambient;
    sum += factors[1] * warm.diffuse + factors[2] * cool.diffuse;
    if let [_, _, _, a, b] = factors {
        sum += *a * warm.specular + *b * cool.specular;
    }
    Some(sum)
}

/// Formats a factor with at most two decimals.
fn format_2_decimals_trimmed(factor: f64) -> String {
    format!("{factor:.2}").trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn join_with_and(names: &[&str]) -> String {
    match names.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
        None => String::new(),
    }
}

/// Explanation: some pixels were never drawn, all of these have one colour.
pub(crate) fn undrawn_pixels_candidate<'a>(
    evidence: &'a Evidence,
) -> Option<Explanation<'a>> {
    let wrong = evidence.wrong_pixels();
    let blank = wrong.first()?.yours;
    if wrong.iter().any(|pixel| pixel.yours != blank) {
        return None;
    }
    let all = evidence.pixels.len();
    let is_black = blank == [0; 3];
    let lines = |line: fn(&Pixel) -> u32| -> BTreeMap<u32, (usize, usize)> {
        let mut counts = BTreeMap::new();
        for pixel in &evidence.pixels {
            let count: &mut (usize, usize) = counts.entry(line(pixel)).or_default();
            count.0 += usize::from(!pixel.is_wrong() && pixel.ours != blank);
            count.1 += usize::from(pixel.is_wrong());
        }
        counts
    };
    let whole_lines = |name: &str, counts: BTreeMap<u32, (usize, usize)>| {
        let is_mixed =
            counts.values().any(|(right, wrong)| 0 < *right && 0 < *wrong);
        let undrawn: Vec<_> = counts
            .iter()
            .filter(|(_, (_, wrong))| 0 < *wrong)
            .map(|(k, _)| *k)
            .collect();
        let is_told = !is_mixed && undrawn.len() < counts.len();
        is_told.then(|| format!("{name} {}", format_line_numbers(&undrawn)))
    };
    let clause = whole_lines("rows", lines(|pixel| pixel.j))
        .or_else(|| whole_lines("columns", lines(|pixel| pixel.i)))
        .or_else(|| {
            let is_told = is_black && are_wrong_pixels_isolated(evidence);
            is_told.then(|| format!("{} of {all} pixels", wrong.len()))
        })?;
    let compared = if evidence.has_all_rows() { "" } else { " of those compared" };
    let [r, g, b] = blank;
    let sentence = format!(
        "Never drawn, it seems: {clause}{compared}, all of them ({r}, {g}, {b}); all others are right."
    );
    Some(Explanation::exact(sentence, &[RENDER], move |pixel| {
        match pixel.is_wrong() {
            true => blank,
            false => pixel.ours,
        }
    }))
}

/// Whether most wrong pixels are alone in their row, in the sky as well.
fn are_wrong_pixels_isolated(evidence: &Evidence) -> bool {
    let wrong: HashSet<_> =
        evidence.wrong_pixels().iter().map(|pixel| (pixel.i, pixel.j)).collect();
    let is_alone = |(i, j): &&(u32, u32)| {
        !wrong.contains(&(i + 1, *j)) && (*i == 0 || !wrong.contains(&(i - 1, *j)))
    };
    let (wrong_sky, _) =
        evidence.count_wrong_and_all(|pixel| pixel.region.object.is_none());
    0 < wrong_sky && wrong.len() < 2 * wrong.iter().filter(is_alone).count()
}

/// 200 to 359, or 1, 3, 5 and so on.
fn format_line_numbers(lines: &[u32]) -> String {
    let (first, last) = (lines[0], lines[lines.len() - 1]);
    match lines {
        [one] => one.to_string(),
        _ if last - first + 1 == lines.len() as u32 => format!("{first} to {last}"),
        [a, b, c, ..] => {
            format!("{a}, {b}, {c} and so on, {} of them", lines.len())
        }
        _ => format!("{first} and {last}"),
    }
}
