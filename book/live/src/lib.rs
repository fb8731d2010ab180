//! What answers in the book: a figure is a function from its parameters to a
//! drawing, a picture one from scene and camera to pixels, by the steps' own code.
//!
//! The builder prints what these functions give at their defaults. The page calls
//! them, compiled for the browser, when its reader moves something. Nothing here knows
//! of the book.

mod svg;
pub use svg::{Drawing, View, escape, italic};

mod common;
pub use common::{camera, discriminant, roots};

mod live;
pub use live::{Handle, Knob, Live, Numbers, Sight};

pub use exercises::row::Row;

mod figures;
pub use figures::{Figure, figure, names};

mod pictures;
pub use pictures::{NAMES, rgba};

mod address;
mod scene;
pub use scene::own_scene;

/// Everything that answers.
pub const LIVE: [&Live; 16] = [
    &figures::RAY,
    &figures::ROW,
    &figures::FRUSTUM,
    &figures::THREE_CASES,
    &figures::HITS,
    &figures::EGGS,
    &figures::LAMBERT,
    &figures::ATTENUATION,
    &figures::PHONG_VECTORS,
    &figures::LOBES,
    &pictures::STEP01,
    &pictures::STEP02,
    &pictures::STEP03,
    &pictures::STEP04,
    &pictures::STEP05,
    &scene::OWN_SCENE,
];

/// What answers to this name.
pub fn find(name: &str) -> Option<&'static Live> {
    LIVE.into_iter().find(|live| live.name == name)
}

mod answer;
pub mod json;
pub use answer::{Answer, answer};
