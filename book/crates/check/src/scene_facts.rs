use crate::comparison::{Comparison, Pixel};
use crate::drawing::{Drawing, LineHit, bytes};
use crate::facts::{Fact, fact};
use course::Step;
use glam::DVec3;
use step01_rays::direction_colour;

/// The most regions of which the wrong pixels are told.
const MOST_REGIONS: usize = 3;

/// Facts about the light that there is in ours and not in yours.
pub(crate) fn light_facts<'a>(comparison: &'a Comparison, drawing: &'a Drawing) -> Vec<Fact<'a>> {
    let [warm, cool] = drawing.light_names;
    let names = [
        "the ambient term".to_owned(),
        format!("the diffuse term of {warm}"),
        format!("the diffuse term of {cool}"),
        format!("the specular term of {warm}"),
        format!("the specular term of {cool}"),
    ];
    let count = match drawing.step {
        Step::Diffuse => 3,
        Step::Phong => 5,
        _ => return vec![],
    };
    let mut facts =
        vec![fact("above 1", 1, "has an intensity above 1 in ours", |one| one.is_above_1)];
    // The fewest left out come first; without all of them, it would be black.
    let mut choices: Vec<usize> = (1..(1 << count) - 1).collect();
    choices.sort_by_key(|choice| choice.count_ones());
    for choice in choices {
        let left_out = (0..count).filter(|k| choice >> k & 1 == 1).map(|k| &*names[k]);
        let words = format!("is ours without {}", left_out.collect::<Vec<_>>().join(" and "));
        facts.push(fact("light", 1, words, move |one| {
            one.hit.is_some_and(|hit| {
                let ray = comparison.ray(one);
                let [warm, cool] = [0, 1].map(|k| drawing.terms_at_hit(&ray, hit, Some(k)));
                let terms =
                    [warm.ambient, warm.diffuse, cool.diffuse, warm.specular, cool.specular];
                let kept = terms.iter().enumerate().filter(|(k, _)| choice >> k & 1 == 0);
                bytes(kept.map(|(_, term)| *term).sum::<DVec3>()) == one.yours
            })
        }));
    }
    facts.extend([
        fact("lit", 1, "is where no light reaches", |one| !one.is_sky() && one.lit == [false; 2]),
        fact("lit", 1, format!("is where only {warm} reaches"), |one| one.lit == [true, false]),
        fact("lit", 1, format!("is where only {cool} reaches"), |one| one.lit == [false, true]),
        fact("lit", 1, "is where highlights may be", |one| one.in_highlight),
    ]);
    facts
}

/// Facts about the surfaces that yours shows.
pub(crate) fn hit_facts<'a>(comparison: &'a Comparison, drawing: &'a Drawing) -> Vec<Fact<'a>> {
    let has_colour_of = move |one: &Pixel, is_meant: &dyn Fn(LineHit) -> bool| {
        let ray = comparison.ray(one);
        let mut hits = drawing.line_hits(&ray).filter(|hit| is_meant(*hit));
        hits.any(|hit| drawing.bytes_at_hit(&ray, hit) == one.yours)
    };
    vec![
        fact("sky", 10, "has the colour of the sky, and ours shows an object", |one| {
            !one.is_sky() && shows_sky(comparison, one)
        }),
        fact("hidden", 10, "has the colour of an object behind the nearest", move |one| {
            let is_hidden = |hit: LineHit| hit.is_seen_alone() && one.object() != Some(hit.object);
            !one.is_sky() && has_colour_of(one, &is_hidden)
        }),
        fact("behind the eye", 10, "has the colour of an object behind the eye", move |one| {
            has_colour_of(one, &|hit| hit.t < 0.0)
        }),
        // Where no light reaches, many points have one colour.
        fact("far side", 2, "has the colour of its object's far side", move |one| {
            has_colour_of(one, &|hit| hit.is_far_side && one.object() == Some(hit.object))
        }),
    ]
}

fn shows_sky(comparison: &Comparison, pixel: &Pixel) -> bool {
    bytes(direction_colour(&comparison.ray(pixel))) == pixel.yours
}

/// A sentence about the objects none of whose pixels shows them: each has the colour of the
/// sky or of another object there.
pub(crate) fn missing_objects(comparison: &Comparison, drawing: &Drawing) -> Option<String> {
    let mut missing = vec![false; drawing.scene.objects.len()];
    comparison.wrong_pixels().iter().filter_map(Pixel::object).for_each(|k| missing[k] = true);
    for pixel in &comparison.pixels {
        let Some(k) = pixel.object().filter(|k| missing[*k]) else { continue };
        let ray = comparison.ray(pixel);
        let mut others =
            drawing.line_hits(&ray).filter(|hit| hit.is_seen_alone() && hit.object != k);
        missing[k] = pixel.is_wrong()
            && (shows_sky(comparison, pixel)
                || others.any(|hit| drawing.bytes_at_hit(&ray, hit) == pixel.yours));
    }
    let names = (0..missing.len()).filter(|k| missing[*k]).map(|k| drawing.object_name(k));
    let names = names.collect::<Vec<_>>().join(", ");
    (!names.is_empty()).then(|| format!("Missing: {names}. What lies behind shows instead."))
}

/// A sentence where the sky alone is wrong, nearly everywhere.
pub(crate) fn wrong_sky(comparison: &Comparison, drawing: &Drawing) -> Option<String> {
    let wrong = comparison.wrong_pixels();
    let sky_count = comparison.pixels.iter().filter(|one| one.is_sky()).count();
    let is_told = Step::Rays < drawing.step
        && wrong.iter().all(Pixel::is_sky)
        && 9 * sky_count < 10 * wrong.len();
    is_told.then(|| {
        "Every pixel of an object is right, so the rays are; the sky's colours aren't.".to_owned()
    })
}

/// A line about the sky and the objects of ours: which are right in every pixel, and how many
/// pixels of the others are wrong.
pub(crate) fn describe_regions(comparison: &Comparison, drawing: &Drawing) -> String {
    let mut counts = vec![(0, 0); drawing.scene.objects.len() + 1];
    for pixel in &comparison.pixels {
        let (wrong, all) = &mut counts[pixel.object().map_or(0, |k| k + 1)];
        *wrong += usize::from(pixel.is_wrong());
        *all += 1;
    }
    let (mut right, mut wrong) = (vec![], vec![]);
    for (k, count) in counts.into_iter().enumerate() {
        let name = if k == 0 { "the sky".to_owned() } else { drawing.object_name(k - 1) };
        match count {
            (_, 0) => {}
            (0, _) => right.push(name),
            (count, all) => wrong.push((count, format!("{count} of {all} pixels of {name}"))),
        }
    }
    wrong.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    let more = match wrong.len().saturating_sub(MOST_REGIONS) {
        0 => String::new(),
        more => format!("; {more} more"),
    };
    wrong.truncate(MOST_REGIONS);
    let wrong: Vec<_> = wrong.into_iter().map(|(_, words)| words).collect();
    let wrong = wrong.join("; ");
    match right.len() {
        0 => format!("Wrong: {wrong}{more}.\n"),
        _ if more.is_empty() => {
            format!("Wrong: {wrong}. Everything else is right in every pixel.\n")
        }
        _ => format!("Right in every pixel: {}. Wrong: {wrong}{more}.\n", right.join(", ")),
    }
}
