use crate::case::Case;
use crate::measure::{
    Stage, Verdict, alternatives, by_one, of_mistakes, pixel, stages_beside,
    together,
};
use crate::{Cause, Found, Options, Step, formula};
use gallery::Parts;
use image::RgbImage;
use std::fmt::Write;

/// The stages of a picture of `step`, and whether one of them is known to be wrong.
pub(crate) struct Told {
    /// A table, and where to look first.
    pub text: String,
    /// Whether the numbers show a stage to be wrong.
    pub is_wrong: bool,
    /// The options that the picture was drawn with, as far as they are known.
    pub options: Options,
}

impl Told {
    /// Measures the picture, unless known mistakes explain it: one, or two that are needed.
    pub fn of(case: &mut Case, step: Step) -> Self {
        let is_two = |found: &Found| 1 < found.causes[0].len();
        let by_one = (case.is_explained()
            && case.found.as_ref().is_some_and(is_two))
        .then(|| by_one(&case.yours.kept, step, &case.ours.picture))
        .flatten();
        // One thing done otherwise is likelier than two known mistakes.
        if by_one.is_some() {
            case.found = None;
        }
        let case = &*case;
        let known = case.found.as_ref().filter(|_| case.is_explained());
        let known = known.filter(|_| !case.is_nearly_right());
        let (stages, options) = match (by_one, known) {
            (Some(by_one), _) => by_one,
            (_, Some(found)) => {
                let cause = found.cause(step);
                let right = Cause { mistakes: vec![], ..cause.clone() };
                let [yours, ours] =
                    [&cause, &right].map(|cause| objects(case, cause));
                let others = others(case, &cause);
                let stages = of_mistakes(
                    &cause,
                    &found.causes,
                    &others,
                    yours.contains(&true),
                    yours == ours,
                    |stage, light| is_shown(case, &cause, stage, light),
                );
                (stages, found.options())
            }
            _ => stages_beside(&case.yours.kept, step, Some(&case.ours.picture)),
        };
        let is_wrong = |stage: &&Stage| matches!(stage.verdict, Verdict::Wrong);
        let wrong = stages.iter().find(is_wrong);
        let mut text = table(&stages);
        text += &wrong.map_or(String::new(), first);
        Self { text, is_wrong: wrong.is_some(), options }
    }
}

/// The likely formulas that give as much as each of the mistakes of a cause.
fn others(case: &Case, cause: &Cause) -> Vec<Vec<formula::Cause>> {
    let Cause { step, samples, fov, .. } = *cause;
    let (yours, ours) = (&case.yours.kept, &case.ours.picture);
    let [one, two] = &cause.mistakes[..] else {
        let options = Options { fov, samples };
        return vec![alternatives(yours, step, &options, ours)];
    };
    let alone = [one, two].map(|mistake| {
        let cause = Cause { mistakes: vec![mistake], ..*cause };
        let picture = cause.parts(case.yours.size).picture(step, 1);
        alternatives(&picture, step, &Options { fov, samples: 1 }, ours)
    });
    together(yours, step, &Options { fov, samples }, alone).into()
}

/// Whether the rays of some pixels meet something.
pub(crate) fn objects(case: &Case, cause: &Cause) -> Vec<bool> {
    let parts = cause.parts(case.yours.size);
    let ray =
        |(i, j): (u32, u32)| (parts.ray)(parts.camera.ray(i.into(), j.into()));
    let rays = case.yours.scattered(2000).into_iter().map(ray);
    rays.map(|ray| parts.seen(cause.step, &ray).is_some()).collect()
}

/// Whether a picture with these mistakes would be another if its lights gave less, or
/// faded more, in this stage.
fn is_shown(case: &Case, cause: &Cause, stage: &str, light: usize) -> bool {
    let parts = cause.parts(case.yours.size);
    let mut other = parts.clone();
    let scene = &mut other.scene;
    match (stage, scene.lights.get_mut(light)) {
        ("ambient", _) => scene.ambient_light *= 0.8,
        ("attenuation", _) => {
            scene
                .lights
                .iter_mut()
                .for_each(|one| one.point_light.attenuation.a *= 1.3);
        }
        ("diffuse", Some(light)) => light.point_light.diffuse *= 0.7,
        ("specular", Some(light)) => light.specular *= 0.7,
        _ => return true,
    }
    let pixel =
        |parts: &Parts, (i, j)| parts.pixel(cause.step, cause.samples, i, j);
    let mut places = case.yours.scattered(2000).into_iter();
    places.any(|at| pixel(&parts, at) != pixel(&other, at))
}

/// One line for each stage, and its numbers below it.
fn table(stages: &[Stage]) -> String {
    if stages.is_empty() {
        return String::new();
    }
    let mut text = "Stage by stage, as far as the picture tells:\n".to_owned();
    let width = stages.iter().map(|stage| stage.name.chars().count()).max();
    let width = width.unwrap_or(0) + 2;
    for Stage { name, verdict, numbers, .. } in stages {
        let verdict = match verdict {
            Verdict::Right => "right",
            Verdict::Wrong => "WRONG",
            Verdict::Unknown(why) => &format!("can't be told: {why}"),
        };
        let _ = writeln!(text, "  {name:width$}{verdict}");
        for number in numbers {
            let _ = writeln!(text, "  {:width$}{number}", "");
        }
    }
    text
}

/// Where to look first.
fn first(stage: &Stage) -> String {
    let Stage { name, section, test, .. } = stage;
    let mut text = format!(
        "Look first at {name}: step {}, \"{}\" ({}), in {}.\n",
        section.step.number(),
        section.heading,
        section.page(),
        section.path(),
    );
    if let Some(test) = test {
        let step = section.step.name();
        let _ = writeln!(
            text,
            "The test {test} of steps/{step}/tests/by_hand.rs has numbers to compare \
             with yours."
        );
    }
    text
}

/// One pixel in full, on lines of its own.
pub(crate) fn one_pixel(
    yours: &RgbImage,
    ours: &RgbImage,
    step: Step,
    options: Options,
) -> String {
    match pixel(yours, ours, step, options).trim_end() {
        "" => String::new(),
        text => format!("{text}\n"),
    }
}
