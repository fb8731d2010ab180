//! Compiles the package `wasm` for the browser: a module of what answers in the pages, one of
//! `check`, and one of the lines that a reader edits. They are checked in, as who builds the
//! book needs no second target.

use course::{target_folder, workspace};
use std::error::Error;
use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

const TARGET: &str = "wasm32-unknown-unknown";

/// The modules: each is a feature of the package.
const MODULES: [&str; 3] = ["live", "check", "expressions"];

/// Fails where this machine can't compile for the browser.
pub fn fail_without_wasm_target() -> Result<(), Box<dyn Error>> {
    let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
    let arguments = ["--print", "target-libdir", "--target", TARGET];
    let output = Command::new(rustc).args(arguments).output()?;
    let folder = String::from_utf8_lossy(&output.stdout);
    if output.status.success() && fs::exists(folder.trim())? {
        return Ok(());
    }
    Err(format!("Rust's target for the browser is missing: `rustup target add {TARGET}`").into())
}

/// Compiles all modules; Cargo knows what has changed.
pub fn compile_modules() -> Result<(), Box<dyn Error>> {
    // No path of this machine stands in what is checked in.
    let paths = registry_source_folders().into_iter().chain([target_folder()]);
    let paths: Vec<_> =
        paths.map(|path| format!("--remap-path-prefix={}=", path.display())).collect();
    for feature in MODULES {
        let folder = target_folder().join("wasm");
        let status = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()))
            .args(["rustc", "--package", "wasm", "--lib", "--profile", "wasm"])
            .args(["--no-default-features", "--features", feature])
            .args(["--target", TARGET, "--crate-type", "cdylib", "--target-dir"])
            .arg(&folder)
            .args(["--", "-C", "strip=symbols", "-C", "link-arg=--compress-relocations"])
            .env("CARGO_ENCODED_RUSTFLAGS", paths.join("\x1f"))
            .current_dir(workspace())
            .status()?;
        if !status.success() {
            return Err(format!("the module {feature} does not compile").into());
        }
        let path = format!("book/crates/page/{feature}.wasm");
        let module = fs::read(folder.join(TARGET).join("wasm/wasm.wasm"))?;
        let is_new = fs::read(workspace().join(&path)).ok().as_ref() != Some(&module);
        if is_new {
            fs::write(workspace().join(&path), &module)?;
        }
        println!("{path}: {} bytes{}", module.len(), if is_new { ", new" } else { "" });
    }
    Ok(())
}

/// The folders of the packages' sources, one for each registry.
fn registry_source_folders() -> Vec<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let default = || env::home_dir().unwrap_or_default().join(".cargo");
    let folders = fs::read_dir(home.unwrap_or_else(default).join("registry/src"));
    folders.into_iter().flatten().flatten().map(|folder| folder.path()).collect()
}
