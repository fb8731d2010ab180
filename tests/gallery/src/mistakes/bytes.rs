//! Mistakes on the way from an intensity to three bytes.

use crate::{Mistake, Parts, Step, section};

pub(crate) const ALL: &[Mistake] = &[
    wrong(
        Step::Rays,
        "bgr",
        "red and blue change places",
        "The colours are strange: what should be red is blue, and the other way round.",
        "A PNG file has red first.",
        |parts| parts.order = |[r, g, b]| [b, g, r],
    ),
    wrong(
        Step::Rays,
        "truncated",
        "the byte is cut off, not rounded",
        "It looks right, but half of all values are darker by one.",
        "255 · I is rounded to the nearest whole number: add 0.5 before the cut.",
        |parts| parts.byte = |i| (255.0 * i.clamp(0.0, 1.0)) as u8,
    ),
    wrong(
        Step::Rays,
        "times-256",
        "I is multiplied by nearly 256 and cut off",
        "It looks right, but some values are off by one.",
        "That is another rule, `(255.999 * I) as u8`, which many courses use; ours \
         rounds 255 · I.",
        |parts| parts.byte = |i| (255.999 * i.clamp(0.0, 1.0)) as u8,
    ),
    wrong(
        Step::Rays,
        "no-255",
        "the intensity becomes a byte without the 255",
        "The picture is black, or so nearly black that you can't see a difference.",
        "Intensities run from 0 to 1 and bytes from 0 to 255.",
        |parts| parts.byte = |i| i.clamp(0.0, 1.0) as u8,
    ),
    wrong(
        Step::Rays,
        "gamma",
        "the colours are gamma-encoded, to the power of 1/2.2",
        "The picture is too bright and pale, most of all where it should be dark.",
        "Here 255 · I is the byte, as OpenGL did in 2007; gamma is an exercise.",
        |parts| parts.byte = |i| rounded(i.clamp(0.0, 1.0).powf(1.0 / 2.2)),
    ),
    wrong(
        Step::Rays,
        "square-root",
        "the colours are gamma-encoded by a square root",
        "The picture is too bright and pale, most of all where it should be dark.",
        "Here 255 · I is the byte; the root is a gamma of 2, which other courses use.",
        |parts| parts.byte = |i| rounded(i.clamp(0.0, 1.0).sqrt()),
    ),
    wrong(
        Step::Rays,
        "gamma-backwards",
        "the colours are taken to the power of 2.2",
        "The picture is too dark, and its colours are too strong.",
        "This is gamma the wrong way round, and here there should be none.",
        |parts| parts.byte = |i| rounded(i.clamp(0.0, 1.0).powf(2.2)),
    ),
    wrong(
        Step::Diffuse,
        "wraps",
        "intensities above 1 wrap around to dark",
        "The brightest places have spots of a dark or garish colour.",
        "A byte counts from 255 on to 0: clamp the intensity to 0 … 1 before.",
        |parts| parts.byte = |i| (255.0 * i + 0.5) as i64 as u8,
    ),
];

fn rounded(intensity: f64) -> u8 {
    (255.0 * intensity + 0.5) as u8
}

const fn wrong(
    step: Step,
    name: &'static str,
    when: &'static str,
    sees: &'static str,
    says: &'static str,
    change: fn(&mut Parts),
) -> Mistake {
    let (file, section) = ("steps/step01_rays/src/colour.rs", section::BYTES);
    Mistake { name, step, file, section, when, sees, says, change }
}
