//! Helpers that the tests share: locked pictures, programs of the steps, rays and random
//! geometry.

mod inputs;
mod invalid_arguments;
mod locked_pictures;
mod snapshots;
mod step_program;

pub use exercises::camera;
pub use inputs::{
    primary_rays, random_point, random_sphere, random_sphere_and_ray,
    random_unit_vector,
};
pub use locked_pictures::{LockedPicture, locked_pictures};
pub use snapshots::{assert_matches_snapshot, read_snapshot};
pub use step_program::{StepProgram, assert_program_works};
