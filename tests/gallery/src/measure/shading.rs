use super::knobs::{self, Knob, Turned};
use super::light::{ONCE, Sample};
use super::local::{self, Local};
use super::words::{percent, times, vector};
use super::{Alternative, Fit, Look, Place, Stage, Verdict, alternatives, classes};
use crate::difference::apart;
use crate::section::{self, Section};
use crate::{Parts, Step};
use glam::DVec3;

/// What draws the light of a picture, as far as it is known.
struct Shading {
    /// What is not right in it.
    wrong: Vec<Alternative>,
    /// What explains as much.
    equal: Vec<Alternative>,
    /// A number of the scene that is another one, and what is told of it.
    turned: Option<(Turned, String)>,
    /// What is wrong with single objects.
    local: Local,
    fit: Fit,
    /// How many pixels were looked at.
    all: usize,
    /// Whether some object is explained less than others.
    is_uneven: bool,
    /// Whether a few pixels may be off, as what is known draws them a little otherwise.
    is_loose: bool,
}

impl Shading {
    fn share(&self) -> f64 {
        self.fit.explained as f64 / self.all.max(1) as f64
    }

    /// How much of the picture is explained, in words.
    fn told(&self) -> String {
        percent(self.fit.explained, self.all)
    }

    /// What is wrong in one of the sections, as sentences.
    fn faults(&self, sections: &[Section]) -> Vec<String> {
        let is_its = |a: &&Alternative| sections.contains(&a.section);
        let its = self.wrong.iter().filter(is_its);
        let mut faults: Vec<_> =
            its.map(|a| format!("it is what you get when {}", a.when)).collect();
        let last = self.wrong.last().filter(is_its);
        for other in last.iter().flat_map(|_| self.equal.iter().take(3)) {
            faults.push(format!("you get the same when {}", other.when));
        }
        faults
    }

    /// The verdict on a stage with these faults.
    fn verdict(&self, faults: &[String]) -> Verdict {
        let is_found = !self.wrong.is_empty() || 0 < self.fit.strangeness();
        let least = if is_found || self.is_loose { 0.98 } else { 1.0 };
        match self.share() {
            share if share < 0.97 => self.unexplained(),
            _ if !faults.is_empty() => Verdict::Wrong,
            share if least <= share && !self.is_uneven => Verdict::Right,
            _ => self.unexplained(),
        }
    }

    fn unexplained(&self) -> Verdict {
        if self.all == 0 {
            return Verdict::Unknown(
                "no object is seen as it should be".to_owned(),
            );
        }
        let told = self.told();
        Verdict::Unknown(format!("only {told} of the pixels are explained so far"))
    }
}

/// The names of the five parts, their sections and tests, and what their light is called.
const STAGES: [(&str, Section, &str, &str); 5] = [
    ("ambient", section::AMBIENT, "sum_of_a_pixel", "the ambient light's L_a"),
    (
        "diffuse, warm",
        section::DIFFUSE,
        "lights_of_a_pixel",
        "the warm light's L_d",
    ),
    (
        "specular, warm",
        section::SPECULAR,
        "terms_of_a_pixel",
        "the warm light's L_s",
    ),
    (
        "diffuse, cool",
        section::DIFFUSE,
        "lights_of_a_pixel",
        "the cool light's L_d",
    ),
    (
        "specular, cool",
        section::SPECULAR,
        "terms_of_a_pixel",
        "the cool light's L_s",
    ),
];

/// Whose alternatives belong to the point and its normal.
const POINT: &[Section] = &[
    section::RAY,
    section::MEETING,
    section::FORMULA,
    section::CENTRE,
    section::ROOT,
    section::NORMAL,
];

/// Whose alternatives belong to each of the five parts.
fn sections(k: usize) -> &'static [Section] {
    match k {
        0 => &[section::AMBIENT],
        1 | 3 => {
            &[section::DIFFUSE, section::LAMBERT, section::LIGHT, section::LIGHTS]
        }
        _ => &[section::SPECULAR, section::REFLECT, section::EYE, section::SUM],
    }
}

