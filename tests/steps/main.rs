//! Tests of the five steps: of what their programs do, of the book's predictions about them, and of
//! cases that the worked numbers in `by_hand.rs` and the locked pictures don't cover.

mod predictions;
mod programs;
mod step01_rays;
mod step02_sphere;
mod step03_nearest;
