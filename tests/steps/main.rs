//! The five steps: what their programs do, and the mathematics as laws.

mod programs;
mod step01_rays;
mod step02_sphere;
