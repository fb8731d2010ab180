//! What answers in the book: a figure is a function from its parameters to a
//! drawing, a picture one from scene and camera to pixels, by the steps' own code.
//!
//! The builder prints what these functions give at their defaults. The page calls
//! them, compiled for the browser, when its reader moves something. Nothing here knows
//! of the book. The words that this crate uses:
//!
//! - a *figure* is a drawing with a caption; a *picture* is rendered, and can be asked;
//! - a *knob* is a number that the reader sets, by a range or a switch below the figure;
//!   the *values* are those of all its knobs, in their order;
//! - a *handle* is a place in the figure that the reader drags; it turns two knobs;
//! - the *sight* is what there is to see at some values, the *numbers* are what the text
//!   says of them, and what is *printed* is both at the values of the book;
//! - *live* is what has all of these. `LIVE` lists it.

mod svg;
pub use svg::{Drawing, View, escape, italic};

mod quadratic;
pub use exercises::{camera, row::Row};
pub use quadratic::discriminant;

mod live;
pub use live::{Handle, Knob, Live, Numbers, Sight, number, vector};

mod figures;
mod own_scene;
mod pictures;
pub use own_scene::own_scene;
pub use pictures::short_name;

use std::sync::LazyLock;

/// Every figure, and every picture that answers.
pub static LIVE: LazyLock<Vec<Live>> = LazyLock::new(|| {
    let all = figures::all().into_iter().chain(pictures::all());
    all.chain([own_scene::live()]).collect()
});

/// What is called so.
pub fn find(name: &str) -> Option<&'static Live> {
    LIVE.iter().find(|live| live.name == name)
}

mod answer;
pub mod json;
pub use answer::{Answer, answer, rgba};
