//! The five steps of the course.

/// A step of the course. A later step is greater than an earlier step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// `step01_rays`.
    Rays,
    /// `step02_sphere`.
    Sphere,
    /// `step03_nearest`.
    Nearest,
    /// `step04_diffuse`.
    Diffuse,
    /// `step05_phong`.
    Phong,
}

impl Step {
    /// All steps, in order.
    pub const ALL: [Self; 5] =
        [Self::Rays, Self::Sphere, Self::Nearest, Self::Diffuse, Self::Phong];

    /// The names of all steps, in order.
    pub const NAMES: [&str; 5] =
        ["step01_rays", "step02_sphere", "step03_nearest", "step04_diffuse", "step05_phong"];

    /// The step's number, from 1 to 5.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// The step's name, which is also the name of its crate, its first chapter and its locked
    /// picture.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// Finds the step with this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|step| step.name() == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn step_is_found_by_its_name() {
        for (number, step) in (1..).zip(Step::ALL) {
            assert_eq!((step.number(), Step::from_name(step.name())), (number, Some(step)));
            assert!(step.name().starts_with(&format!("step0{number}_")));
        }
        assert_eq!(Step::from_name("step06_way_back"), None);
    }
}