/// The stages from the nearest hit to the highlights.
pub(super) fn stages(look: &mut Look, places: &[Place]) -> Vec<Stage> {
    let shading = search(look, places);
    let stage = |name, sections: &[Section], test, more: Vec<String>| {
        let mut numbers = shading.faults(sections);
        numbers.extend(more);
        let verdict = shading.verdict(&numbers);
        let its = shading.wrong.iter().find(|a| sections.contains(&a.section));
        let section = its.map_or(sections[sections.len() - 1], |a| a.section);
        Stage { name, verdict, numbers, section, test: Some(test) }
    };
    let turned = |is_its: fn(&Knob) -> bool| -> Vec<String> {
        let its = shading.turned.iter().filter(|(turned, _)| is_its(&turned.knob));
        its.map(|(_, told)| told.clone()).collect()
    };
    let shapes = turned(|knob| matches!(knob, Knob::Centre(..) | Knob::Radius(_)));
    let fades = turned(|knob| matches!(knob, Knob::Fade(..)));
    let mut stages = vec![
        stage("nearest", &[section::NEAREST], "nearest_in_a_crowd", vec![]),
        stage("point and normal", POINT, "normal_of_a_pixel", shapes),
        stage(
            "colours",
            &[section::SCENE],
            "sum_of_a_pixel",
            shading.local.colours.clone(),
        ),
    ];
    stages.extend([0, 1, 3].map(|k| weighted(look, &shading, k)));
    stages.push(stage(
        "attenuation",
        &[section::ATTENUATION],
        "lights_of_a_pixel",
        fades,
    ));
    if look.step == Step::Phong {
        stages.extend([2, 4].map(|k| weighted(look, &shading, k)));
    }
    for stage in &mut stages {
        if matches!(stage.verdict, Verdict::Unknown(_)) {
            stage.numbers.clear();
        }
    }
    doubt(&shading, &mut stages);
    if shading.share() < 0.97 && look.has_shapes {
        let samples = samples(look, &look.theirs, &lit(look, places), &[]);
        classes::tell(&samples, near(look), &mut stages);
    }
    stages
}

/// Where one thing explains as much as another of a later stage, neither is known.
fn doubt(shading: &Shading, stages: &mut [Stage]) {
    let Some(last) = shading.wrong.last() else { return };
    let group = |s: Section| match s {
        s if POINT.contains(&s) => 0,
        section::NEAREST => 1,
        section::AMBIENT => 2,
        section::ATTENUATION => 3,
        s if sections(1).contains(&s) => 4,
        _ => 5,
    };
    let others: Vec<_> = shading.equal.iter().map(|a| a.section).collect();
    if others.iter().all(|s| group(*s) == group(last.section)) {
        return;
    }
    let all = [&[*last], &shading.equal[..]].concat();
    let whens: Vec<_> = all.iter().map(|a| a.when).collect();
    let told = format!("this is what you get when {}", whens.join("; or when "));
    for stage in stages {
        let its = |s: Section| match stage.name {
            "point and normal" => group(s) == 0,
            "nearest" => group(s) == 1,
            "ambient" => group(s) == 2,
            "attenuation" => group(s) == 3,
            name if name.starts_with("diffuse") => group(s) == 4,
            name if name.starts_with("specular") => group(s) == 5,
            _ => false,
        };
        if all.iter().any(|a| its(a.section)) && 0.97 < shading.share() {
            let why = "one of two stages is wrong, and both give this picture";
            stage.verdict = Verdict::Unknown(why.to_owned());
            stage.numbers = vec![told.clone()];
        }
    }
}

