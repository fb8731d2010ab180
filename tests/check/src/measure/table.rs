use super::{Black, Stage, Verdict, number, shown};
use crate::formula::{self, Change, Tree};
use crate::fov::FOV;
use crate::{Cause, Mistake, Options, Section, Step, section};
use image::RgbImage;

/// A line of the table.
#[derive(Debug)]
pub(super) struct Row {
    /// What it is called.
    pub name: &'static str,
    /// The stage that formulas say they belong to.
    pub stage: &'static str,
    /// The light, where each has a line of its own.
    pub light: Option<usize>,
    /// The first step that shows it.
    from: Step,
    section: Section,
    /// The function of `tests/by_hand.rs`.
    test: &'static str,
}

/// All lines, in order.
pub(super) const ROWS: [Row; 13] = [
    Row {
        name: "rays",
        stage: "rays",
        light: None,
        from: Step::Rays,
        section: section::CAMERA,
        test: "direction_of_a_pixel",
    },
    Row {
        name: "sky",
        stage: "sky",
        light: None,
        from: Step::Rays,
        section: section::DIRECTIONS,
        test: "colour_of_a_pixel",
    },
    Row {
        name: "outlines",
        stage: "outlines",
        light: None,
        from: Step::Sphere,
        section: section::MEETING,
        test: "coefficients_of_a_pixel",
    },
    Row {
        name: "nearest",
        stage: "nearest",
        light: None,
        from: Step::Nearest,
        section: section::NEAREST,
        test: "nearest_in_a_crowd",
    },
    Row {
        name: "point and normal",
        stage: "point",
        light: None,
        from: Step::Diffuse,
        section: section::NORMAL,
        test: "normal_of_a_pixel",
    },
    Row {
        name: "colours",
        stage: "colours",
        light: None,
        from: Step::Sphere,
        section: section::SCENE,
        test: "sum_of_a_pixel",
    },
    Row {
        name: "ambient",
        stage: "ambient",
        light: None,
        from: Step::Diffuse,
        section: section::AMBIENT,
        test: "sum_of_a_pixel",
    },
    Row {
        name: "diffuse, warm",
        stage: "diffuse",
        light: Some(0),
        from: Step::Diffuse,
        section: section::DIFFUSE,
        test: "lights_of_a_pixel",
    },
    Row {
        name: "diffuse, cool",
        stage: "diffuse",
        light: Some(1),
        from: Step::Diffuse,
        section: section::DIFFUSE,
        test: "lights_of_a_pixel",
    },
    Row {
        name: "attenuation",
        stage: "attenuation",
        light: None,
        from: Step::Diffuse,
        section: section::ATTENUATION,
        test: "lights_of_a_pixel",
    },
    Row {
        name: "specular, warm",
        stage: "specular",
        light: Some(0),
        from: Step::Phong,
        section: section::SPECULAR,
        test: "terms_of_a_pixel",
    },
    Row {
        name: "specular, cool",
        stage: "specular",
        light: Some(1),
        from: Step::Phong,
        section: section::SPECULAR,
        test: "terms_of_a_pixel",
    },
    Row {
        name: "sum, bytes, order",
        stage: "sum",
        light: None,
        from: Step::Rays,
        section: section::BYTES,
        test: "colour_of_a_pixel",
    },
];

/// All lines of a step, each with this verdict.
pub(super) fn blank(step: Step, verdict: impl Fn(&Row) -> Verdict) -> Vec<Stage> {
    let its = ROWS.iter().filter(|row| row.from <= step);
    its.map(|row| Stage {
        name: row.name,
        verdict: verdict(row),
        numbers: vec![],
        section: row.section,
        test: Some(row.test),
    })
    .collect()
}

/// The row of a stage of the table.
pub(super) fn row(stage: &Stage) -> &'static Row {
    ROWS.iter().find(|row| row.name == stage.name).unwrap_or(&ROWS[0])
}

