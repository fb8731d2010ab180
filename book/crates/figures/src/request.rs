//! What a page asks for about a figure.

use crate::AddressError;
use thiserror::Error;

/// A request about a figure.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureRequest {
    /// Describes the parameters and the handles.
    About,
    /// Sends everything that the page shows at these values.
    Show {
        /// The values of the parameters, by their names.
        values: Vec<(String, f64)>,
        /// The maximum number of columns of a picture, or None for as many as in the book.
        columns: Option<u32>,
    },
    /// Sends the same as `Show`, but without the drawing or the pixels.
    Read {
        /// The values of the parameters.
        values: Vec<(String, f64)>,
    },
    /// Drags a handle, then sends the same as `Show`. A probe doesn't change the picture, so
    /// nothing is drawn after a probe is dragged.
    Drag {
        /// The values of the parameters before the handle is dragged.
        values: Vec<(String, f64)>,
        /// The index of the handle in the reply to `About`.
        handle: u32,
        /// The position to which the handle is dragged.
        position: [f64; 2],
        /// The maximum number of columns of a picture, or None for as many as in the book.
        columns: Option<u32>,
    },
    /// Sends the name of the object at a position, or null.
    Pick {
        /// The values of the parameters.
        values: Vec<(String, f64)>,
        /// The position in the picture.
        position: [f64; 2],
    },
    /// Sends the same as `Show`, at the values of an address.
    Open {
        /// The address.
        address: String,
    },
}

/// Why there is no reply to a request about a figure.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FigureRequestError {
    /// No figure has this name.
    #[error("There is no figure “{0}”.")]
    UnknownFigure(String),
    /// The figure has no handle with this index.
    #[error("This figure has no handle {0}.")]
    UnknownHandle(u32),
    /// The figure isn't an editable scene.
    #[error("This figure has no objects to pick.")]
    NoObjects,
    /// A picture can't have this many columns.
    #[error("A picture can't have {0} columns.")]
    Columns(u32),
    /// The figure can't have these values.
    #[error(transparent)]
    Address(#[from] AddressError),
}
