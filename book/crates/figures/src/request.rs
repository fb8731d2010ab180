//! The requests that a page makes about a figure.

use crate::AddressError;
use thiserror::Error;

/// A request about a figure.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureRequest {
    /// Asks for a description of the parameters and the handles.
    About,
    /// Asks for everything that the page shows for these values.
    Show {
        /// The names of parameters, each with a value.
        values: Vec<(String, f64)>,
        /// The maximum number of columns of a picture, or None for as many as in the book.
        columns: Option<u32>,
    },
    /// Asks for the same as `Show`, but without the drawing or the pixels.
    Read {
        /// The values of the parameters.
        values: Vec<(String, f64)>,
    },
    /// Drags a handle, then asks for the same as `Show`. If the handle is a probe, asks for the
    /// same as `Read` instead, because dragging a probe doesn't change the picture.
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
    /// Asks for the name of the object at a position. The name is null if there is no object.
    Pick {
        /// The values of the parameters.
        values: Vec<(String, f64)>,
        /// The position in the picture.
        position: [f64; 2],
    },
    /// Asks for the same as `Show`, with the values in an address.
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