/// Whether a thing is of a line of the table.
fn is_of(cause: &formula::Cause, row: &Row) -> bool {
    let stage = match (cause.place.stage, cause.step) {
        // One sphere is always the nearest.
        ("nearest", Step::Sphere) => "outlines",
        (stage, _) => stage,
    };
    stage == row.stage
        && (row.light.is_none() || cause.light.is_none_or(|k| row.light == Some(k)))
}

/// The table of a picture of which every pixel is explained.
pub(super) fn explained(
    view: &Options,
    right: &Tree,
    yours: &RgbImage,
    groups: &[Vec<formula::Cause>],
) -> Vec<Stage> {
    let changes: Vec<_> =
        groups.iter().flat_map(|group| group[0].changes.iter().cloned()).collect();
    let tree = right.with(&changes);
    let mut stages =
        blank(tree.step, |row| shown::verdict(&tree, row, view, yours));
    let looked_at = match view.is_whole(yours) {
        true => "",
        false => " that was looked at",
    };
    for group in groups {
        tell(&mut stages, group, looked_at);
        tell_point(&mut stages, group, &tree);
    }
    let is_hit = |tree: &Tree| shown::hits(tree, yours);
    doubt_outlines(&mut stages, || is_hit(&tree) != is_hit(right));
    tell_fov(&mut stages, view.fov);
    stages
}

/// No outlines are right where what is wrong at nearest makes other pixels hits.
fn doubt_outlines(stages: &mut [Stage], is_other: impl FnOnce() -> bool) {
    let is = |stage: &Stage, name: &str, verdict: &Verdict| {
        stage.name == name && stage.verdict == *verdict
    };
    let is_near = stages.iter().any(|s| is(s, "nearest", &Verdict::Wrong));
    let outlines = stages.iter_mut().find(|s| is(s, "outlines", &Verdict::Right));
    if let Some(outlines) = outlines.filter(|_| is_near && is_other()) {
        let why = "what is told at nearest changes them, too";
        outlines.verdict = Verdict::Unknown(why.to_owned());
    }
}

/// Tells that right rays are those of a field of view that is not the course's.
fn tell_fov(stages: &mut [Stage], fov: f64) {
    if fov != FOV && stages[0].verdict == Verdict::Right {
        let why = format!(
            "it is the camera of `--fov {}`; if you gave no such option, look at θ",
            number(fov)
        );
        stages[0].verdict = Verdict::Unknown(why);
    }
}

/// Tells one thing, and what explains as much.
fn tell(stages: &mut [Stage], group: &[formula::Cause], looked_at: &str) {
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
        stage.numbers.push(format!("in every pixel{looked_at}, {}", first.told));
        for other in group.iter().skip(1).take(4) {
            stage.numbers.push(format!("or else {}", other.told));
        }
        stage.numbers.extend(match group.len().saturating_sub(5) {
            0 => None,
            1 => Some("or else another one, which is alike".to_owned()),
            more => Some(format!("or else one of {more} others, which are alike")),
        });
    }
    let others: Vec<_> = group.iter().skip(1).collect();
    doubt(stages, &others, name.unwrap_or_default());
}

/// No stage is right that other things are in which explain as much as one in `name`.
fn doubt(stages: &mut [Stage], others: &[&formula::Cause], name: &str) {
    for other in others {
        for stage in stages.iter_mut().filter(|stage| is_of(other, row(stage))) {
            if stage.verdict == Verdict::Right {
                let why = format!(
                    "either it or {name} is wrong, and both give this picture"
                );
                stage.verdict = Verdict::Unknown(why);
            }
        }
    }
}

/// Tells that p may be wrong, too, where t is: p = S + t V.
fn tell_point(stages: &mut [Stage], group: &[formula::Cause], tree: &Tree) {
    let is_t = |change: &Change| match change {
        Change::Line(line, _) => {
            ["t", "t'", "t_1", "t_2"].contains(&&*tree.lines[*line].name)
        }
        _ => false,
    };
    let is_wrong = |cause: &formula::Cause| cause.changes.iter().any(is_t);
    if !group.first().is_some_and(is_wrong) || tree.step <= Step::Nearest {
        return;
    }
    unknown_point(stages);
    let is_told = group.iter().any(|cause| cause.place.stage == "point");
    for stage in stages.iter_mut().filter(|s| s.name == "nearest" && !is_told) {
        stage.numbers.push(POINT.to_owned());
    }
}

