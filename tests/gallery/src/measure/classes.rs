use super::light::{ONCE, Sample};
use super::words::number;
use super::{Stage, Verdict};
use step04_diffuse::{Attenuation, COOL, WARM};

/// Which of the parts of ours reach a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Class {
    /// No light: the ambient part alone.
    Dark,
    /// One light (0 or 1) without a highlight.
    Matt(usize),
    /// One light or two, with a highlight.
    Shiny,
    /// Two lights without a highlight.
    Both,
}

fn class(sample: &Sample) -> Class {
    let size = |k: usize| sample.terms.parts[k].max_element();
    if 0.5 / 255.0 < size(2).max(size(4)) {
        return Class::Shiny;
    }
    match (0.0 < size(1), 0.0 < size(3)) {
        (false, false) => Class::Dark,
        (true, false) => Class::Matt(0),
        (false, true) => Class::Matt(1),
        (true, true) => Class::Both,
    }
}

/// Tells the stages of a light that nothing explains as a whole, from the pixels that
/// only some of them reach.
pub(super) fn tell(samples: &[Sample], near: f64, stages: &mut [Stage]) {
    let of = |wanted: Class| -> Vec<&Sample> {
        samples.iter().filter(|s| class(s) == wanted).collect()
    };
    let share = |its: &[&Sample]| {
        let right = its.iter().filter(|s| s.is_explained(&ONCE, near)).count();
        (12 <= its.len()).then(|| right as f64 / its.len() as f64)
    };
    let is_right = |its: &[&Sample]| share(its).is_some_and(|share| 0.995 < share);
    let is_wrong = |its: &[&Sample]| share(its).is_some_and(|share| share < 0.5);
    let dark = of(Class::Dark);
    if !is_right(&dark) {
        return;
    }
    put(stages, "ambient", Verdict::Right, vec![]);
    let matt = [0, 1].map(|light| of(Class::Matt(light)));
    for (light, name) in ["diffuse, warm", "diffuse, cool"].into_iter().enumerate()
    {
        if is_right(&matt[light]) {
            put(stages, name, Verdict::Right, vec![]);
        } else if is_wrong(&matt[light]) {
            faded(&matt[light], light, name, stages);
        }
    }
    if matt.iter().all(|its| is_right(its)) {
        put(stages, "attenuation", Verdict::Right, vec![]);
        put(stages, "point and normal", Verdict::Right, vec![]);
        let shiny = of(Class::Shiny);
        if is_wrong(&shiny) || share(&shiny).is_some_and(|share| share < 0.9) {
            let told = "what no highlight of ours reaches is right, and what one reaches \
                        is not: r·v, its power n, R_s, L_s or their fading";
            for name in ["specular, warm", "specular, cool"] {
                put(stages, name, Verdict::Wrong, vec![told.to_owned()]);
            }
        }
    }
}

fn put(stages: &mut [Stage], name: &str, verdict: Verdict, numbers: Vec<String>) {
    for stage in stages.iter_mut().filter(|stage| stage.name == name) {
        stage.verdict = verdict.clone();
        stage.numbers = numbers.clone();
    }
}

/// How many times as much as ours a light gives to a pixel that no other one reaches.
fn factor(sample: &Sample, light: usize) -> Option<f64> {
    let (ambient, diffuse) =
        (sample.terms.parts[0], sample.terms.parts[1 + 2 * light]);
    let channels = (0..3).filter(|&k| !sample.clamped[k] && 0.03 < diffuse[k]);
    let (yours, ours) = channels.fold((0.0, 0.0), |(yours, ours), k| {
        (yours + sample.yours[k] - ambient[k], ours + diffuse[k])
    });
    (0.0 < ours).then(|| yours / ours)
}

