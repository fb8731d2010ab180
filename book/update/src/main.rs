//! Makes anew what is made from the code and checked in: the table and the small pictures of
//! the mistakes, then the modules of the book's pages, in which the table lies.

mod batch;
mod mistakes;
mod modules;

use clap::{Parser, value_parser};
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
    /// Only draw so many random mistakes, and compare them with the table
    #[arg(long, value_name = "COUNT", conflicts_with_all = ["words", "all"])]
    #[arg(value_parser = value_parser!(u16).range(1..))]
    sample: Option<u16>,
    /// Seed of the random choice; another each time by default
    #[arg(long, requires = "sample")]
    seed: Option<u64>,
}

fn main() -> ExitCode {
    let Err(error) = update_checked_in_files(&Options::parse()) else {
        return ExitCode::SUCCESS;
    };
    eprintln!("error: {error}");
    ExitCode::FAILURE
}

fn update_checked_in_files(options: &Options) -> Result<(), Box<dyn Error>> {
    if let Some(count) = options.sample {
        let seed = options.seed.unwrap_or_else(|| fastrand::u64(..));
        return mistakes::compare_sample(count.into(), seed);
    }
    // Minutes would be lost if this were told after the mistakes.
    modules::fail_without_wasm_target()?;
    mistakes::draw_outdated_and_chosen(|mistake| {
        let is_in = |word: &String| mistake.title.contains(word) || mistake.file.contains(word);
        options.all || options.words.iter().any(is_in)
    })?;
    modules::compile_modules()
}
