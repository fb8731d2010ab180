//! The five steps: what their programs do, what the book predicts of their runs, and what neither
//! the worked numbers of `by_hand.rs` nor a locked picture would notice.

mod predictions;
mod programs;
mod step01_rays;
mod step02_sphere;
mod step03_nearest;
