use super::light::{ONCE, Sample};
use super::shading::{near, samples};
use super::words::{number, times, vector};
use super::{Fit, Look, Place};
use crate::Step;
use glam::DVec3;

/// What is wrong with single objects.
#[derive(Clone, Debug, Default)]
pub(super) struct Local {
    /// Sentences about colours, R_a and R_d.
    pub colours: Vec<String>,
    /// Sentences about R_s and n.
    pub shine: Vec<String>,
}

/// Finds objects whose material is not ours while that of others is, and takes over
/// what is found.
pub(super) fn mend(look: &mut Look, places: &[Place]) -> Local {
    let mut local = Local::default();
    let of = |k: usize| -> Vec<_> {
        places.iter().filter(|p| p.hit == Some(k)).copied().collect()
    };
    let all: Vec<_> = (0..look.theirs.objects(look.step).len())
        .map(|k| (k, of(k)))
        .filter(|(_, its)| 8 < its.len())
        .collect();
    let (right, wrong): (Vec<_>, Vec<_>) =
        all.into_iter().partition(|(_, its)| 0.98 < once(look, its));
    if right.is_empty() {
        return local;
    }
    let (before, many) = (look.theirs.clone(), 4 < wrong.len());
    for (k, its) in wrong {
        let is_found = surface(look, k, &its, &mut local)
            || !many && shininess(look, k, &its, &mut local);
        if many && !is_found {
            look.theirs = before;
            return Local::default();
        }
    }
    local
}

/// Which share of some places the parts that are known explain.
fn once(look: &Look, places: &[Place]) -> f64 {
    let samples = samples(look, &look.theirs, places, &[]);
    let is_explained = |s: &&Sample| s.is_explained(&ONCE, near(look).max(1.0));
    samples.iter().filter(is_explained).count() as f64 / samples.len().max(1) as f64
}

/// Whether R_a, R_d and R_s alone explain an object: they are told and taken over.
fn surface(look: &mut Look, k: usize, places: &[Place], local: &mut Local) -> bool {
    let samples = samples(look, &look.theirs, places, &[]);
    let fit = Fit::of(&samples, near(look));
    if fit.explained * 100 < 93 * samples.len() {
        return false;
    }
    let weight =
        |part: usize| DVec3::from_array([0, 1, 2].map(|c| fit.weights[c][part]));
    let error =
        |part: usize| DVec3::from_array([0, 1, 2].map(|c| fit.errors[c][part]));
    let best = |a: usize, b: usize| {
        // Each channel by the light that tells more of it.
        let is_first = error(a).cmplt(error(b));
        let error = error(a).min(error(b));
        let mean = DVec3::select(is_first, weight(a), weight(b));
        // What can't be read is believed.
        DVec3::select(error.cmplt(DVec3::splat(0.06)), mean, DVec3::ONE)
    };
    let (a, d, s) = (best(0, 0), best(1, 3), best(2, 4));
    let object = &mut look.theirs.scene.objects[k].material;
    let (name, material) = (object.name, &mut object.material);
    let is_off = |w: DVec3| 0.012 < (w - 1.0).abs().max_element();
    let (r_a, r_d, r_s) =
        (material.surface.ambient, material.surface.diffuse, material.specular);
    let told = |what: &str, w: DVec3, ours: DVec3| {
        format!(
            "{what} of {name} is {} in your picture; it should be {}{}",
            vector(round(digits(w * ours))),
            vector(ours),
            ratio(w)
        )
    };
    let is_colour = (a - d).abs().max_element() < 0.03;
    match (is_off(a), is_off(d)) {
        (true, true) if is_colour => local.colours.push(told("the colour", a, r_a)),
        (is_a, is_d) => {
            local.colours.extend(is_a.then(|| told("R_a", a, r_a)));
            local.colours.extend(is_d.then(|| told("R_d", d, r_d)));
        }
    }
    let is_shine = (6.0 * error(2).min(error(4))).max(DVec3::splat(0.03));
    let is_shine = (s - 1.0).abs().cmpgt(is_shine).any();
    if look.step == Step::Phong && is_shine {
        local.shine.push(told("R_s", s, r_s));
    }
    let taken =
        |w: DVec3, ours: DVec3| if is_off(w) { digits(w * ours) } else { ours };
    material.surface.ambient = taken(a, r_a);
    material.surface.diffuse = taken(if is_colour { a } else { d }, r_d);
    material.specular = if is_shine { digits(s * r_s) } else { r_s };
    true
}

/// The same factor of all three channels, in words.
fn ratio(w: DVec3) -> String {
    let is_same = (w - w.x).abs().max_element() < 0.01;
    if is_same { format!(": {}", times(w.x)) } else { String::new() }
}

/// Two digits, where they can't be told from more.
fn digits(v: DVec3) -> DVec3 {
    v.map(|x| {
        let two = (100.0 * x).round() / 100.0;
        if (x - two).abs() < 0.004 { two } else { x }
    })
}

/// Three digits.
fn round(v: DVec3) -> DVec3 {
    (v * 1000.0).round() / 1000.0
}

/// Whether another n explains an object, and perhaps another R_s: they are told and
/// taken over.
fn shininess(
    look: &mut Look,
    k: usize,
    places: &[Place],
    local: &mut Local,
) -> bool {
    if look.step != Step::Phong {
        return false;
    }
    let ours = look.theirs.scene.objects[k].material.material.shininess;
    let mut rate = |n: i32| {
        look.theirs.scene.objects[k].material.material.shininess = n;
        let samples = samples(look, &look.theirs, places, &[]);
        let is_explained = |s: &&Sample| s.is_explained(&ONCE, near(look).max(1.0));
        let once = samples.iter().filter(is_explained).count();
        (once, n)
    };
    let coarse = (0..80).map(|k| 1.1_f64.powi(k) as i32).filter(|n| *n <= 2000);
    let mut seen = vec![];
    coarse.for_each(|n| seen.push(rate(n)));
    let best = seen.iter().max().copied().unwrap_or((0, ours));
    let near = best.1 - best.1 / 9 - 1..=best.1 + best.1 / 9 + 1;
    near.for_each(|n| seen.push(rate(n.max(1))));
    let count = seen.iter().map(|(count, _)| *count).max().unwrap_or(0);
    let mut equal: Vec<_> =
        seen.iter().filter(|one| count <= one.0 + 1).map(|one| one.1).collect();
    // The roundest of those that explain as much.
    equal.sort_by_key(|n| {
        [100, 50, 10, 5].iter().position(|by| n % by == 0).unwrap_or(9)
    });
    let n = equal.first().copied().unwrap_or(ours);
    let is_it = 97 * places.len() <= 100 * count && n != ours;
    let material = &mut look.theirs.scene.objects[k].material;
    material.material.shininess = if is_it { n } else { ours };
    if is_it {
        local.shine.push(format!(
            "the highlights of {} are those of n = {}; it should be {}",
            material.name,
            number(n.into()),
            number(ours.into())
        ));
    }
    is_it
}
