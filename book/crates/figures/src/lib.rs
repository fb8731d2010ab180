//! The interactive figures and pictures of the book: a figure is a function from its
//! parameters to a drawing, a picture one from scene and camera to pixels, by the steps'
//! own code.
//!
//! The builder prints what these functions give at the defaults. The page calls them,
//! compiled for the browser, when its reader moves something. Nothing here knows of the
//! book. The words of this crate:
//!
//! - a *figure* is a drawing with a caption, or a *picture*, whose pixels are rendered; its
//!   *output* is either. `FIGURES` lists all;
//! - a *parameter* is a number that the reader sets, by a *control* below the figure or by
//!   a handle; the *values* are those of all parameters, in their order, as they come from
//!   the page, without names;
//! - a *handle* is a mark in the figure that the reader drags; it sets one parameter or
//!   two;
//! - a *probe* is the handle that marks a pixel, whose *trace* is every number from its
//!   ray to its bytes;
//! - the *numbers* are those in the text that depend on the values;
//! - a *reply* is what a page gets for a request.

mod format;
pub use format::{format_count, short_name};
use format::{format_number, format_rounded, format_vector};

mod drawing;
mod output;
mod text_markup;
mod view;
pub use drawing::Drawing;
use output::collect_numbers;
pub use output::{Numbers, Output};
pub use text_markup::{escape, italic_letter};
use view::{View, direction_left_of_up};

mod discriminant;
pub use discriminant::discriminant;

mod aspect_ratio;
mod figure;
mod handle;
mod parameter;
mod probe;
pub use figure::Figure;
pub use handle::{Handle, Mark};
use parameter::array;
pub use parameter::{ControlKind, Parameter};

mod figures;
mod own_scene;
mod pictures;
pub use own_scene::parse_address;

mod figure_list;
mod reply;
pub use figure_list::{FIGURES, find};
pub use reply::{Reply, reply, rgba_bytes};
