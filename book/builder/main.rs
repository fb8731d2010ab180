//! Builds the book, and opens it with `--open`.

use anyhow::{Result, bail};
use std::env;
use std::io::{Write, stderr, stdout};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let arguments = env::args_os().skip(1);
    match run(arguments.map(|word| word.to_string_lossy().into_owned()).collect()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(stderr(), "{error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Does what the arguments ask for.
fn run(arguments: Vec<String>) -> Result<()> {
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        [] => build(false),
        ["--open"] => build(true),
        ["preprocess"] => book::answer(),
        ["preprocess", "supports", _] => Ok(()),
        _ => {
            bail!(
                "allowed are no argument, which builds the book, and --open, which opens it too"
            )
        }
    }
}

/// Builds the book, says what was built and where, and opens it if `open` is set.
fn build(open: bool) -> Result<()> {
    let start = Instant::now();
    say("Building the book …");
    let built = book::build(Path::new(env!("CARGO_MANIFEST_DIR")))?;
    let index = built.folder.join("index.html");
    say(&format!(
        "Built {} chapters with {} listings, {} figures, {} pictures and {} formulas in {:.1} s.",
        built.chapters,
        built.listings,
        built.figures,
        built.pictures,
        built.formulas,
        start.elapsed().as_secs_f64(),
    ));
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
