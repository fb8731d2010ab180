//! The book's interactive figures, drawn by the steps' own code.
//!
//! A [`Figure`] shows a *drawing*, which has lines and labels, or a *picture*, which has pixels. A
//! function computes the drawing or picture from the values of the figure's named *parameters*. For
//! a drawing, the builder calls this function with the default values, and writes the result into
//! the page. When a reader moves a *handle* or a control, the page calls the same function,
//! compiled for the browser: the page sends a [`FigureRequest`] and gets a [`Reply`].
//!
//! *Readouts* are texts elsewhere on the page. These texts depend on the values, too. The *trace*
//! of a pixel consists of all numbers from the pixel's ray to its bytes. A *probe* is a handle that
//! selects the pixel.
//!
//! This crate doesn't read the book's chapters. However, a drawing's caption is written like a
//! chapter: in Markdown, with directives such as `{{#number row:D}}`. The builder expands the
//! directives.

mod format;
pub use format::{format_count, short_name};
use format::{format_number, format_vector, format_with_max_decimals};

mod drawing;
mod label_box;
mod shading;
mod text_markup;
mod view;
pub use drawing::{Drawing, WIDTH};
pub use label_box::LabelBox;
pub use shading::Shading;
use shading::TO_LIGHT;
pub use text_markup::italic_letter;
use view::{View, direction_left_of_up};

mod figure;
mod handle;
mod parameter;
mod parameter_values;
mod probe;
use figure::collect_readouts;
pub use figure::{Content, EditableScene, Figure, Readouts, row_readout_name};
pub use handle::{Handle, Mark};
pub use parameter::{Axis, Parameter, ParameterKind};
pub use parameter_values::{ParameterId, ParameterValues, PointId};

mod figures;
mod own_scene;
mod pictures;

mod figure_list;
pub use figure_list::{FIGURES, find_figure};

mod address;
mod reply;
mod request;
pub use address::{AddressError, format_address, parse_address};
pub use reply::{COLUMNS, Reply, reply, rgba_bytes};
pub use request::{FigureRequest, FigureRequestError};
