//! The five steps: what their programs do, and what no number by hand and no picture holds.

mod programs;
mod step01_rays;
mod step02_sphere;
mod step03_nearest;
