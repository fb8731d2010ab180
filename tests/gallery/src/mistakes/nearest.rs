//! Mistakes in the choice of one hit among many.

use crate::parts::hits;
use crate::{Mistake, Step, section};
use step03_nearest::Hit;

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "first-in-list",
        step: Step::Nearest,
        section: section::NEAREST,
        when: "the first sphere in the list that is hit is taken",
        sees: "The ground covers what stands on it: the yellow sphere is gone.",
        says: "Ask every sphere, and keep the hit with the smallest t.",
        change: |parts| {
            parts.nearest = |all, ray, first_hit| hits(all, ray, first_hit).next()
        },
    },
    Mistake {
        name: "last-in-list",
        step: Step::Nearest,
        section: section::NEAREST,
        when: "the last sphere in the list that is hit is taken",
        sees: "Each sphere covers those that come before it in the list.",
        says: "A new hit counts only if its t is smaller than that of the nearest so far.",
        change: |parts| {
            parts.nearest = |all, ray, first_hit| hits(all, ray, first_hit).last()
        },
    },
    Mistake {
        name: "farthest",
        step: Step::Nearest,
        section: section::NEAREST,
        when: "the hit with the largest t is taken",
        sees: "What is far away covers what is near.",
        says: "The comparison is the wrong way round: keep the smaller t.",
        change: |parts| {
            parts.nearest = |all, ray, first_hit| {
                hits(all, ray, first_hit).max_by(|a, b| a.t.total_cmp(&b.t))
            };
        },
    },
    Mistake {
        name: "counted-hits",
        step: Step::Nearest,
        section: section::NEAREST,
        when: "the index counts hits, not spheres",
        sees: "Nearly everything is red, and colours change where spheres overlap.",
        says: "Number the spheres before you leave out those that are missed.",
        change: |parts| {
            parts.nearest = |all, ray, first_hit| {
                let hits = hits(all, ray, first_hit).enumerate();
                let hits = hits.map(|(index, hit)| Hit { index, ..hit });
                hits.min_by(|a, b| a.t.total_cmp(&b.t))
            };
        },
    },
];
