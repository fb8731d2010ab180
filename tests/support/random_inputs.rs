//! Random inputs for laws that hold for all of them.

use fastrand::Rng;
use glam::DVec3;

/// Random inputs, which are the same in every run.
pub struct RandomInputs(Rng);

/// Calls a law this many times. A law asserts what holds for all inputs.
pub fn test_law(count: usize, mut law: impl FnMut(&mut RandomInputs)) {
    let mut inputs = RandomInputs(Rng::with_seed(5));
    (0..count).for_each(|_| law(&mut inputs));
}

impl RandomInputs {
    /// A number between two others.
    pub fn number(&mut self, min: f64, max: f64) -> f64 {
        min + (max - min) * self.0.f64()
    }

    /// A whole number below `end`.
    pub fn index(&mut self, end: usize) -> usize {
        self.0.usize(..end)
    }

    /// A point within 10 of the origin along each axis.
    pub fn point(&mut self) -> DVec3 {
        [(); 3].map(|()| self.number(-10.0, 10.0)).into()
    }

    /// A vector of length 1.
    pub fn unit_vector(&mut self) -> DVec3 {
        self.point().normalize_or(DVec3::X)
    }
}
