use super::light::Sample;
use super::words::{percent, times, vector};
use super::{Alternative, Fit, Look, Place, Stage, Verdict, alternatives};
use crate::Step;
use crate::difference::apart;
use crate::section::{self, Section};
use glam::DVec3;

/// What draws the light of a picture, as far as it is known.
struct Shading {
    /// What is not right in them.
    wrong: Vec<Alternative>,
    fit: Fit,
    /// How many pixels were looked at.
    all: usize,
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
        let its = self.wrong.iter().filter(|a| sections.contains(&a.section));
        its.map(|a| {
            format!("{} of it is what you get when {}", self.told(), a.when)
        })
        .collect()
    }

    /// The verdict on a stage with these faults.
    fn verdict(&self, faults: &[String]) -> Verdict {
        match self.share() {
            share if share < 0.97 => self.unexplained(),
            _ if !faults.is_empty() => Verdict::Wrong,
            1.0 => Verdict::Right,
            _ => self.unexplained(),
        }
    }

    fn unexplained(&self) -> Verdict {
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
    section::MEETING,
    section::FORMULA,
    section::CENTRE,
    section::ROOT,
    section::NEAREST,
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

/// The stages from the point to the highlights.
pub(super) fn stages(look: &Look, places: &[Place]) -> Vec<Stage> {
    let shading = search(look, &lit(look, places));
    let stage = |name, sections: &[Section], test| {
        let numbers = shading.faults(sections);
        let verdict = shading.verdict(&numbers);
        let its = shading.wrong.iter().find(|a| sections.contains(&a.section));
        let section = its.map_or(sections[sections.len() - 1], |a| a.section);
        Stage { name, verdict, numbers, section, test: Some(test) }
    };
    let attenuation = &[section::ATTENUATION];
    let mut stages = vec![stage("point and normal", POINT, "normal_of_a_pixel")];
    stages.extend([0, 1, 3].map(|k| weighted(look, &shading, k)));
    stages.push(stage("attenuation", attenuation, "lights_of_a_pixel"));
    if look.step == Step::Phong {
        stages.extend([2, 4].map(|k| weighted(look, &shading, k)));
    }
    stages
}

/// Some places on objects, away from all edges; half of them are not as they should be,
/// if so many are not.
fn lit(look: &Look, places: &[Place]) -> Vec<Place> {
    let is_lit = |p: &&Place| p.hit.is_some() && !p.is_sky;
    let (wrong, right): (Vec<_>, Vec<_>) =
        places.iter().filter(is_lit).partition(|p| !is_right(look, p));
    let few = |all: Vec<&Place>| -> Vec<Place> {
        let few = all.iter().step_by(all.len() / 800 + 1);
        few.filter(|p| !look.is_edge(&look.theirs, p.i, p.j)).map(|p| **p).collect()
    };
    [few(right), few(wrong)].concat()
}

/// Whether a pixel is what the right light makes of it.
fn is_right(look: &Look, p: &Place) -> bool {
    let ours = look.bytes.write(look.theirs.intensity(look.step, p.i, p.j));
    let apart = apart(look.yours.get_pixel(p.i, p.j), &ours);
    apart <= u8::from(look.is_smooth || !look.is_right_camera)
}

/// How far off an explained pixel may be.
fn near(look: &Look) -> f64 {
    match look.is_smooth || !look.is_right_camera {
        true => 1.6 / 255.0,
        false => 0.6 / 255.0,
    }
}

fn shaded(look: &Look, places: &[Place], wrong: Vec<Alternative>) -> Shading {
    let mut parts = look.theirs.clone();
    wrong.iter().for_each(|one| (one.change)(&mut parts));
    let sample = |p: &Place| {
        let pixel = look.yours.get_pixel(p.i, p.j);
        Sample::of(&parts, look.step, &look.bytes, pixel, (p.i, p.j))
    };
    let samples: Vec<_> = places.iter().filter_map(sample).collect();
    let fit = Fit::of(&samples, near(look));
    Shading { wrong, fit, all: places.len() }
}

/// The parts that explain most, with as few alternatives as possible.
fn search(look: &Look, places: &[Place]) -> Shading {
    let mut best = shaded(look, places, vec![]);
    for _ in 0..2 {
        if 0.985 < best.share() {
            break;
        }
        let with = |one| {
            let wrong = best.wrong.iter().copied().chain([one]).collect();
            shaded(look, places, wrong)
        };
        let steps = Step::Sphere..=look.step;
        let all = alternatives().filter(|a| steps.contains(&a.section.step));
        let next = all.map(with).max_by_key(|shading| shading.fit.explained);
        match next {
            Some(next) if best.share() + 0.05 < next.share() => best = next,
            _ => break,
        }
    }
    best
}

/// A stage whose light has a weight.
fn weighted(look: &Look, shading: &Shading, k: usize) -> Stage {
    let (name, section, test, what) = STAGES[k];
    let ours = ours(look, k);
    let [weight, error] = [&shading.fit.weights, &shading.fit.errors]
        .map(|w| DVec3::new(w[0][k], w[1][k], w[2][k]));
    let off = (weight - DVec3::ONE).abs();
    let mut numbers = shading.faults(sections(k));
    if (0..3).any(|c| (5.0 * error[c]).max(0.01) < off[c]) {
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
    let is_seen = error.max_element() < 0.1;
    let verdict = match shading.verdict(&numbers) {
        Verdict::Right if !is_seen => {
            Verdict::Unknown("too little of it is seen".to_owned())
        }
        verdict => verdict,
    };
    let its = shading.wrong.iter().find(|a| sections(k).contains(&a.section));
    let section = its.map_or(section, |a| a.section);
    Stage { name, verdict, numbers, section, test: Some(test) }
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
