use super::view::{Black, View};
use super::{Stage, Verdict, number, shown};
use crate::formula::{Cause, Tree};
use crate::fov::FOV;
use crate::{Mistake, Section, Step, section};
use image::RgbImage;

/// A line of the table: its name, the stage of the formulas, which light, from which
/// step on, where to look, and the test by hand.
pub(super) type Row =
    (&'static str, &'static str, Option<usize>, Step, Section, &'static str);

/// All lines, in order.
pub(super) const ROWS: [Row; 13] = [
    ("rays", "rays", None, Step::Rays, section::CAMERA, "direction_of_a_pixel"),
    ("sky", "sky", None, Step::Rays, section::DIRECTIONS, "colour_of_a_pixel"),
    (
        "outlines",
        "outlines",
        None,
        Step::Sphere,
        section::MEETING,
        "coefficients_of_a_pixel",
    ),
    (
        "nearest",
        "nearest",
        None,
        Step::Nearest,
        section::NEAREST,
        "nearest_in_a_crowd",
    ),
    (
        "point and normal",
        "point",
        None,
        Step::Diffuse,
        section::NORMAL,
        "normal_of_a_pixel",
    ),
    ("colours", "colours", None, Step::Sphere, section::SCENE, "sum_of_a_pixel"),
    ("ambient", "ambient", None, Step::Diffuse, section::AMBIENT, "sum_of_a_pixel"),
    (
        "diffuse, warm",
        "diffuse",
        Some(0),
        Step::Diffuse,
        section::DIFFUSE,
        "lights_of_a_pixel",
    ),
    (
        "diffuse, cool",
        "diffuse",
        Some(1),
        Step::Diffuse,
        section::DIFFUSE,
        "lights_of_a_pixel",
    ),
    (
        "attenuation",
        "attenuation",
        None,
        Step::Diffuse,
        section::ATTENUATION,
        "lights_of_a_pixel",
    ),
    (
        "specular, warm",
        "specular",
        Some(0),
        Step::Phong,
        section::SPECULAR,
        "terms_of_a_pixel",
    ),
    (
        "specular, cool",
        "specular",
        Some(1),
        Step::Phong,
        section::SPECULAR,
        "terms_of_a_pixel",
    ),
    (
        "sum, bytes, order",
        "sum",
        None,
        Step::Rays,
        section::BYTES,
        "colour_of_a_pixel",
    ),
];

/// All lines of a step, each with this verdict.
pub(super) fn blank(step: Step, verdict: impl Fn(&Row) -> Verdict) -> Vec<Stage> {
    let its = ROWS.iter().filter(|row| row.3 <= step);
    its.map(|row| Stage {
        name: row.0,
        verdict: verdict(row),
        numbers: vec![],
        section: row.4,
        test: Some(row.5),
    })
    .collect()
}

/// The row of a stage of the table.
pub(super) fn row(stage: &Stage) -> &'static Row {
    ROWS.iter().find(|row| row.0 == stage.name).unwrap_or(&ROWS[0])
}

/// Whether a thing is of a line of the table.
fn is_of(cause: &Cause, row: &Row) -> bool {
    let stage = match (cause.place.stage, cause.step) {
        // One sphere is always the nearest.
        ("nearest", Step::Sphere) => "outlines",
        (stage, _) => stage,
    };
    stage == row.1
        && (row.2.is_none() || cause.light.is_none_or(|k| row.2 == Some(k)))
}

/// The table of a picture of which every pixel is explained.
pub(super) fn explained(
    view: &View,
    tree: &Tree,
    yours: &RgbImage,
    groups: &[Vec<Cause>],
) -> Vec<Stage> {
    let changes: Vec<_> =
        groups.iter().flat_map(|group| group[0].changes.iter().cloned()).collect();
    let tree = tree.with(&changes);
    let mut stages =
        blank(tree.step, |row| shown::verdict(&tree, row, view, yours));
    for group in groups {
        tell(&mut stages, group);
    }
    if view.fov != FOV && stages[0].verdict == Verdict::Right {
        let why = format!(
            "it is the camera of `--fov {}`; if you gave no such option, look at θ",
            number(view.fov)
        );
        stages[0].verdict = Verdict::Unknown(why);
    }
    stages
}

