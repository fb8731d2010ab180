use crate::Step;
use crate::camera_from_sky::clauses_and_count_of_sky;
use crate::evidence::{Evidence, Pixel};
use crate::explanation::{Explanation, RayBudget};
use crate::pixel_regions::Region;
use crate::source_ref::{
    find_source_ref, go_back_sentences, test_command_sentence,
};
use crate::step_scene::{
    LIGHTS, OBJECT_COUNT, hits_nearest_first, intensity_function,
    object_name_with_article, scene_of_step,
};
use glam::DVec3;
use std::collections::BTreeMap;

/// The most regions of which the wrong pixels are told.
const MOST_REGIONS: usize = 3;

/// How far off a pixel of the sky may be that still shows it, in another shade.
const FAINT: u8 = 12;

/// Lines about a picture that nothing explains as a whole: which regions are
/// right, how many pixels of the others are wrong, what explains one of these alone, and the
/// tests by hand of the stages that may be wrong.
pub(crate) fn describe_wrong_regions(
    evidence: &Evidence,
    step: Step,
    budget: &RayBudget,
) -> String {
    let (mut right, mut wrong, mut explained) = (vec![], vec![], vec![]);
    let mut wrong_names = vec![];
    for (name, is_in) in regions_with_names(step) {
        match evidence.count_wrong_and_all(&is_in) {
            (_, 0) => {}
            (0, _) => right.push(name),
            (some, all) => {
                let is_large = 200 <= all;
                wrong.push(format!("{some} of {all} pixels of {name}"));
                let explanation = region_candidates(evidence, step, &name)
                    .into_iter()
                    .find(|one| {
                        is_large && one.holds_in_region(evidence, &is_in, budget)
                    });
                wrong_names.push(name);
                explained.extend(explanation);
            }
        }
    }
    let mut text = String::new();
    if wrong.len() == 1 && !right.is_empty() {
        text += "All regions but one are right in every pixel.\n";
    } else if !right.is_empty() {
        text += &format!("Right in every pixel: {}.\n", right.join(", "));
    }
    let more = wrong.len().saturating_sub(MOST_REGIONS);
    wrong.truncate(MOST_REGIONS);
    let more = if 0 < more { format!("; and {more} more") } else { String::new() };
    text += &format!("Wrong: {}{more}.\n", wrong.join("; "));
    text += &sentence_of_wrong_outlines(evidence, step);
    if let Some((differences, count)) = clauses_and_count_of_sky(evidence, budget) {
        text += &format!(
            "In the {count} pixels of your sky that are far from objects,{differences}\n"
        );
        let places: Vec<_> =
            find_source_ref("step01_rays/camera.rs").into_iter().collect();
        return text + &go_back_sentences(&places);
    }
    explained.truncate(2);
    for one in &explained {
        text += &format!("{}\n", one.sentence);
    }
    let steps = steps_that_may_be_wrong(evidence, step, &wrong_names);
    text + &test_command_sentence(&steps)
}

/// Tells of the outlines: objects that show the sky, and the sky that does not; or of which
/// objects alone there are wrong pixels.
fn sentence_of_wrong_outlines(evidence: &Evidence, step: Step) -> String {
    if step == Step::Rays {
        return String::new();
    }
    let (wrong_sky, sky) =
        evidence.count_wrong_and_all(|pixel| pixel.region.object.is_none());
    if sky < 2 * wrong_sky {
        return String::new();
    }
    let (sky_in_objects, other_in_sky) = count_wrong_outlines(evidence);
    let object_names: Vec<_> = sky_in_objects
        .keys()
        .map(|k| object_name_with_article(step, (*k).into()))
        .collect();
    let object_names = match object_names.len() {
        5.. => format!("{} objects", object_names.len()),
        _ => object_names.join(", "),
    };
    let sky_in_objects: usize = sky_in_objects.values().sum();
    let names = names_of_wrong_objects(evidence, step);
    match (sky_in_objects, other_in_sky, &names[..]) {
        (0, 0, [one]) if 1 < scene_of_step(step).objects.len() => {
            format!(
                "The outlines are right, and of all objects only {one} is wrong.\n"
            )
        }
        (0, 0, _) => {
            let (crowded, all) =
                evidence.count_wrong_and_all(|pixel| pixel.region.is_crowded);
            match crowded == evidence.wrong_pixels().len() {
                true => format!(
                    "All of them are among the {all} pixels where one object hides another.\n"
                ),
                false => "The outlines are right.\n".to_owned(),
            }
        }
        (_, 0, _) => {
            format!("{sky_in_objects} pixels of {object_names} show the sky.\n")
        }
        (0, ..) => format!("{other_in_sky} pixels of the sky do not show it.\n"),
        _ => format!(
            "{sky_in_objects} pixels of {object_names} show the sky, and {other_in_sky} of the sky do not.\n"
        ),
    }
}

