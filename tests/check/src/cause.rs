use crate::{Mistake, Parts, Step, mistakes};
use step01_rays::Camera;

/// How a picture may have come about: a step, its options, and up to two mistakes.
#[derive(Clone, Debug)]
pub struct Cause {
    /// Whose picture it is.
    pub step: Step,
    /// The side of the grid of rays in each pixel.
    pub samples: u32,
    /// The field of view θ, in degrees.
    pub fov: f64,
    /// What went wrong; nothing, if the picture is right.
    pub mistakes: Vec<&'static Mistake>,
}

impl Cause {
    /// Every cause in `step` that takes `count` mistakes, 0 to 2, one ray a pixel.
    pub(crate) fn all(step: Step, count: usize, fov: f64) -> Vec<Self> {
        let known: Vec<_> = mistakes().filter(|m| m.section.step <= step).collect();
        let cause = |mistakes: &[_]| Self {
            step,
            samples: 1,
            fov,
            mistakes: mistakes.into(),
        };
        match count {
            0 => vec![cause(&[])],
            1 => known.iter().map(|&one| cause(&[one])).collect(),
            _ => (known.iter().enumerate())
                .flat_map(|(k, &one)| {
                    known[k + 1..].iter().map(move |&two| cause(&[one, two]))
                })
                .collect(),
        }
    }

    /// The parts that draw it.
    pub fn parts(&self, (width, height): (u32, u32)) -> Parts {
        let mut parts =
            Parts::right(&Camera::new(width, height, self.fov.to_radians()));
        for mistake in &self.mistakes {
            (mistake.change)(&mut parts);
        }
        parts
    }
}
