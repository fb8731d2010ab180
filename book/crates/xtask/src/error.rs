//! What can go wrong in `cargo xtask`.

use course::{LockedPictureError, MistakeListError};
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why the command failed. The message is for whoever ran the command.
#[derive(Debug, Error)]
pub enum XtaskError {
    #[error("cargo xtask takes no arguments, but got {0}")]
    Argument(String),
    #[error(transparent)]
    MistakeList(#[from] MistakeListError),
    #[error(
        "the code of the mistake \"{title}\" must appear once in {file}, but appears {count} times"
    )]
    MistakeNotOnce { title: &'static str, file: String, count: usize },
    #[error("{output}\nThe program that draws the mistakes has failed. Its package is in {}", .folder.display())]
    MistakesNotDrawn { output: String, folder: PathBuf },
    #[error("the module {0} doesn't compile")]
    ModuleNotCompiled(&'static str),
    #[error("{module}.wasm contains a path of this machine: {}", .folder.display())]
    PathInModule { module: &'static str, folder: PathBuf },
    #[error(transparent)]
    LockedPicture(#[from] LockedPictureError),
    #[error("{}: {source}", .path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{program} can't be run: {source}")]
    Program { program: &'static str, source: io::Error },
}

/// A result whose error is an [`XtaskError`].
pub type XtaskResult<T> = Result<T, XtaskError>;

impl XtaskError {
    /// Returns a function that adds the path of a file or folder to an I/O error.
    pub fn of_file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::File { path: path.to_owned(), source }
    }
}