/// How many pixels of each object show the sky behind it, and how many of the sky do not.
fn count_wrong_outlines(evidence: &Evidence) -> (BTreeMap<u8, usize>, usize) {
    let sky = intensity_function(Step::Rays, &scene_of_step(Step::Rays));
    let (mut sky_in_objects, mut other_in_sky) = (BTreeMap::new(), 0);
    for pixel in evidence.wrong_pixels() {
        match pixel.region.object {
            None if pixel.largest_channel_difference() <= FAINT => {}
            None => other_in_sky += 1,
            Some(k)
                if evidence.encode(sky(&evidence.our_ray(pixel)))
                    == pixel.yours =>
            {
                *sky_in_objects.entry(k).or_default() += 1;
            }
            Some(_) => {}
        }
    }
    (sky_in_objects, other_in_sky)
}

/// The steps whose stages may be wrong, where these regions are.
fn steps_that_may_be_wrong(
    evidence: &Evidence,
    step: Step,
    wrong_region_names: &[String],
) -> Vec<Step> {
    let (wrong_sky, sky) =
        evidence.count_wrong_and_all(|pixel| pixel.region.object.is_none());
    let (sky_in_objects, other_in_sky) = count_wrong_outlines(evidence);
    let only = |is_one: fn(&str) -> bool| {
        wrong_region_names.iter().all(|name| is_one(name))
    };
    let is_faint = |pixel: &Pixel| {
        pixel.region.object.is_none()
            && pixel.is_wrong()
            && pixel.largest_channel_difference() <= FAINT
    };
    let (faint, _) = evidence.count_wrong_and_all(is_faint);
    let is_one_object =
        names_of_wrong_objects(evidence, step).len() == 1 && Step::Sphere < step;
    let first = if sky < 4 * wrong_sky || wrong_sky < 2 * faint {
        Step::Rays
    } else if 0 < sky_in_objects.len() + other_in_sky {
        // Where the eye is elsewhere, the sky is right.
        if is_one_object { Step::Nearest } else { Step::Rays }
    } else if only(|name| name == "where highlights may be") {
        Step::Phong
    } else if only(|name| name == "what no light reaches") {
        Step::Nearest
    } else {
        Step::Sphere
    };
    Step::ALL.into_iter().filter(|one| first <= *one && *one <= step).collect()
}

/// Explanations, not yet tried, of one region alone.
fn region_candidates<'a>(
    evidence: &'a Evidence,
    step: Step,
    region_name: &str,
) -> Vec<Explanation<'a>> {
    let mut all = vec![];
    let first = evidence.wrong_pixels().first().map_or([0; 3], |pixel| pixel.yours);
    let [r, g, b] = first;
    let sentence =
        format!("In every pixel of {region_name} your colour is ({r}, {g}, {b}).");
    all.push(Explanation::exact(sentence, &[], move |_| first));
    if step < Step::Nearest || region_name == "the sky" {
        return all;
    }
    let scene_of_step = scene_of_step(step);
    let our_intensity = intensity_function(step, &scene_of_step);
    let flat =
        scene_of_step.objects.iter().map(|object| object.material.matte.diffuse);
    let flat: Vec<DVec3> = flat.collect();
    if Step::Diffuse <= step {
        let sentence = format!(
            "In every pixel of {region_name} your colour is that of the object, \
                                without light."
        );
        all.push(Explanation::exact(sentence, &[], move |pixel| {
            let k = pixel.region.object.map_or(0, usize::from);
            evidence.encode(flat[k])
        }));
    }
    all.extend(region_factor_candidate(evidence, region_name, our_intensity));
    if 1 < scene_of_step.objects.len() {
        let sentence = format!(
            "Wherever {region_name} is wrong you see another object that the ray meets, \
             not the nearest."
        );
        let alone = (0..scene_of_step.objects.len()).map(|k| {
            let objects = vec![scene_of_step.objects[k]];
            let scene =
                crate::step_scene::Scene { objects, ..scene_of_step.clone() };
            (object_name_with_article(step, k), intensity_function(step, &scene))
        });
        let alone: Vec<_> = alone.collect();
        let scene = scene_of_step;
        all.push(Explanation::exact(sentence, &[], move |pixel| {
            let ray = evidence.our_ray(pixel);
            let hits = hits_nearest_first(&scene, &ray);
            let colours = hits
                .iter()
                .skip(1)
                .map(|(_, k)| evidence.encode(alone[*k].1(&ray)));
            let mut colours = colours.filter(|colour| *colour == pixel.yours);
            colours.next().unwrap_or(pixel.ours)
        }));
    }
    all
}

