//! The gallery: in each file the mistakes of one stage, each a few lines that do one
//! thing wrong.

pub(crate) mod angle;
pub(crate) mod bytes;
pub(crate) mod intersect;
pub(crate) mod light;
pub(crate) mod matrix;
pub(crate) mod nearest;
pub(crate) mod phong;
pub(crate) mod ray;
pub(crate) mod shade;
