//! The modules of the book's pages: the package `page`, compiled for the browser with one feature
//! each. They are checked in, so that nobody needs a second target to build the book; modules.txt
//! has a hash of what they were made from, and the compiler.

use crate::source_hash::source_hash;
use course::{MODULES, cargo_command, target_folder, workspace};
use std::error::Error;
use std::path::PathBuf;
use std::process::Command;
use std::{env, fs, io};

const TARGET: &str = "wasm32-unknown-unknown";

/// The roots of paths on machines: no module has one in it.
const ROOTS: [&str; 7] = ["/rustc/", "/rust/", "/usr/", "/home/", "/root/", "/Users/", "/tmp/"];

/// Whether the modules were made from other sources than those of today.
pub fn are_stale() -> io::Result<bool> {
    let text = fs::read_to_string(page_folder().join("modules.txt")).unwrap_or_default();
    Ok(text.split(' ').next() != Some(&*source_hash()?))
}

/// Compiles the modules, if they are stale.
pub fn compile_if_stale() -> Result<(), Box<dyn Error>> {
    if !are_stale()? {
        return Ok(());
    }
    let hash = source_hash()?;
    for name in MODULES {
        let mut module = compile(name)?;
        hide_paths(&mut module).map_err(|path| format!("{name}.wasm has the path {path}"))?;
        println!("{name}.wasm: {} bytes", module.len());
        fs::write(page_folder().join(format!("{name}.wasm")), module)?;
    }
    let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
    let version = Command::new(rustc).arg("--version").output()?.stdout;
    let text = format!("{hash} {}", String::from_utf8_lossy(&version));
    Ok(fs::write(page_folder().join("modules.txt"), text)?)
}

fn compile(name: &str) -> Result<Vec<u8>, Box<dyn Error>> {
    let sources = registry_source_folders().into_iter().chain([target_folder(), workspace()]);
    let flags: Vec<_> =
        sources.map(|path| format!("--remap-path-prefix={}=", path.display())).collect();
    let folder = target_folder().join("wasm");
    let status = cargo_command()
        .args(["rustc", "--locked", "--package", "page", "--lib", "--profile", "wasm"])
        .args(["--no-default-features", "--features", name])
        .args(["--target", TARGET, "--crate-type", "cdylib", "--target-dir"])
        .arg(&folder)
        .args(["--", "-C", "strip=symbols", "-C", "link-arg=--compress-relocations"])
        .env("CARGO_ENCODED_RUSTFLAGS", flags.join("\x1f"))
        .current_dir(workspace())
        .status()?;
    if !status.success() {
        return Err(format!("the module {name} does not compile").into());
    }
    Ok(fs::read(folder.join(TARGET).join("wasm/page.wasm"))?)
}

/// Writes over where the compiler's own library was compiled: no option changes that. Any other
/// path of a machine is an error.
fn hide_paths(module: &mut [u8]) -> Result<(), String> {
    for start in 0..module.len() {
        if ROOTS.iter().any(|root| module[start..].starts_with(root.as_bytes())) {
            let path = &mut module[start..];
            let end = path.windows(9).take(100).position(|part| part == b"/library/");
            let end = end.ok_or_else(|| path[..path.len().min(20)].escape_ascii().to_string())?;
            path[..end].fill(b'-');
        }
    }
    Ok(())
}

fn page_folder() -> PathBuf {
    workspace().join("book/crates/page")
}

/// The folders of the packages' sources, one for each registry.
fn registry_source_folders() -> Vec<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let default = || env::home_dir().unwrap_or_default().join(".cargo");
    let folders = fs::read_dir(home.unwrap_or_else(default).join("registry/src"));
    folders.into_iter().flatten().flatten().map(|folder| folder.path()).collect()
}
