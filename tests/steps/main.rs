//! Tests of the five steps: what their programs do, what the book predicts about their pictures,
//! and cases that neither the worked numbers in `by_hand.rs` nor the locked pictures cover.

mod predictions;
mod programs;
mod step01_rays;
mod step02_sphere;
mod step03_nearest;
