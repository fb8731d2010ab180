//! Builds the book and, with `--open`, opens it in a browser.

use anyhow::{Result, anyhow};
use builder::ChapterPreprocessor;
use course::{target_folder, workspace};
use mdbook_preprocessor::Preprocessor;
use std::env;
use std::io::{Write, stderr, stdin, stdout};
use std::process::ExitCode;
use std::time::{Duration, Instant};

fn main() -> ExitCode {
    let arguments: Vec<_> = env::args_os().skip(1).collect();
    let words: Vec<_> = arguments.iter().map(|word| word.to_str().unwrap_or_default()).collect();
    let result = match words[..] {
        [] => build_and_report(false),
        ["--open"] => build_and_report(true),
        // book/book.toml tells mdBook to run this program with the argument `preprocess`. First,
        // mdBook adds `supports` and an output format, to ask whether this program supports that
        // format. Then mdBook runs the program again, and sends the book.
        ["preprocess", "supports", _] => Ok(()),
        ["preprocess"] => preprocess_stdin(),
        _ => Err(anyhow!("Usage: cargo run -- [--open], where --open opens the book in a browser")),
    };
    let Err(error) = result else { return ExitCode::SUCCESS };
    let _ = writeln!(stderr(), "{error:#}");
    ExitCode::FAILURE
}

/// Reads the book that mdBook sends to stdin, expands the chapters, and writes the book to stdout.
fn preprocess_stdin() -> Result<()> {
    let (context, book) = mdbook_preprocessor::parse_input(stdin())?;
    let book =
        ChapterPreprocessor::read_sources_and_write_generated(&workspace())?.run(&context, book)?;
    Ok(serde_json::to_writer(stdout(), &book)?)
}

/// Builds the book, prints progress, and opens the book if `opens_browser` is true. Ignores errors
/// while printing, so that the book is built even if the output has been closed.
fn build_and_report(opens_browser: bool) -> Result<()> {
    let start = Instant::now();
    let _ = writeln!(stdout(), "Building the book …");
    let folder = target_folder().join("book");
    let site = builder::build(&workspace(), &folder)?;
    let (count, time) = (site.pages_in_order().len(), start.elapsed());
    let index = folder.join("index.html");
    let page = index.display();
    let _ = writeln!(stdout(), "Built {count} chapters in {time:.1?}.\nThe first page is {page}");
    let patience = Duration::from_secs(2);
    if opens_browser && open::that_detached_with_timeout(&index, patience).is_err() {
        let _ = writeln!(stdout(), "No browser could be started to open it.");
    }
    Ok(())
}
