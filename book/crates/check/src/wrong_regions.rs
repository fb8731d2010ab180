use crate::evidence::{Evidence, Pixel};
use crate::pixel_regions::Region;
use crate::source_ref::test_command_sentence;
use crate::step_scene::{
    ENCODE, LIGHTS, OBJECT_COUNT, intensity_function, object_name_with_article, scene_of_step,
};
use course::Step;

/// The most regions of which the wrong pixels are told.
const MOST_REGIONS: usize = 3;

/// Lines about a picture that nothing explains: which regions are right, how many pixels of
/// the others are wrong, and the tests by hand.
pub(crate) fn describe_wrong_regions(evidence: &Evidence, step: Step) -> String {
    let (mut right, mut wrong) = (vec![], vec![]);
    for (name, is_in) in named_regions(step) {
        match evidence.count_wrong_and_all(is_in) {
            (_, 0) => {}
            (0, _) => right.push(name),
            (some, all) => wrong.push(format!("{some} of {all} pixels of {name}")),
        }
    }
    let mut text = String::new();
    if wrong.len() == 1 && !right.is_empty() {
        text += "All regions but one are right in every pixel.\n";
    } else if !right.is_empty() {
        text += &format!("Right in every pixel: {}.\n", right.join(", "));
    }
    let more = match wrong.len().saturating_sub(MOST_REGIONS) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    wrong.truncate(MOST_REGIONS);
    text += &format!("Wrong: {}{more}.\n", wrong.join("; "));
    if Step::Nearest < step {
        text += &sentence_of_wrong_objects(evidence, step);
    }
    let sky = intensity_function(Step::Rays, &scene_of_step(Step::Rays));
    let shows_sky =
        |pixel: &&Pixel| !pixel.is_sky() && ENCODE(sky(&evidence.our_ray(pixel))) == pixel.yours;
    match evidence.wrong_pixels().iter().filter(shows_sky).count() {
        0 => {}
        count => text += &format!("{count} pixels of objects show the sky.\n"),
    }
    let steps = Step::ALL.into_iter().filter(|one| *one <= step);
    text + &test_command_sentence(&steps.collect::<Vec<_>>())
}

/// Tells which objects alone have wrong pixels, where these are few.
fn sentence_of_wrong_objects(evidence: &Evidence, step: Step) -> String {
    let is_wrong = |k: &usize| {
        let objects = evidence.wrong_pixels().iter().map(|one| one.region.object);
        objects.flatten().any(|object| usize::from(object) == *k)
    };
    let names: Vec<_> =
        (0..OBJECT_COUNT).filter(is_wrong).map(|k| object_name_with_article(step, k)).collect();
    match names.len() {
        1..=3 => format!("Of the objects, only these have wrong pixels: {}.\n", names.join(", ")),
        _ => String::new(),
    }
}

type InRegion = Box<dyn Fn(&Pixel) -> bool>;

/// The regions of a step, in the order of the stages that draw them, with their names.
fn named_regions(step: Step) -> Vec<(String, InRegion)> {
    let mut regions: Vec<(String, InRegion)> =
        vec![("the sky".to_owned(), Box::new(Pixel::is_sky))];
    if step < Step::Diffuse {
        regions.extend((0..scene_of_step(step).objects.len()).map(|k| {
            let is_object: InRegion = Box::new(move |pixel| pixel.region.object == Some(k as u8));
            (object_name_with_article(step, k), is_object)
        }));
        return regions;
    }
    let lit = move |lit: [bool; 2]| -> InRegion {
        Box::new(move |pixel| {
            let Region { object, lit: lit_there, in_highlight } = pixel.region;
            object.is_some() && lit_there == lit && !in_highlight
        })
    };
    let without = if step == Step::Phong { ", without highlights" } else { "" };
    regions.extend([
        ("what no light reaches".to_owned(), lit([false; 2])),
        (format!("what {} alone reaches{without}", LIGHTS[0]), lit([true, false])),
        (format!("what {} alone reaches{without}", LIGHTS[1]), lit([false, true])),
        (format!("what both lights reach{without}"), lit([true; 2])),
        ("where highlights may be".to_owned(), Box::new(|pixel| pixel.region.in_highlight)),
    ]);
    regions
}