/// Tells one thing, and what explains as much.
fn tell(stages: &mut [Stage], group: &[Cause]) {
    let Some(first) = group.first() else { return };
    let mut is_told = false;
    let name = stages.iter().find(|stage| is_of(first, row(stage))).map(|s| s.name);
    for stage in stages.iter_mut().filter(|stage| is_of(first, row(stage))) {
        (stage.verdict, stage.section) = (Verdict::Wrong, first.place.section);
        stage.test =
            Some(first.place.test).filter(|test| !test.is_empty()).or(stage.test);
        if is_told {
            stage.numbers.push("as the warm light's".to_owned());
            continue;
        }
        is_told = true;
        stage.numbers.push(format!("in every pixel, {}", first.told));
        for other in group.iter().skip(1).take(4) {
            stage.numbers.push(format!("or else {}", other.told));
        }
        if let more @ 1.. = group.len().saturating_sub(5) {
            stage
                .numbers
                .push(format!("or else one of {more} others, which are alike"));
        }
    }
    for other in group.iter().skip(1) {
        for stage in stages.iter_mut().filter(|stage| is_of(other, row(stage))) {
            if stage.verdict == Verdict::Right {
                let why = format!(
                    "either it or {} is wrong, and both give this picture",
                    name.unwrap_or_default()
                );
                stage.verdict = Verdict::Unknown(why);
            }
        }
    }
}

/// Tells of a black column or row.
pub(super) fn add_black(stages: &mut [Stage], black: &Black) {
    if let Some(last) = stages.last_mut() {
        last.verdict = Verdict::Wrong;
        last.section = section::RENDER;
        last.numbers.push(black.told.clone());
    }
}

/// The stage that a known mistake belongs to.
fn stage_of(step: Step, mistake: &Mistake, has_outlines: bool) -> &'static str {
    use section::*;
    match mistake.section {
        ROOT | NEAREST if step == Step::Sphere => "outlines",
        RAY => "point",
        CAMERA | PROGRAM | RENDER => "rays",
        DIRECTIONS => "sky",
        MEETING | FORMULA | CENTRE if has_outlines && step != Step::Sphere => {
            "nearest"
        }
        MEETING | FORMULA | CENTRE => "outlines",
        ROOT | NEAREST => "nearest",
        ONE_COLOUR | SCENE | FLAT => "colours",
        NORMAL => "point",
        AMBIENT | SURFACE => "ambient",
        ATTENUATION => "attenuation",
        LIGHTS if mistake.when.contains("ambient") => "ambient",
        LAMBERT | LIGHT | DIFFUSE | LIGHTS | LAMPS => "diffuse",
        REFLECT | SPECULAR | MATERIALS | EYE | SUM => "specular",
        _ => "sum",
    }
}

/// The table of a picture of which known mistakes explain every pixel: they know their
/// stages. The others are right where the picture shows them.
///
/// The first list is told; each of the others explains as much. Whether it has an object
/// at all, and whether the right pixels see one, is known.
pub(crate) fn of_mistakes(
    step: Step,
    causes: &[Vec<&Mistake>],
    has_objects: bool,
    has_outlines: bool,
) -> Vec<Stage> {
    let mut stages = blank(step, |row| match row.1 {
        "rays" | "sky" | "outlines" | "sum" => Verdict::Right,
        _ if has_objects => Verdict::Right,
        _ => Verdict::Unknown("no object is seen".to_owned()),
    });
    let (first, others) =
        causes.split_first().map_or((&[][..], &[][..]), |(a, b)| (&a[..], b));
    for mistake in others.iter().flatten() {
        for its in stages
            .iter_mut()
            .filter(|its| row(its).1 == stage_of(step, mistake, has_outlines))
        {
            let why = "it may be what is wrong, as is told above".to_owned();
            its.verdict = Verdict::Unknown(why);
        }
    }
    for mistake in first {
        let stage = stage_of(step, mistake, has_outlines);
        for (k, its) in
            stages.iter_mut().filter(|its| row(its).1 == stage).enumerate()
        {
            (its.verdict, its.section) = (Verdict::Wrong, mistake.section);
            let told = format!("it is what you get when {}", mistake.when);
            its.numbers.push(if k == 0 {
                told
            } else {
                "as the warm light's".to_owned()
            });
            if stage == "nearest" && Step::Nearest < step {
                let told =
                    "or else t is right and the point p = S + t V or its n is not";
                its.numbers.push(told.to_owned());
            }
        }
    }
    let is_t = |s: &Stage| s.name == "nearest" && s.verdict == Verdict::Wrong;
    if stages.iter().any(is_t) {
        for point in stages.iter_mut().filter(|s| s.name == "point and normal") {
            let why = "a wrong t gives the same picture as a wrong p";
            point.verdict = Verdict::Unknown(why.to_owned());
        }
    }
    stages
}
