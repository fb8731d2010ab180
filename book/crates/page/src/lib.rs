//! The WebAssembly modules that the book's pages call.
//!
//! `live` draws the figures. `check` examines a picture that a reader drops onto a page.
//! `expressions` draws the picture of a step after a reader has edited lines of the step's code.
//!
//! Each module is this package, compiled with one of its features. The modules are separate files,
//! because few readers need `check` and `expressions`.

#[cfg(feature = "check")]
mod check;
#[cfg(feature = "expressions")]
mod edit;
#[cfg(feature = "expressions")]
pub mod expressions;

// `#[unsafe(no_mangle)]` counts as unsafe code, because an unmangled name could clash with another
// symbol.
#[allow(unsafe_code)]
mod exports;

mod json;
mod request;

// The tests send every kind of request, so they need every feature.
#[cfg(all(test, feature = "check", feature = "expressions", feature = "live"))]
mod tests;

use figures::Reply;
pub use request::{EditedLine, Request, RequestError};

/// Replies to a request. For a request that needs no file, `file` is empty. If the request is
/// refused, the reply consists of the error.
pub fn reply(request: &str, file: &[u8]) -> Reply {
    let result = Request::parse(request).and_then(|request| try_reply(&request, file));
    result.unwrap_or_else(Reply::from_error)
}

/// Passes a request to the part of this package that replies to it.
pub fn try_reply(request: &Request, file: &[u8]) -> Result<Reply, RequestError> {
    match request {
        Request::Mistakes => {
            course::provide_mistake_files(str::from_utf8(file).unwrap_or_default());
            Ok(Reply::from_json_fields([]))
        }
        #[cfg(feature = "check")]
        Request::Check { file_name, picture } => {
            Ok(check::check(file, file_name, picture.as_deref()))
        }
        #[cfg(feature = "check")]
        Request::CheckScene { file_name, person } => {
            Ok(check::check_scene(file, file_name, person))
        }
        #[cfg(feature = "expressions")]
        Request::Edit { columns, lines } => edit::edit(*columns, lines),
        #[cfg(feature = "live")]
        Request::Figure { figure, request } => Ok(figures::reply(figure, request)?),
    }
}
