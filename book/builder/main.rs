//! Builds the book, and opens it with `--open`.

use anyhow::{Result, bail};
use clap::Parser;
use std::io::{Write, stderr, stdout};
use std::process::ExitCode;
use std::time::Instant;

/// Builds the book from its chapters, the five crates and the locked pictures.
#[derive(Parser)]
#[command(name = "cargo run --")]
struct Options {
    /// Open the book in the browser
    #[arg(long)]
    open: bool,
    /// What the mdbook program asks
    #[arg(hide = true)]
    question: Vec<String>,
}

fn main() -> ExitCode {
    let Err(error) = run(Options::parse()) else { return ExitCode::SUCCESS };
    let _ = writeln!(stderr(), "{error:#}");
    ExitCode::FAILURE
}

fn run(Options { open, question }: Options) -> Result<()> {
    let question: Vec<_> = question.iter().map(String::as_str).collect();
    match question[..] {
        [] => build(open),
        ["preprocess"] => book::answer(),
        ["preprocess", "supports", _] => Ok(()),
        _ => bail!("allowed are no argument, which builds the book, and --open"),
    }
}

/// Builds the book, says what was built and where, and opens it if `open` is set.
fn build(open: bool) -> Result<()> {
    let start = Instant::now();
    say("Building the book …");
    let (folder, site) = book::build(&compare::workspace().join("book"))?;
    say(&format!(
        "Built {} chapters with {} listings, {} figures, {} pictures and {} formulas in {:.1} s.",
        site.chapters().len(),
        site.count("figure", "listing"),
        site.count("figure", "drawing"),
        site.count("img", ""),
        site.count("math", ""),
        start.elapsed().as_secs_f64(),
    ));
    let index = folder.join("index.html");
    say(&format!("It begins at {}", index.display()));
    if open && !book::open(&index) {
        say("There is no browser here to open it with.");
    }
    Ok(())
}

/// Writes a line. Where nobody listens any more, the book is built all the same.
fn say(line: &str) {
    let _ = writeln!(stdout(), "{line}");
}
