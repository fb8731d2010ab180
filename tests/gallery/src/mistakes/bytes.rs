//! Mistakes on the way from an intensity to three bytes.

use crate::mistake::book;
use crate::{Mistake, Step, section};

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "bgr",
        when: "red and blue change places",
        sees: book(
            "The colours are strange: what should be red is blue, and the other way round.",
        ),
        says: "A PNG file has red first.",
        change: |parts| parts.order = |[r, g, b]| [b, g, r],
        ..section::BYTES.mistake()
    },
    Mistake {
        name: "truncated",
        when: "the byte is cut off, not rounded",
        sees: book("It looks right, but half of all values are darker by one."),
        says: "255 · I is rounded to the nearest whole number: add 0.5 before the cut.",
        change: |parts| parts.byte = |i| (255.0 * i.clamp(0.0, 1.0)) as u8,
        ..section::BYTES.mistake()
    },
    Mistake {
        name: "times-256",
        when: "I is multiplied by nearly 256 and cut off",
        sees: book("It looks right, but some values are off by one."),
        says: "That is another rule, `(255.999 * I) as u8`, which many courses use; ours \
         rounds 255 · I.",
        change: |parts| parts.byte = |i| (255.999 * i.clamp(0.0, 1.0)) as u8,
        ..section::BYTES.mistake()
    },
    Mistake {
        name: "no-255",
        when: "the intensity becomes a byte without the 255",
        sees: book(
            "The picture is black, or so nearly black that you can't see a difference.",
        ),
        says: "Intensities run from 0 to 1 and bytes from 0 to 255.",
        change: |parts| parts.byte = |i| i.clamp(0.0, 1.0) as u8,
        ..section::BYTES.mistake()
    },
    Mistake {
        name: "gamma",
        when: "the colours are gamma-encoded, to the power of 1/2.2",
        sees: book(
            "The picture is too bright and pale, most of all where it should be dark.",
        ),
        says: "Here 255 · I is the byte, as OpenGL did in 2007; gamma is an exercise.",
        change: |parts| parts.byte = |i| rounded(i.clamp(0.0, 1.0).powf(1.0 / 2.2)),
        ..section::BYTES.mistake()
    },
    Mistake {
        name: "square-root",
        when: "the colours are gamma-encoded by a square root",
        sees: book(
            "The picture is too bright and pale, most of all where it should be dark.",
        ),
        says: "Here 255 · I is the byte; the root is a gamma of 2, which other courses use.",
        change: |parts| parts.byte = |i| rounded(i.clamp(0.0, 1.0).sqrt()),
        ..section::BYTES.mistake()
    },
    Mistake {
        name: "gamma-backwards",
        when: "the colours are taken to the power of 2.2",
        sees: book("The picture is too dark, and its colours are too strong."),
        says: "This is gamma the wrong way round, and here there should be none.",
        change: |parts| parts.byte = |i| rounded(i.clamp(0.0, 1.0).powf(2.2)),
        ..section::BYTES.mistake()
    },
    Mistake {
        name: "wraps",
        step: Step::Diffuse,
        when: "intensities above 1 wrap around to dark",
        sees: book("The brightest places have spots of a dark or garish colour."),
        says: "A byte counts from 255 on to 0: clamp the intensity to 0 … 1 before.",
        change: |parts| parts.byte = |i| (255.0 * i + 0.5) as i64 as u8,
        ..section::BYTES.mistake()
    },
];

fn rounded(intensity: f64) -> u8 {
    (255.0 * intensity + 0.5) as u8
}
