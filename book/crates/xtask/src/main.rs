//! Regenerates the checked-in files that are made from the code: the table and the small pictures
//! of the mistakes, and the WebAssembly modules for the book's pages.

mod error;
mod mistakes;
mod mistakes_program;
mod source_hash;
#[cfg(test)]
mod tests;
mod wasm_modules;

use course::target_folder;
use error::{XtaskError, XtaskResult};
use std::env;
use std::fs::File;
use std::process::ExitCode;

fn main() -> ExitCode {
    let Err(error) = regenerate() else {
        return ExitCode::SUCCESS;
    };
    eprintln!("error: {error}");
    ExitCode::FAILURE
}

/// Draws each mistake that lacks an up-to-date row in the table, or one of its small pictures.
/// Compiles the modules for the book's pages if the modules' sources have changed.
fn regenerate() -> XtaskResult<()> {
    if let Some(argument) = env::args_os().nth(1) {
        return Err(XtaskError::Argument(argument.display().to_string()));
    }
    let path = target_folder().join("xtask.lock");
    let lock = File::create(&path).map_err(XtaskError::of_file(&path))?;
    if lock.try_lock().is_err() {
        eprintln!("Another cargo xtask is running here; waiting for it to finish.");
        lock.lock().map_err(XtaskError::of_file(&path))?;
    }
    mistakes::draw_new_mistakes()?;
    wasm_modules::compile_if_stale()
}
