use super::reading::{Seen, put};
use super::words::{number, percent};
use super::{Stage, Verdict};
use crate::{key, sort};
use step04_diffuse::{Attenuation, COOL, WARM};

/// Which of the parts of ours reach a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Class {
    /// No light: the ambient part alone.
    Dark,
    /// One light (0 or 1) without a highlight.
    Matt(usize),
    /// Two lights without a highlight.
    Both,
    /// One light or two, with a highlight.
    Shiny,
}

fn class(seen: &Seen) -> Class {
    let shine = seen.specular[0].max(seen.specular[1]).max_element();
    if 0.25 / 255.0 < shine {
        return Class::Shiny;
    }
    match seen.cosines.map(|cosine| 0.0 < cosine) {
        [false, false] => Class::Dark,
        [true, false] => Class::Matt(0),
        [false, true] => Class::Matt(1),
        [true, true] => Class::Both,
    }
}

/// Tells the stages of a light that nothing explains as a whole, from the pixels that
/// only some of them reach. A stage is right where each pixel of its class is.
pub(super) fn tell(all: &[Seen], stages: &mut [Stage]) {
    let of = |wanted: Class| -> Vec<&Seen> {
        let its = all.iter().filter(|s| s.object.is_some());
        its.filter(|s| class(s) == wanted).collect()
    };
    let right = |its: &[&Seen]| its.iter().filter(|s| s.is_right()).count();
    let is_right = |its: &[&Seen]| 24 <= its.len() && right(its) == its.len();
    let is_wrong = |its: &[&Seen]| 24 <= its.len() && 2 * right(its) < its.len();
    let dark = of(Class::Dark);
    if !is_right(&dark) {
        return;
    }
    // A dark pixel of each object tells which it is, and its R_a.
    put(stages, "ambient", Verdict::Right, vec![]);
    let matt = [0, 1].map(|light| of(Class::Matt(light)));
    for (light, name) in ["diffuse, warm", "diffuse, cool"].into_iter().enumerate()
    {
        if is_wrong(&matt[light]) {
            faded(&matt[light], light, name, stages);
        }
    }
    let both = of(Class::Both);
    let is_matt = |its: &[&Seen]| its.is_empty() || right(its) == its.len();
    if matt.iter().all(|its| is_right(its)) && is_matt(&both) {
        for name in
            ["diffuse, warm", "diffuse, cool", "attenuation", "point and normal"]
        {
            put(stages, name, Verdict::Right, vec![]);
        }
        let shiny = of(Class::Shiny);
        if is_wrong(&shiny)
            || right(&shiny) * 10 < shiny.len() * 9 && 24 < shiny.len()
        {
            let share = percent(shiny.len() - right(&shiny), shiny.len());
            let told = format!(
                "what no highlight of ours reaches is right in every pixel, and {share} of \
                 what one reaches is not: r·v, its power n, R_s, L_s or their fading"
            );
            for name in ["specular, warm", "specular, cool"] {
                put(stages, name, Verdict::Wrong, vec![told.clone()]);
            }
        }
    }
}

/// How many times as much as ours a light gives to a pixel that no other one reaches,
/// and how far off that may be by the rounding of its bytes.
fn factor(seen: &Seen, light: usize) -> Option<(f64, f64)> {
    let (mut yours, mut ours, mut off) = (0.0, 0.0, 0.0);
    for k in 0..3 {
        let byte = seen.yours[k];
        if !matches!(byte, 0 | 255) && 0.03 < seen.diffuse[light][k] {
            yours += f64::from(byte) / 255.0 - seen.ambient[k];
            ours += seen.diffuse[light][k];
            off += 0.5 / 255.0;
        }
    }
    (0.0 < ours).then(|| (yours / ours, off / ours))
}

/// Whether all three channels have this factor, but for the rounding.
fn is_same(seen: &Seen, light: usize, factor: f64) -> bool {
    let ours = 255.0 * (seen.ambient + factor * seen.diffuse[light]);
    let is_near = |k: usize| (ours[k] - f64::from(seen.yours[k])).abs() < 1.5;
    (0..3).all(|k| matches!(seen.yours[k], 0 | 255) || is_near(k))
}