/// What else may be wrong where t seems to be.
const POINT: &str = "or else t is right and the point p = S + t V or its n is not";

/// A right point is one that can't be told, for a wrong t gives the same picture.
fn unknown_point(stages: &mut [Stage]) {
    for point in stages.iter_mut().filter(|s| s.name == "point and normal") {
        if point.verdict == Verdict::Right {
            let why = "a wrong t gives the same picture as a wrong p";
            point.verdict = Verdict::Unknown(why.to_owned());
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
/// The first list is told; each of the others explains as much, and so do some formulas of
/// each of its mistakes, which are told where they lead to another file. Whether it has an
/// object at all, whether the right pixels see one, and whether a light's part of the light
/// is seen, is known.
pub(crate) fn of_mistakes(
    &Cause { step, fov, .. }: &Cause,
    causes: &[Vec<&Mistake>],
    formulas: &[Vec<formula::Cause>],
    has_objects: bool,
    has_outlines: bool,
    is_shown: impl Fn(&str, usize) -> bool,
) -> Vec<Stage> {
    let mut stages = blank(step, |row| match row.stage {
        "rays" | "sky" | "outlines" | "sum" => Verdict::Right,
        _ if has_objects => Verdict::Right,
        _ => Verdict::Unknown("no object is seen".to_owned()),
    });
    let (first, others) =
        causes.split_first().map_or((&[][..], &[][..]), |(a, b)| (&a[..], b));
    for mistake in others.iter().flatten() {
        for its in stages
            .iter_mut()
            .filter(|its| row(its).stage == stage_of(step, mistake, has_outlines))
        {
            let why = "it may be what is wrong, as is told above".to_owned();
            its.verdict = Verdict::Unknown(why);
        }
    }
    let is_told = |path: &str| {
        causes.iter().flatten().any(|mistake| mistake.section.path() == path)
    };
    let mut doubts = vec![];
    for (which, mistake) in first.iter().enumerate() {
        let stage = stage_of(step, mistake, has_outlines);
        let is_other = |one: &&formula::Cause| !is_told(&one.place.section.path());
        let others = formulas.get(which).into_iter().flatten().filter(is_other);
        let others: Vec<_> = others.take(4).collect();
        for (k, its) in
            stages.iter_mut().filter(|its| row(its).stage == stage).enumerate()
        {
            (its.verdict, its.section) = (Verdict::Wrong, mistake.section);
            if k == 0 {
                its.numbers
                    .push(format!("it is what you get when {}", mistake.when));
                let told =
                    others.iter().map(|other| format!("or else {}", other.told));
                its.numbers.extend(told);
                doubts.push((others.clone(), its.name));
            } else {
                its.numbers.push("as the warm light's".to_owned());
            }
            if stage == "nearest" && Step::Nearest < step {
                its.numbers.push(POINT.to_owned());
            }
        }
    }
    for (others, name) in doubts {
        doubt(&mut stages, &others, name);
    }
    let is_t = |s: &Stage| s.name == "nearest" && s.verdict == Verdict::Wrong;
    if stages.iter().any(is_t) {
        unknown_point(&mut stages);
    }
    doubt_outlines(&mut stages, || !has_outlines);
    let is_hidden = |its: &&mut Stage| {
        let Row { stage, light, .. } = row(its);
        its.verdict == Verdict::Right && !is_shown(stage, light.unwrap_or(0))
    };
    for its in stages.iter_mut().filter(is_hidden) {
        its.verdict = shown::hidden();
    }
    tell_fov(&mut stages, fov);
    stages
}
