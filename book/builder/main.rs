//! Builds the book, and opens it with `--open`.

use anyhow::{Result, bail};
use std::path::Path;
use std::process::ExitCode;
use std::{env, time::Instant};

fn main() -> ExitCode {
    match run(env::args().skip(1).collect()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error:#}");
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
    println!("Building the book …");
    let built = book::build(Path::new(env!("CARGO_MANIFEST_DIR")))?;
    let index = built.folder.join("index.html");
    println!(
        "Built {} chapters with {} listings, {} figures, {} pictures and {} formulas in {:.1} s.",
        built.chapters,
        built.listings,
        built.figures,
        built.pictures,
        built.formulas,
        start.elapsed().as_secs_f64(),
    );
    println!("It begins at {}", index.display());
    if open && !book::open(&index) {
        println!("There is no browser here to open it with.");
    }
    Ok(())
}
