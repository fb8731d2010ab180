use crate::fov::FOV;
use crate::measure::number;
use crate::{Cause, Step};
use std::fmt::Write;

/// The options, beside its size, that a picture may have been drawn with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Options {
    /// The field of view θ, in degrees.
    pub fov: f64,
    /// The side of the grid of rays in each pixel.
    pub samples: u32,
}

impl Options {
    /// Those of a locked picture.
    pub const NONE: Self = Self { fov: FOV, samples: 1 };

    /// Our picture of a step with these options.
    pub fn cause(self, step: Step) -> Cause {
        let Self { fov, samples } = self;
        Cause { step, samples, fov, mistakes: vec![] }
    }
}

/// Says both sizes, numbers of rays and fields of view where they differ, and the
/// options that give the right ones.
pub(crate) fn options(
    yours: (u32, u32),
    ours: (u32, u32),
    Options { fov, samples }: Options,
) -> String {
    let mut text = String::new();
    if yours != ours {
        let _ = writeln!(
            text,
            "It is {}×{} pixels, and the locked picture {}×{}: {} gives that size.",
            yours.0,
            yours.1,
            ours.0,
            ours.1,
            size(yours, ours)
        );
    }
    if 1 < samples {
        let _ = writeln!(
            text,
            "It has {samples}×{samples} rays a pixel, and the locked picture 1: \
             --samples 1 gives that."
        );
    }
    if fov != FOV {
        let _ = writeln!(
            text,
            "Its field of view is {}°, and that of the locked picture {1}°: --fov \
             {1} gives that. If you gave no such option, look at what becomes of θ, \
             in camera.rs and program.rs.",
            number(fov),
            number(FOV)
        );
    }
    text
}

/// The options that give the size of ours.
fn size((w, h): (u32, u32), (right_w, right_h): (u32, u32)) -> String {
    let is_shape = (u64::from(w) * u64::from(right_h))
        .abs_diff(u64::from(h) * u64::from(right_w))
        <= u64::from(right_w);
    let width = (w != right_w).then(|| format!("--width {right_w}"));
    let divisor = (1..=right_h).rev().find(|n| right_w % n + right_h % n == 0);
    let (x, y) = divisor.map_or((right_w, right_h), |n| (right_w / n, right_h / n));
    let aspect = (!is_shape || w == right_w).then(|| format!("--aspect {x}:{y}"));
    let options: Vec<_> = width.into_iter().chain(aspect).collect();
    options.join(" ")
}