/// Tells by how much one light is wrong, by its distance or by its angle.
fn faded(all: &[&Seen], light: usize, name: &str, stages: &mut [Stage]) {
    let factors = all.iter().filter_map(|s| Some((s, factor(s, light)?)));
    let factors: Vec<_> = factors.collect();
    // Another distance or angle gives less or more of the same colour.
    let same = factors.iter().filter(|(s, (factor, _))| is_same(s, light, *factor));
    if same.count() * 20 < factors.len() * 19 {
        return;
    }
    let by = |x: fn(&Seen, usize) -> f64| {
        let points = factors.iter().map(|(s, (y, off))| [x(s, light), *y, *off]);
        Curve::of(points.collect())
    };
    let which = ["warm", "cool"][light];
    let distance = by(|seen, light| seen.distances[light]);
    let cosine = by(|seen, light| seen.cosines[light]);
    let is_better = |a: &Curve, b: &Option<Curve>| {
        b.as_ref().is_none_or(|b| a.rest < b.rest / 3.0)
    };
    // No one divides by a hundred times too much: then it gives no light at all.
    let is_divisor =
        |curve: &&Curve| curve.points.iter().all(|(_, factor)| 0.01 < factor.abs());
    let is_it = |curve: &&Curve| is_better(curve, &cosine) && is_divisor(curve);
    if let Some(curve) = distance.as_ref().filter(is_it) {
        let told = curve.told(|d, factor| {
            let ours = ours(light).at(d);
            format!(
                "{} for {} at d = {}",
                number(ours / factor),
                number(ours),
                number(d)
            )
        });
        let told = format!(
            "the {which} light is divided, for a + bd + cd², by about {told}"
        );
        put(stages, "attenuation", Verdict::Wrong, vec![told]);
    } else if let Some(curve) =
        cosine.as_ref().filter(|curve| is_better(curve, &distance))
    {
        let told = curve.told(|cosine, factor| {
            format!("{} times where l·n is {}", number(factor), number(cosine))
        });
        let told = format!(
            "the {which} light gives, by its angle alone, about {told} as much as it should: \
             max(l·n, 0) is another"
        );
        put(stages, name, Verdict::Wrong, vec![told]);
    }
}

/// The attenuation of a light of the course.
fn ours(light: usize) -> Attenuation {
    [WARM, COOL][light].attenuation
}

/// A factor that depends on one thing alone.
struct Curve {
    /// The thing and the factor, at a few places.
    points: Vec<(f64, f64)>,
    /// How far the factors are from the curve.
    rest: f64,
}

impl Curve {
    /// The curve through a thing, a factor and how far off that may be, each; if they lie
    /// on one. What depends on something else as well does not.
    fn of(mut all: Vec<[f64; 3]>) -> Option<Self> {
        sort(&mut all, |one| key(one[0]));
        let size = (all.len() / 16).max(4);
        let (mut points, mut rests, mut on) = (vec![], vec![], 0);
        for bin in all.chunks(size).filter(|bin| bin.len() == size) {
            let [x, y, slope] = line(bin);
            points.push((x, y));
            let off = |p: &[f64; 3]| (p[1] - y - slope * (p[0] - x)).abs();
            rests.push(
                bin.iter().map(off).sum::<f64>() / size as f64 / y.abs().max(0.05),
            );
            let is_on =
                |p: &&[f64; 3]| off(p) < 1.5 * p[2] + 0.02 * p[1].abs().max(0.05);
            on += bin.iter().filter(is_on).count();
        }
        sort(&mut rests, |rest| key(*rest));
        let rest = *rests.get(rests.len() / 2)?;
        (4 <= points.len() && rest < 0.03 && 10 * on > 9 * size * points.len())
            .then_some(Self { points, rest })
    }

    /// Three of its points in words.
    fn told(&self, words: impl Fn(f64, f64) -> String) -> String {
        let last = self.points.len() - 1;
        let three = [0, last / 2, last].map(|k| self.points[k]);
        three.map(|(x, y)| words(x, y)).join(", ")
    }
}

/// The middle of some points, and the slope of the line that lies best on them.
fn line(points: &[[f64; 3]]) -> [f64; 3] {
    let count = points.len() as f64;
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / count;
    let (x, y) = (mean(0), mean(1));
    let sum = |f: &dyn Fn(&[f64; 3]) -> f64| points.iter().map(f).sum::<f64>();
    let across = sum(&|p| (p[0] - x).powi(2));
    let along = sum(&|p| (p[0] - x) * (p[1] - y));
    [x, y, along / across.max(1e-12)]
}
