//! The interactive pictures, each drawn by its step or example.

mod mirror;
mod pixel_trace;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

use crate::Figure;

/// The picture of each step, and the mirrors.
pub fn all() -> [Figure; 6] {
    [
        Figure::of::<step01::Rays>(),
        Figure::of::<step02::OneSphere>(),
        Figure::of::<step03::FlatSpheres>(),
        Figure::of::<step04::MovedLights>(),
        Figure::of::<step05::SwitchedTerms>(),
        Figure::of::<mirror::Mirrors>(),
    ]
}