/// Tells whether one light is wrong by its distance or by its angle.
fn faded(samples: &[&Sample], light: usize, name: &str, stages: &mut [Stage]) {
    let all = samples.iter().filter_map(|s| Some((s, factor(s, light)?)));
    let all: Vec<_> = all.collect();
    let by_distance: Vec<_> =
        all.iter().map(|(s, f)| (s.terms.distances[light], *f)).collect();
    let by_cosine: Vec<_> =
        all.iter().map(|(s, f)| (s.terms.cosines[light], *f)).collect();
    let [distance, cosine] = [by_distance, by_cosine].map(Curve::of);
    let which = ["warm", "cool"][light];
    match (distance, cosine) {
        (Some(curve), other)
            if other.as_ref().is_none_or(|o| curve.rest < o.rest / 3.0) =>
        {
            let mut told = vec![divisors(&curve, light)];
            told.extend(one_number(&curve, light));
            put(stages, "attenuation", Verdict::Wrong, told);
        }
        (other, Some(curve))
            if other.as_ref().is_none_or(|o| curve.rest < o.rest / 3.0) =>
        {
            let told = curve.told(|cosine, factor| {
                format!("where l·n is {} {} times", number(cosine), number(factor))
            });
            let told = format!(
                "the {which} light gives, by its angle alone, {told} as much as it should: \
                 max(l·n, 0) is another"
            );
            put(stages, name, Verdict::Wrong, vec![told]);
        }
        _ => {}
    }
}

/// The attenuation of a light of the course.
fn ours(light: usize) -> Attenuation {
    [WARM, COOL][light].attenuation
}

/// The divisor at three distances, theirs and ours.
fn divisors(curve: &Curve, light: usize) -> String {
    let told = curve.told(|d, factor| {
        let ours = ours(light).at(d);
        format!(
            "{} for {} at d = {}",
            number(ours / factor),
            number(ours),
            number(d)
        )
    });
    let which = ["warm", "cool"][light];
    format!("the {which} light is divided, for a + bd + cd², by {told}")
}

/// The one of a, b and c that explains another divisor alone.
fn one_number(curve: &Curve, light: usize) -> Option<String> {
    let Attenuation { a, b, c } = ours(light);
    let which = ["warm", "cool"][light];
    let read = |k: i32| -> Option<f64> {
        let values = curve.points.iter().map(|(d, factor)| {
            let others = [b * d + c * d * d, a + c * d * d, a + b * d][k as usize];
            (ours(light).at(*d) / factor - others) / d.powi(k)
        });
        let values: Vec<f64> = values.collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let is_near = |v: &f64| (v - mean).abs() < 0.06 * mean.abs();
        values.iter().all(is_near).then_some(mean)
    };
    let (k, value) = (0..3).find_map(|k| Some((k, read(k)?)))?;
    let k = k as usize;
    Some(format!(
        "that is a {} of about {} for the {which} light; it should be {}",
        ["a", "b", "c"][k],
        number(value),
        number([a, b, c][k])
    ))
}

/// A factor that depends on one thing alone.
struct Curve {
    /// The thing and the factor, at a few places.
    points: Vec<(f64, f64)>,
    /// How far the factors are from the curve.
    rest: f64,
}

impl Curve {
    /// The curve through pairs of a thing and a factor, if they lie on one.
    fn of(mut pairs: Vec<(f64, f64)>) -> Option<Self> {
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let size = (pairs.len() / 16).max(4);
        let (mut points, mut rests) = (vec![], vec![]);
        for bin in pairs.chunks(size).filter(|bin| bin.len() == size) {
            let count = size as f64;
            let x = bin.iter().map(|p| p.0).sum::<f64>() / count;
            let y = bin.iter().map(|p| p.1).sum::<f64>() / count;
            points.push((x, y));
            let off = bin.iter().map(|p| (p.1 - y).abs()).sum::<f64>() / count;
            rests.push(off / y.abs().max(0.05));
        }
        rests.sort_by(f64::total_cmp);
        let rest = *rests.get(rests.len() / 2)?;
        (4 <= points.len() && rest < 0.08).then_some(Self { points, rest })
    }

    /// Three of its points in words.
    fn told(&self, words: impl Fn(f64, f64) -> String) -> String {
        let last = self.points.len() - 1;
        let three = [0, last / 2, last].map(|k| self.points[k]);
        three.map(|(x, y)| words(x, y)).join(", ")
    }
}
