//! Helpers that the tests share: locked pictures, programs of the steps, rays and random
//! geometry.

mod assert_snapshot;
mod invalid_arguments;
mod picture_list;
mod random_inputs;
mod step_program;

pub use assert_snapshot::{assert_matches_snapshot, read_snapshot};
pub use course::camera;
pub use picture_list::{LockedPicture, locked_pictures};
pub use random_inputs::{
    primary_rays, random_point, random_sphere, random_sphere_and_ray, random_unit_vector,
};
pub use step_program::{StepProgram, assert_program_works};
