//! Compiles this package for the browser, once for what answers in the pages, once for
//! `check` and once for the pictures that it compares with, and writes `live.wasm`,
//! `check.wasm` and `pictures.wasm` beside it. They are checked in: who builds the book
//! needs no second target.

use std::error::Error;
use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::{env, fs};

const TARGET: &str = "wasm32-unknown-unknown";

/// The modules: each is a feature of the package, with flags of its own for the
/// compiler. The largest is to have few copies of small functions.
const MODULES: [(&str, &str); 3] = [
    ("live", ""),
    ("pictures", ""),
    (
        "check",
        "-C llvm-args=-inline-threshold=25 -C llvm-args=-inlinehint-threshold=10",
    ),
];

fn main() -> ExitCode {
    let Err(error) = MODULES.into_iter().try_for_each(compile) else {
        return ExitCode::SUCCESS;
    };
    eprintln!("{error}");
    ExitCode::FAILURE
}

/// Compiles the package with one of its features.
fn compile((feature, flags): (&str, &str)) -> Result<(), Box<dyn Error>> {
    let folder = env::current_dir()?.join("target/wasm");
    let cargo = env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    // No path of this machine stands in what is checked in.
    let own = sources().into_iter();
    let own = own.map(|path| format!("--remap-path-prefix={}=", path.display()));
    let flags = flags.split_whitespace().map(str::to_owned).chain(own);
    let flags: Vec<_> = flags.collect();
    let status = Command::new(cargo)
        .args(["rustc", "--package", "wasm", "--lib", "--profile", "wasm"])
        .args(["--no-default-features", "--features", feature])
        .args(["--target", TARGET, "--crate-type", "cdylib", "--target-dir"])
        .arg(&folder)
        .args([
            "--",
            "-C",
            "strip=symbols",
            "-C",
            "link-arg=--compress-relocations",
        ])
        .env("CARGO_ENCODED_RUSTFLAGS", flags.join("\x1f"))
        .status()?;
    if !status.success() {
        return Err(format!("the module {feature} does not compile").into());
    }
    let module = folder.join(TARGET).join("wasm/wasm.wasm");
    let path = format!("book/wasm/{feature}.wasm");
    let bytes = fs::copy(module, &path)?;
    println!("{path}: {bytes} bytes");
    Ok(())
}

/// Where Cargo keeps the sources of packages: a folder for each registry.
fn sources() -> Vec<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let own = || env::home_dir().unwrap_or_default().join(".cargo");
    let folders = fs::read_dir(home.unwrap_or_else(own).join("registry/src"));
    folders.into_iter().flatten().flatten().map(|folder| folder.path()).collect()
}