/// Some places on objects, away from all edges; half of them are not as they should be,
/// if so many are not.
fn lit(look: &Look, places: &[Place]) -> Vec<Place> {
    let is_lit = |p: &&Place| p.hit.is_some() && !p.is_sky;
    let (wrong, right): (Vec<_>, Vec<_>) =
        places.iter().filter(is_lit).partition(|p| !is_right(look, p));
    let few = |all: Vec<&Place>| -> Vec<Place> {
        let few = all.iter().step_by(all.len() / 800 + 1);
        few.filter(|p| !look.is_edge(p.i, p.j)).map(|p| **p).collect()
    };
    // Those of small objects, too.
    let small = |k: usize| {
        let its: Vec<_> =
            places.iter().filter(is_lit).filter(|p| p.hit == Some(k)).collect();
        let few = its.iter().step_by(its.len() / 40 + 1);
        let few = few.filter(|p| !look.is_edge(p.i, p.j));
        few.map(|p| **p).collect::<Vec<_>>()
    };
    let small = (0..look.theirs.objects(look.step).len()).flat_map(small).collect();
    [few(right), few(wrong), small].concat()
}

/// Whether a pixel is what the right light makes of it.
fn is_right(look: &Look, p: &Place) -> bool {
    let ours = look.bytes.write(look.theirs.intensity(look.step, p.i, p.j));
    let apart = apart(look.yours.get_pixel(p.i, p.j), &ours);
    apart <= u8::from(look.is_loose())
}

/// How many bytes an explained pixel may be off.
pub(super) fn near(look: &Look) -> f64 {
    if look.is_loose() { 1.6 } else { 0.6 }
}

/// The parts of the light at some places.
pub(super) fn samples(
    look: &Look,
    parts: &Parts,
    places: &[Place],
    wrong: &[Alternative],
) -> Vec<Sample> {
    let sample = |p: &Place| {
        let pixel = look.yours.get_pixel(p.i, p.j);
        Sample::of(parts, look.step, &look.bytes, pixel, (p.i, p.j), wrong)
    };
    places.iter().filter_map(sample).collect()
}

fn fitted(look: &Look, places: &[Place], wrong: &[Alternative]) -> Fit {
    let mut parts = look.theirs.clone();
    wrong.iter().for_each(|one| (one.change)(&mut parts));
    Fit::of(&samples(look, &parts, places, wrong), near(look))
}

/// The parts that explain most, with as little wrong as possible.
fn search(look: &mut Look, places: &[Place]) -> Shading {
    let lit = lit(look, places);
    let fit = fitted(look, &lit, &[]);
    let mut shading = Shading {
        wrong: vec![],
        equal: vec![],
        turned: None,
        local: Local::default(),
        fit,
        all: lit.len(),
        is_uneven: false,
        is_loose: look.is_loose(),
    };
    if 1 < look.samples && is_same(look, &lit) {
        shading.fit = Fit { weights: ONCE, explained: lit.len(), ..shading.fit };
        return shading;
    }
    shading.is_uneven = is_uneven(look, &lit, &shading);
    if shading.is_uneven && 0.9 < shading.share() {
        weigh(look, &lit, &mut shading);
    }
    if lit.is_empty() || 0.985 < shading.share() {
        return shading;
    }
    for other in std::mem::take(&mut look.others) {
        let old = std::mem::replace(&mut look.theirs, other);
        let fit = fitted(look, &lit, &[]);
        match shading.fit.explained < fit.explained {
            true => shading.fit = fit,
            false => look.theirs = old,
        }
    }
    if 0.985 < shading.share() {
        return shading;
    }
    let before = look.theirs.clone();
    shading.local = local::mend(look, &lit);
    shading.fit = fitted(look, &lit, &[]);
    if shading.share() < 0.9 && !shading.local.colours.is_empty() {
        look.theirs = before;
        shading.local = Local::default();
        shading.fit = fit;
    }
    for _ in 0..2 {
        if 0.985 < shading.share() || !add(look, &lit, &mut shading) {
            break;
        }
    }
    if shading.share() < 0.97 {
        turn(look, places, &lit, &mut shading);
    }
    shading.is_uneven = is_uneven(look, &lit, &shading);
    shading
}

