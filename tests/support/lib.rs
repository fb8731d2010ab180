//! Helpers that the tests share: locked pictures, programs of the steps, rays and random
//! geometry.

mod picture_list;
mod picture_snapshot;
mod program_texts;
mod random_inputs;
mod step_program;

pub use course::camera;
pub use picture_list::{LockedPicture, locked_pictures};
pub use picture_snapshot::{compare_pixels, read_snapshot};
pub use program_texts::assert_program_works;
pub use random_inputs::{
    primary_rays, random_point, random_sphere, random_sphere_and_ray, random_unit_vector,
};
pub use step_program::StepProgram;