/// Explanation, not yet tried: ours times a factor for each channel, fitted in a region.
fn region_factor_candidate<'a>(
    evidence: &'a Evidence,
    region_name: &str,
    our_intensity: Box<dyn Fn(&step01_rays::Ray) -> DVec3>,
) -> Option<Explanation<'a>> {
    let step = evidence.step?;
    let (_, is_in) = regions_with_names(step)
        .into_iter()
        .find(|(name, _)| name == region_name)?;
    let (mut sum, mut count) = (DVec3::ZERO, DVec3::ZERO);
    for pixel in evidence.pixels.iter().filter(|pixel| is_in(pixel)).step_by(2) {
        for k in 0..3 {
            if pixel.yours[k] < 255 && 8 < pixel.ours[k] && pixel.ours[k] < 255 {
                sum[k] += f64::from(pixel.yours[k]) / f64::from(pixel.ours[k]);
                count[k] += 1.0;
            }
        }
    }
    let factor = (0.0 < count.min_element()).then(|| sum / count)?;
    let words = match (factor.max_element() - factor.min_element()) < 0.02 {
        true => format!("{:.2}", factor.element_sum() / 3.0),
        false => format!("({:.2}, {:.2}, {:.2})", factor.x, factor.y, factor.z),
    };
    if words == "1.00" {
        return None;
    }
    let sentence = format!(
        "In every pixel of {region_name} your colour is {words} times ours."
    );
    Some(Explanation::within_one(sentence, &[], move |pixel| {
        evidence.encode(factor * our_intensity(&evidence.our_ray(pixel)))
    }))
}

type InRegion = Box<dyn Fn(&Pixel) -> bool>;

/// The regions of a step, in the order of the stages that draw them, with their names.
pub(crate) fn regions_with_names(step: Step) -> Vec<(String, InRegion)> {
    let mut regions: Vec<(String, InRegion)> = vec![(
        "the sky".to_owned(),
        Box::new(|pixel| pixel.region.object.is_none()),
    )];
    if step < Step::Diffuse {
        let count = if step == Step::Rays { 0 } else { OBJECT_COUNT };
        regions.extend((0..count).filter(|k| step != Step::Sphere || *k == 0).map(
            |k| {
                let is_object: InRegion =
                    Box::new(move |pixel| pixel.region.object == Some(k as u8));
                (object_name_with_article(step, k), is_object)
            },
        ));
        return regions;
    }
    let lit = move |lit: [bool; 2]| -> InRegion {
        Box::new(move |pixel| {
            let Region { object, lit: lit_there, shines, .. } = pixel.region;
            object.is_some() && lit_there == lit && !shines
        })
    };
    let without = if step == Step::Phong { ", without highlights" } else { "" };
    regions.extend([
        ("what no light reaches".to_owned(), lit([false; 2])),
        (format!("what {} alone reaches{without}", LIGHTS[0]), lit([true, false])),
        (format!("what {} alone reaches{without}", LIGHTS[1]), lit([false, true])),
        (format!("what both lights reach{without}"), lit([true; 2])),
    ]);
    if step == Step::Phong {
        regions.push((
            "where highlights may be".to_owned(),
            Box::new(|pixel| pixel.region.shines),
        ));
    }
    regions
}

/// The names of all objects that have a wrong pixel.
fn names_of_wrong_objects(evidence: &Evidence, step: Step) -> Vec<String> {
    let mut is_wrong = [false; OBJECT_COUNT];
    for pixel in evidence.wrong_pixels() {
        if let Some(k) = pixel.region.object {
            is_wrong[usize::from(k)] = true;
        }
    }
    let wrong = (0..OBJECT_COUNT).filter(|k| is_wrong[*k]);
    wrong.map(|k| object_name_with_article(step, k)).collect()
}