/// Whether many rays a pixel give all of these pixels.
fn is_same(look: &Look, places: &[Place]) -> bool {
    let few = places
        .iter()
        .step_by(places.len() * look.samples.pow(2) as usize / 6000 + 1);
    few.into_iter().all(|p| {
        let ours = look.theirs.pixel(look.step, look.samples, p.i, p.j);
        apart(look.yours.get_pixel(p.i, p.j), &ours) == 0
    })
}

/// Whether the highlights of some object, or all of it, are explained less than others.
fn is_uneven(look: &Look, lit: &[Place], shading: &Shading) -> bool {
    let mut parts = look.theirs.clone();
    shading.wrong.iter().for_each(|one| (one.change)(&mut parts));
    let samples = samples(look, &parts, lit, &shading.wrong);
    let is_low = |its: &[&Sample]| {
        let is_explained = |s: &&&Sample| {
            s.is_explained(&shading.fit.weights, near(look).max(1.0))
        };
        let right = its.iter().filter(is_explained).count();
        5 < its.len() && right * 100 < its.len() * 93
    };
    (0..look.theirs.objects(look.step).len()).any(|k| {
        let its: Vec<_> = samples.iter().filter(|s| s.terms.object == k).collect();
        let shiny = its.iter().filter(|s| 2.0 / 255.0 < s.terms.shine());
        let shiny: Vec<_> = shiny.copied().collect();
        is_low(&its) || is_low(&shiny)
    })
}

/// Takes over the weights of the lights, and then looks for single objects.
fn weigh(look: &mut Look, lit: &[Place], shading: &mut Shading) {
    let before = look.theirs.clone();
    let weight =
        |k: usize| DVec3::from_array([0, 1, 2].map(|c| shading.fit.weights[c][k]));
    let scene = &mut look.theirs.scene;
    scene.ambient_light *= weight(0);
    for (k, light) in scene.lights.iter_mut().enumerate() {
        light.point.diffuse *= weight(1 + 2 * k);
        light.specular *= weight(2 + 2 * k);
    }
    let local = local::mend(look, lit);
    let objects = std::mem::replace(&mut look.theirs, before).scene.objects;
    if local.colours.is_empty() && !local.shine.is_empty() {
        look.theirs.scene.objects = objects;
        shading.local = local;
        shading.fit = fitted(look, lit, &[]);
        shading.is_uneven = is_uneven(look, lit, shading);
    }
}

/// Adds the alternative that explains most, if it explains much more.
fn add(look: &Look, lit: &[Place], shading: &mut Shading) -> bool {
    let few: Vec<_> = lit.iter().step_by(lit.len() / 240 + 1).copied().collect();
    let with = |places: &[Place], one: Alternative| {
        let wrong = [&shading.wrong[..], &[one]].concat();
        (fitted(look, places, &wrong), one)
    };
    let is_after = |s: Section| s.step != Step::Rays || s == section::RAY;
    let all = alternatives()
        .filter(|a| is_after(a.section) && a.section.step <= look.step)
        .map(|one| with(&few, one));
    let mut rough: Vec<_> = all.collect();
    rough.sort_by_key(|(fit, _)| std::cmp::Reverse(fit.explained));
    let fine = rough.into_iter().take(14).map(|(_, one)| with(lit, one));
    let mut fine: Vec<_> = fine.collect();
    // Of those that explain as much, the one whose weights are nearest to 1.
    fine.sort_by_key(|(fit, _)| {
        (std::cmp::Reverse(fit.explained * 200 / lit.len()), fit.strangeness())
    });
    let Some(&(fit, one)) = fine.first() else { return false };
    let share = fit.explained as f64 / lit.len() as f64;
    if share < shading.share() + 0.03 {
        return false;
    }
    let is_equal = |other: &Fit| {
        fit.explained.abs_diff(other.explained) * 500 <= lit.len()
            && other.strangeness() == fit.strangeness()
    };
    let equal = fine.iter().skip(1).filter(|(other, _)| is_equal(other));
    shading.equal = equal.map(|(_, one)| *one).collect();
    shading.wrong.push(one);
    shading.fit = fit;
    true
}

