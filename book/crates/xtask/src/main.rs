//! Regenerates what is made from the code and checked in: the table and the small pictures of
//! the mistakes, and the modules of the book's pages.

mod mistake_program;
mod mistakes;
mod modules;
mod source_hash;
#[cfg(test)]
mod tests;

use course::target_folder;
use std::env;
use std::error::Error;
use std::fs::File;
use std::process::ExitCode;

fn main() -> ExitCode {
    let Err(error) = regenerate() else {
        return ExitCode::SUCCESS;
    };
    eprintln!("error: {error}");
    ExitCode::FAILURE
}

/// Draws the mistakes whose code or right picture has changed, and compiles the modules of the
/// book's pages if their code has changed.
fn regenerate() -> Result<(), Box<dyn Error>> {
    if let Some(argument) = env::args().nth(1) {
        return Err(format!("cargo xtask takes no arguments, and got {argument}").into());
    }
    let lock = File::create(target_folder().join("xtask.lock"))?;
    if lock.try_lock().is_err() {
        eprintln!("Another cargo xtask is running here; waiting for it to finish.");
        lock.lock()?;
    }
    mistakes::draw_unknown()?;
    modules::compile_if_stale()
}
