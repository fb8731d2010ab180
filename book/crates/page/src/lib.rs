//! The WebAssembly modules that the book's pages call.
//!
//! `live` draws the figures, `check` examines a picture that a reader drops onto a page, and
//! `expressions` draws with the lines that a reader edits. Each is a feature of this package and a
//! file of its own, because few readers need the second and the third.

#[cfg(feature = "check")]
mod check;
#[cfg(feature = "expressions")]
mod edit;
#[cfg(feature = "expressions")]
pub mod expressions;

// `#[unsafe(no_mangle)]` counts as unsafe code, because the name could clash with another.
#[allow(unsafe_code)]
mod exports;

use figures::Reply;

/// Replies to a request. The request `mistakes` brings the list of mistakes in `file`, because its
/// texts aren't compiled into any module. A request that starts with `check` or `edit` goes to the
/// function of that name, and any other to [`figures::reply`].
pub fn reply(request: &str, file: &[u8]) -> Reply {
    match request.split_once(' ') {
        None if request == "mistakes" => {
            course::provide_mistake_texts(str::from_utf8(file).unwrap_or_default());
            Reply::from_json_fields([])
        }
        #[cfg(feature = "check")]
        Some(("check", words)) => check::check(words, file),
        #[cfg(feature = "expressions")]
        Some(("edit", words)) => edit::edit(words),
        #[cfg(feature = "live")]
        _ => figures::reply(request),
        #[cfg(not(feature = "live"))]
        _ => Reply::default(),
    }
}
