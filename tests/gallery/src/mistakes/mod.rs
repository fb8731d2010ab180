//! The gallery: in each file the mistakes of one stage, each a few lines that do one
//! thing wrong.

use crate::Mistake;

mod angle;
mod bytes;
mod intersect;
mod light;
mod matrix;
mod nearest;
mod phong;
mod ray;
mod shade;

/// Every mistake of the gallery, in the order of the steps' files.
///
/// Where two are made at once, the earlier comes first: angles before mirror images.
pub fn mistakes() -> impl Iterator<Item = &'static Mistake> {
    let stages = [
        angle::ALL,
        matrix::ALL,
        ray::ALL,
        bytes::ALL,
        intersect::ALL,
        nearest::ALL,
        light::ALL,
        shade::ALL,
        phong::ALL,
    ];
    stages.into_iter().flatten()
}
