//! Mistakes in the choice of one hit among many.

use crate::parts::hits;
use crate::{Mistake, Parts, Step, section};
use step03_nearest::Hit;

pub(crate) const ALL: &[Mistake] = &[
    wrong(
        "first-in-list",
        "the first sphere in the list that is hit is taken",
        "The ground covers what stands on it: the yellow sphere is gone.",
        "Ask every sphere, and keep the hit with the smallest t.",
        |parts| {
            parts.nearest = |all, ray, first_hit| hits(all, ray, first_hit).next()
        },
    ),
    wrong(
        "last-in-list",
        "the last sphere in the list that is hit is taken",
        "Each sphere covers those that come before it in the list.",
        "A new hit counts only if its t is smaller than that of the nearest so far.",
        |parts| {
            parts.nearest = |all, ray, first_hit| hits(all, ray, first_hit).last()
        },
    ),
    wrong(
        "farthest",
        "the hit with the largest t is taken",
        "What is far away covers what is near.",
        "The comparison is the wrong way round: keep the smaller t.",
        |parts| {
            parts.nearest = |all, ray, first_hit| {
                hits(all, ray, first_hit).max_by(|a, b| a.t.total_cmp(&b.t))
            };
        },
    ),
    wrong(
        "counted-hits",
        "the index counts hits, not spheres",
        "Nearly everything is red, and colours change where spheres overlap.",
        "Number the spheres before you leave out those that are missed.",
        |parts| {
            parts.nearest = |all, ray, first_hit| {
                let hits = hits(all, ray, first_hit).enumerate();
                let hits = hits.map(|(index, hit)| Hit { index, ..hit });
                hits.min_by(|a, b| a.t.total_cmp(&b.t))
            };
        },
    ),
];

const fn wrong(
    name: &'static str,
    when: &'static str,
    sees: &'static str,
    says: &'static str,
    change: fn(&mut Parts),
) -> Mistake {
    let (step, section) = (Step::Nearest, section::NEAREST);
    let file = "steps/step03_nearest/src/hit.rs";
    Mistake { name, step, file, section, when, sees, says, change }
}
