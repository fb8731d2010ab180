//! Mistakes in the choice of one hit among many.

use crate::mistake::book;
use crate::{Mistake, Step, section};
use step03_nearest::Hit;

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "first-in-list",
        when: "the first sphere in the list that is hit is taken",
        sees: book(
            "The ground covers what stands on it: the golden sphere is gone.",
        ),
        says: "Ask every sphere, and keep the hit with the smallest t.",
        change: |parts| parts.nearest = |hits| hits.next(),
        ..section::NEAREST.mistake()
    },
    Mistake {
        name: "last-in-list",
        when: "the last sphere in the list that is hit is taken",
        sees: book("Each sphere covers those that come before it in the list."),
        says: "A new hit counts only if its t is smaller than that of the nearest so far.",
        change: |parts| parts.nearest = |hits| hits.last(),
        ..section::NEAREST.mistake()
    },
    Mistake {
        name: "farthest",
        when: "the hit with the largest t is taken",
        sees: book("What is far away covers what is near."),
        says: "The comparison is the wrong way round: keep the smaller t.",
        change: |parts| {
            parts.nearest = |hits| hits.max_by(|a, b| a.t.total_cmp(&b.t));
        },
        ..section::NEAREST.mistake()
    },
    Mistake {
        name: "old-t",
        step: Step::Diffuse,
        when: "a nearer object is kept, but not its t",
        sees: book(
            "The white sphere is dark, the golden one too light, and the teal one has a stripe.",
        ),
        says: "A hit is a t and its object: replace both, or the light is that of a point \
         behind the surface.",
        change: |parts| {
            parts.nearest = |hits| {
                let first = hits.next()?;
                let nearer = hits.filter(|hit| hit.t < first.t).last();
                Some(nearer.map_or(first, |hit| Hit { t: first.t, ..hit }))
            };
        },
        ..section::NEAREST.mistake()
    },
];