/// Looks for one number of the scene that explains what nothing else does.
fn turn(look: &mut Look, places: &[Place], lit: &[Place], shading: &mut Shading) {
    let telling = knobs::telling(look, places, 120);
    let mut all = Knob::lights();
    let suspects = knobs::suspects(look, places);
    let seen = |k: &&usize| places.iter().any(|p| p.hit == Some(**k));
    if suspects.iter().filter(seen).count() <= 4 {
        all.extend(Knob::shapes(&suspects));
    }
    let turned = knobs::turned(look, &all, &telling);
    let Some(turned) = turned else { return };
    let mut parts = look.theirs.clone();
    knobs::set(&mut parts, &turned, look.step);
    let fit = Fit::of(&samples(look, &parts, lit, &[]), near(look));
    if fit.explained * 100 < 97 * lit.len() {
        return;
    }
    let told = turned.knob.told(&parts, &look.right, look.step);
    look.theirs = parts;
    shading.wrong.clear();
    shading.fit = fit;
    shading.turned = Some((turned, told));
}

/// A stage whose light has a weight.
fn weighted(look: &Look, shading: &Shading, k: usize) -> Stage {
    let (name, section, test, what) = STAGES[k];
    let ours = ours(look, k);
    let [weight, error] = [&shading.fit.weights, &shading.fit.errors]
        .map(|w| DVec3::new(w[0][k], w[1][k], w[2][k]));
    let off = (weight - DVec3::ONE).abs();
    let mut numbers = shading.faults(sections(k));
    let least = if look.is_loose() { 0.03 } else { 0.01 };
    if (0..3).any(|c| (5.0 * error[c]).max(least) < off[c]) {
        let same = (weight - DVec3::splat(weight.x)).abs().max_element() < 0.01;
        let how = match same {
            true => times(weight.x),
            false => format!("{} times as much", vector(weight)),
        };
        numbers.push(format!(
            "{what} is {} in your picture; it should be {}: {how}",
            vector(clean(weight * ours)),
            vector(ours)
        ));
    }
    match k {
        1 | 3 => numbers.extend(position(shading, k / 2)),
        2 | 4 => numbers.extend(shading.local.shine.clone()),
        _ => {}
    }
    let is_seen = error.max_element() < 0.1;
    let verdict = match shading.verdict(&numbers) {
        Verdict::Right if !is_seen => {
            Verdict::Unknown("too little of it is seen".to_owned())
        }
        verdict => verdict,
    };
    let its = shading.wrong.iter().find(|a| sections(k).contains(&a.section));
    let section = match its {
        Some(alternative) => alternative.section,
        None if [2, 4].contains(&k) && !shading.local.shine.is_empty() => {
            section::MATERIALS
        }
        None if k != 0 && shading.turned.is_some() => section::LAMPS,
        None => section,
    };
    Stage { name, verdict, numbers, section, test: Some(test) }
}

/// What is told of the position of a light.
fn position(shading: &Shading, light: usize) -> Option<String> {
    let (turned, told) = shading.turned.as_ref()?;
    matches!(turned.knob, Knob::Position(k, _) if k == light).then(|| told.clone())
}

/// The light that one of the five parts comes from.
fn ours(look: &Look, k: usize) -> DVec3 {
    let scene = &look.right.scene;
    match k {
        0 => scene.ambient_light,
        1 | 3 => scene.lights[k / 2].point.diffuse,
        _ => scene.lights[k / 2 - 1].specular,
    }
}

/// Numbers that can't be told from 0 as 0.
fn clean(v: DVec3) -> DVec3 {
    v.map(|x| if x.abs() < 0.005 { 0.0 } else { x })
}
