//! Makes anew what is made from the code and checked in: the table and the small pictures of
//! the mistakes, then the modules of the book's pages, in which the table lies.

mod batch;
mod mistakes;
mod modules;

use clap::Parser;
use std::error::Error;
use std::process::ExitCode;

/// Draws the mistakes whose text, file or right picture has changed, then compiles the
/// modules of the book's pages.
#[derive(Parser)]
struct Options {
    /// Draw the mistakes that have one of these words in their title or file, too
    words: Vec<String>,
    /// Draw all mistakes
    #[arg(long)]
    all: bool,
}

fn main() -> ExitCode {
    let Err(error) = update_checked_in_files(&Options::parse()) else {
        return ExitCode::SUCCESS;
    };
    eprintln!("error: {error}");
    ExitCode::FAILURE
}

fn update_checked_in_files(options: &Options) -> Result<(), Box<dyn Error>> {
    // Minutes would be lost if this were told after the mistakes.
    modules::fail_without_wasm_target()?;
    mistakes::draw_outdated_and_chosen(|mistake| {
        let is_in = |word: &String| mistake.title.contains(word) || mistake.file.contains(word);
        options.all || options.words.iter().any(is_in)
    })?;
    modules::compile_modules()
}
