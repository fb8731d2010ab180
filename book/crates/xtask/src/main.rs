//! Regenerates what is made from the code and checked in: the table and the small pictures of
//! the mistakes, and the modules of the book's pages.

mod mistake_program;
mod mistakes;
mod modules;
mod source_hash;
#[cfg(test)]
mod tests;

use clap::Parser;
use course::target_folder;
use std::error::Error;
use std::fs::File;
use std::process::ExitCode;

/// Draws the mistakes whose code or right picture has changed, and compiles the modules of the
/// book's pages whose code has changed.
#[derive(Parser)]
struct Options {
    /// Also draw the mistakes that have one of these words in their title or file
    words: Vec<String>,
    /// Draw all mistakes
    #[arg(long)]
    all: bool,
}

fn main() -> ExitCode {
    let Err(error) = regenerate(&Options::parse()) else {
        return ExitCode::SUCCESS;
    };
    eprintln!("error: {error}");
    ExitCode::FAILURE
}

fn regenerate(options: &Options) -> Result<(), Box<dyn Error>> {
    modules::fail_without_wasm_target()?;
    let lock = File::create(target_folder().join("xtask.lock"))?;
    if lock.try_lock().is_err() {
        eprintln!("Another cargo xtask is running here; waiting for it to finish.");
        lock.lock()?;
    }
    mistakes::draw_unknown_and_chosen(|mistake| {
        let is_in = |word: &String| mistake.title.contains(word) || mistake.file.contains(word);
        options.all || options.words.iter().any(is_in)
    })?;
    modules::compile_stale_modules()
}
