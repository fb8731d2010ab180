//! Builds the book, and opens it with `--open`.

use anyhow::Result;
use book::Course;
use clap::{Parser, Subcommand};
use compare::{target_folder, workspace};
use mdbook_preprocessor::Preprocessor;
use std::io::{Write, stderr, stdin, stdout};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Builds the book from its chapters, the five crates and the locked pictures.
#[derive(Parser)]
#[command(name = "cargo run --")]
struct Options {
    /// Open the book in the browser
    #[arg(long)]
    open: bool,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    /// Expand the chapters that mdBook writes to standard input: see book/book.toml
    Preprocess {
        /// What mdBook asks first: `supports`, and a renderer
        #[arg(hide = true)]
        question: Vec<String>,
    },
}

fn main() -> ExitCode {
    let options = Options::parse();
    let done = match &options.command {
        Some(Command::Preprocess { question }) if question.is_empty() => {
            preprocess()
        }
        Some(Command::Preprocess { .. }) => Ok(()),
        None => build(options.open),
    };
    let Err(error) = done else { return ExitCode::SUCCESS };
    let _ = writeln!(stderr(), "{error:#}");
    ExitCode::FAILURE
}

/// Reads the book that mdBook hands over, and writes it with its chapters expanded.
fn preprocess() -> Result<()> {
    let (context, book) = mdbook_preprocessor::parse_input(stdin())?;
    let book = Course.run(&context, book)?;
    Ok(serde_json::to_writer(stdout(), &book)?)
}

/// Builds the book, says what was built and where, and opens it if that is asked for.
fn build(is_opened: bool) -> Result<()> {
    let start = Instant::now();
    say("Building the book …");
    let folder = target_folder().join("book");
    let site = book::build(&workspace(), &folder)?;
    say(&format!(
        "Built {} chapters with {} listings, {} figures, {} pictures and {} formulas in {:.1} s.",
        site.chapters().len(),
        site.count(".listing"),
        site.count(".drawing"),
        site.count("img"),
        site.count("math"),
        start.elapsed().as_secs_f64(),
    ));
    let index = folder.join("index.html");
    say(&format!("It begins at {}", index.display()));
    let patience = Duration::from_secs(2);
    if is_opened && open::that_detached_with_timeout(&index, patience).is_err() {
        say("There is no browser here to open it with.");
    }
    Ok(())
}

/// Writes a line. Where nobody listens any more, the book is built all the same.
fn say(line: &str) {
    let _ = writeln!(stdout(), "{line}");
}
