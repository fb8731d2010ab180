//! Random inputs, for testing laws that hold for every input.

use fastrand::Rng;
use glam::DVec3;

/// A source of random inputs. Its seed is fixed, so every run gets the same inputs.
#[derive(Debug)]
pub struct RandomInputs(Rng);

/// Calls `law` with random inputs `count` times. `law` asserts something that holds for every
/// input.
pub fn test_law(count: usize, mut law: impl FnMut(&mut RandomInputs)) {
    let mut inputs = RandomInputs(Rng::with_seed(5));
    (0..count).for_each(|_| law(&mut inputs));
}

impl RandomInputs {
    /// Returns a number between `min` and `max`.
    pub fn number(&mut self, min: f64, max: f64) -> f64 {
        min + (max - min) * self.0.f64()
    }

    /// Returns an index below `end`.
    pub fn index(&mut self, end: usize) -> usize {
        self.0.usize(..end)
    }

    /// Returns a point whose coordinates are between −10 and 10.
    pub fn point(&mut self) -> DVec3 {
        [(); 3].map(|()| self.number(-10.0, 10.0)).into()
    }

    /// Returns a vector of length 1.
    pub fn unit_vector(&mut self) -> DVec3 {
        self.point().normalize_or(DVec3::X)
    }
}
