//! The interactive figures and pictures of the book: a figure is a function from its
//! parameters to a drawing, a picture one from scene and camera to pixels, by the steps'
//! own code.
//!
//! The builder prints what these functions give at the defaults. The page calls them,
//! compiled for the browser, when its reader moves something. Nothing here knows of the
//! book. Each is a [`Figure`]. Its *values* are those of all its parameters, in their order,
//! as they come from the page, without names. The *trace* of a picture's pixel is every number
//! from its ray to its bytes.

mod format;
pub use format::{format_count, short_name};
use format::{format_number, format_rounded, format_vector};

mod drawing;
mod text_markup;
mod view;
pub use drawing::Drawing;
pub use text_markup::{escape, italic_letter};
use view::{View, direction_left_of_up};

mod figure;
mod handle;
mod parameter;
mod probe;
use figure::collect_numbers;
pub use figure::{Figure, Numbers, Output};
pub use handle::{Handle, Mark};
use parameter::array;
pub use parameter::{ControlKind, Parameter};

mod figures;
mod own_scene;
mod pictures;
pub use own_scene::parse_address;
pub use pictures::discriminant;

mod figure_list;
mod reply;
pub use figure_list::{FIGURES, find};
pub use reply::{Reply, reply, rgba_bytes};
