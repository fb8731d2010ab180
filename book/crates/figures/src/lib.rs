//! The figures and pictures of the book that answer: a figure is a function from its
//! parameters to a drawing, a picture one from scene and camera to pixels, by the steps'
//! own code.
//!
//! The builder prints what these functions give at the defaults. The page calls them,
//! compiled for the browser, when its reader moves something. Nothing here knows of the
//! book. The words of this crate:
//!
//! - a *figure* is a drawing with a caption; a *picture* is rendered; the *output* is
//!   either;
//! - a *parameter* is a number that the reader sets, by a control below the figure or by
//!   a handle; the *values* are those of all parameters, in their order: they come from
//!   the page without names, and get names or a type at once;
//! - a *handle* is a mark in the figure that the reader drags; it sets two parameters;
//! - a *probe* is the handle that marks a pixel, whose *trace* is every number from its
//!   ray to its bytes;
//! - the *numbers* are those in the text that depend on the values;
//! - a figure or picture that has parameters is *live*. `LIVE` lists all.

mod format;
pub use format::{
    format_column, format_count, format_fixed, format_number, format_rounded, format_vector,
};

mod drawing;
mod text_markup;
mod view;
pub use drawing::Drawing;
pub use text_markup::{escape, italic_letter};
pub use view::{View, degrees_left_of_up};

mod discriminant;
pub use course::{camera, examples::row::Row};
pub use discriminant::discriminant;

mod figure;
mod handle;
mod parameter;
mod probe;
pub use figure::{Companion, Live, Numbers, Output};
pub use handle::{Handle, Mark};
pub use parameter::{Kind, Parameter};

mod figures;
mod own_scene;
mod pictures;
pub use own_scene::own_scene;
pub use pictures::short_name;

use std::sync::LazyLock;

/// Every figure and every picture, in the order of the book.
pub static LIVE: LazyLock<Vec<Live>> = LazyLock::new(|| {
    let steps = figures::all().into_iter().chain(pictures::all());
    steps.chain([own_scene::picture()]).collect()
});

/// The figure or picture of this name.
pub fn find(name: &str) -> Option<&'static Live> {
    LIVE.iter().find(|live| live.name == name)
}

mod reply;
pub use reply::{Answer, answer, rgba_bytes};
