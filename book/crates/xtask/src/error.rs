//! What can go wrong in `cargo xtask`.

use course::LockedPictureError;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why something wasn't regenerated. The message is for whoever has run the command.
#[derive(Debug, Error)]
pub enum XtaskError {
    #[error("cargo xtask takes no arguments, and got {0}")]
    Argument(String),
    #[error("the code of the mistake \"{title}\" is {count} times in {file}, and not once")]
    MistakeNotOnce { title: &'static str, file: String, count: usize },
    #[error("{output}\nThe program that draws the mistakes doesn't run; it is in {}", .folder.display())]
    MistakesNotDrawn { output: String, folder: PathBuf },
    #[error("the module {0} doesn't compile")]
    ModuleNotCompiled(&'static str),
    #[error("{module}.wasm contains the path {} of this machine", .folder.display())]
    PathInModule { module: &'static str, folder: PathBuf },
    #[error(transparent)]
    LockedPicture(#[from] LockedPictureError),
    #[error("{}: {source}", .path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{program} doesn't run: {source}")]
    Program { program: &'static str, source: io::Error },
}

/// The result of something that `cargo xtask` does.
pub type XtaskResult<T> = Result<T, XtaskError>;

impl XtaskError {
    /// Adds the path of the file or folder to an error of the system.
    pub fn of_file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::File { path: path.to_owned(), source }
    }
}
