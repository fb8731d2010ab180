//! The five steps: what their programs do, and the mathematics as laws.

mod step01_rays;
mod step02_sphere;
mod step03_nearest;
mod step04_diffuse;
mod step05_phong;

use course::Step;
use tests::assert_program_works;

#[test]
fn programs_draw_the_locked_pictures_and_reject_invalid_arguments() {
    Step::NAMES.into_iter().for_each(assert_program_works);
}
