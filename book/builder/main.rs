//! Builds the book, and opens it with `--open`.

use anyhow::Result;
use clap::Parser;
use compare::{target_folder, workspace};
use std::io::{Write, stderr, stdout};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Builds the book from its chapters, the five crates and the locked pictures.
#[derive(Parser)]
#[command(name = "cargo run --")]
struct Options {
    /// Open the book in the browser
    #[arg(long)]
    open: bool,
}

fn main() -> ExitCode {
    let Err(error) = run(&Options::parse()) else { return ExitCode::SUCCESS };
    let _ = writeln!(stderr(), "{error:#}");
    ExitCode::FAILURE
}

/// Builds the book, says what was built and where, and opens it if that is asked for.
fn run(options: &Options) -> Result<()> {
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
    if options.open && open::that_detached_with_timeout(&index, patience).is_err() {
        say("There is no browser here to open it with.");
    }
    Ok(())
}

/// Writes a line. Where nobody listens any more, the book is built all the same.
fn say(line: &str) {
    let _ = writeln!(stdout(), "{line}");
}
