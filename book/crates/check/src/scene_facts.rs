use crate::comparison::Pixel;
use crate::drawing::{Drawing, bytes};
use crate::facts::{Fact, fact};
use course::{Step, camera};
use glam::DVec3;
use step01_rays::{direction_colour, mean, sub_pixels};

/// Facts about pixels that are ours with more rays, of a program that is wrong elsewhere.
pub(crate) fn sample_facts(drawing: &Drawing) -> impl Iterator<Item = Fact<'_>> {
    (2..=4).map(move |side| {
        let words = format!("is ours with {side}×{side} rays per pixel");
        let (camera, places) = (camera(), sub_pixels(side));
        // Elsewhere than at the edges, more rays change little.
        fact("samples", 20, words, move |one| {
            let (i, j) = (f64::from(one.place.0), f64::from(one.place.1));
            bytes(mean(&places, |u, v| drawing.colour(&camera.ray(i + u, j + v)))) == one.yours
        })
    })
}

/// Facts about the light that there is in ours and not in yours.
pub(crate) fn light_facts(drawing: &Drawing) -> Vec<Fact<'_>> {
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
    let is_above_1 = |one: &Pixel| 1.0 < drawing.colour(&one.ray).max_element();
    let mut facts = vec![fact("above 1", 1, "has an intensity above 1 in ours", is_above_1)];
    // The fewest left out come first; without all of them, it would be black.
    let mut choices: Vec<usize> = (1..(1 << count) - 1).collect();
    choices.sort_by_key(|choice| choice.count_ones());
    for choice in choices {
        let left_out = (0..count).filter(|k| choice >> k & 1 == 1).map(|k| &*names[k]);
        let words = format!("is ours without {}", left_out.collect::<Vec<_>>().join(" and "));
        facts.push(fact("light", 1, words, move |one| {
            one.hit.is_some_and(|hit| {
                let [warm, cool] = [0, 1].map(|k| drawing.terms_at_hit(&one.ray, hit, Some(k)));
                let terms =
                    [warm.ambient, warm.diffuse, cool.diffuse, warm.specular, cool.specular];
                let kept = terms.iter().enumerate().filter(|(k, _)| choice >> k & 1 == 0);
                bytes(kept.map(|(_, term)| *term).sum::<DVec3>()) == one.yours
            })
        }));
    }
    for (words, are_lit) in [
        ("is where no light reaches".to_owned(), [false, false]),
        (format!("is where only {warm} reaches"), [true, false]),
        (format!("is where only {cool} reaches"), [false, true]),
    ] {
        facts.push(fact("lit", 1, words, move |one| {
            one.hit.is_some_and(|hit| drawing.lights_at_hit(&one.ray, hit).0 == are_lit)
        }));
    }
    facts.push(fact("lit", 1, "is where highlights may be", |one| {
        let in_highlight = |hit| drawing.lights_at_hit(&one.ray, hit).1;
        drawing.step == Step::Phong && one.hit.is_some_and(in_highlight)
    }));
    facts
}

/// Facts about the surfaces that yours shows.
pub(crate) fn hit_facts(drawing: &Drawing) -> [Fact<'_>; 2] {
    [
        fact("sky", 10, "has the colour of the sky, and ours shows an object", |one| {
            !one.is_sky() && shows_sky(one)
        }),
        fact("hidden", 10, "has the colour of an object behind the nearest", |one| {
            !one.is_sky() && shows_another_object(drawing, one)
        }),
    ]
}

pub(crate) fn shows_sky(pixel: &Pixel) -> bool {
    bytes(direction_colour(&pixel.ray)) == pixel.yours
}

/// Whether yours has the colour of another object than the nearest.
pub(crate) fn shows_another_object(drawing: &Drawing, pixel: &Pixel) -> bool {
    let mut others =
        drawing.object_hits(&pixel.ray).filter(|hit| pixel.object() != Some(hit.object));
    others.any(|hit| drawing.bytes_at_hit(&pixel.ray, hit) == pixel.yours)
}
