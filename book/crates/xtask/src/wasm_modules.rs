//! The WebAssembly modules for the book's pages. Each module is the package `page`, compiled with
//! one of the package's features. The modules are checked in, so that nobody needs a second
//! compilation target to build the book. The file modules.txt contains a hash of the modules'
//! sources, and the version of the compiler.

use crate::error::{XtaskError, XtaskResult};
use crate::source_hash::hash_wasm_module_sources;
use course::{WASM_MODULES, cargo_command, target_folder, workspace};
use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

const TARGET: &str = "wasm32-unknown-unknown";

/// Whether the sources have changed since the modules were compiled.
pub fn are_stale() -> XtaskResult<bool> {
    let text = fs::read_to_string(page_package_folder().join("modules.txt")).unwrap_or_default();
    Ok(text.split(' ').next() != Some(&*hash_wasm_module_sources()?))
}

/// Compiles the modules if they are stale.
pub fn compile_if_stale() -> XtaskResult<()> {
    if !are_stale()? {
        return Ok(());
    }
    let hash = hash_wasm_module_sources()?;
    for name in WASM_MODULES {
        let module = compile_module(name)?;
        if let Some(folder) = find_local_folder(&module) {
            return Err(XtaskError::PathInModule { module: name, folder });
        }
        println!("{name}.wasm: {} bytes", module.len());
        let path = page_package_folder().join(format!("{name}.wasm"));
        fs::write(&path, module).map_err(XtaskError::of_file(&path))?;
    }
    let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
    let output = Command::new(rustc).arg("--version").output();
    let output = output.map_err(|source| XtaskError::Program { program: "rustc", source })?;
    let text = format!("{hash} {}", String::from_utf8_lossy(&output.stdout));
    let path = page_package_folder().join("modules.txt");
    fs::write(&path, text).map_err(XtaskError::of_file(&path))
}

/// Compiles the package `page` with the feature `name`. Returns the bytes of the WebAssembly
/// module.
fn compile_module(name: &'static str) -> XtaskResult<Vec<u8>> {
    let sources = registry_source_folders().into_iter().chain([target_folder(), workspace()]);
    let flags: Vec<_> =
        sources.map(|path| format!("--remap-path-prefix={}=", path.display())).collect();
    let folder = target_folder().join("wasm");
    // A page has only one thread, so a small crate in the folder `rayon` replaces the real rayon.
    let replacement = format!("paths=[{:?}]", page_package_folder().join("rayon"));
    let status = cargo_command()
        .args(["rustc", "--locked", "--config", &replacement])
        .args(["--package", "page", "--lib", "--profile", "wasm"])
        .args(["--no-default-features", "--features", name])
        .args(["--target", TARGET, "--crate-type", "cdylib", "--target-dir"])
        .arg(&folder)
        .args(["--", "-C", "strip=symbols", "-C", "link-arg=--compress-relocations"])
        .env("CARGO_ENCODED_RUSTFLAGS", flags.join("\x1f"))
        .current_dir(workspace())
        .status()
        .map_err(|source| XtaskError::Program { program: "cargo", source })?;
    if !status.success() {
        return Err(XtaskError::ModuleNotCompiled(name));
    }
    let path = folder.join(TARGET).join("wasm/page.wasm");
    fs::read(&path).map_err(XtaskError::of_file(&path))
}

/// Looks for the paths of the workspace, the target folder and Cargo's home in a module. Returns a
/// folder whose path the module contains. These paths differ from machine to machine, so a module
/// with such a path would differ, too. Paths of the standard library's sources are allowed, because
/// they depend on the compiler's version and not on the machine.
fn find_local_folder(module: &[u8]) -> Option<PathBuf> {
    let folders = [workspace(), target_folder(), cargo_home()];
    folders.into_iter().find(|folder| {
        let path = folder.as_os_str().as_encoded_bytes();
        module.windows(path.len()).any(|part| part == path)
    })
}

/// The folder of the package `page`. The compiled modules are in this folder.
pub fn page_package_folder() -> PathBuf {
    workspace().join("book/crates/page")
}

fn cargo_home() -> PathBuf {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    home.unwrap_or_else(|| env::home_dir().unwrap_or_default().join(".cargo"))
}

/// Returns the folders in which Cargo keeps the sources of packages. Each registry has its own
/// folder.
fn registry_source_folders() -> Vec<PathBuf> {
    let folders = fs::read_dir(cargo_home().join("registry/src"));
    folders.into_iter().flatten().flatten().map(|folder| folder.path()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn local_folder_is_found_in_a_module() {
        assert_eq!(find_local_folder(b"\0asm /rust/deps/dlmalloc-0.2.11/src/lib.rs"), None);
        let path = workspace().join("steps/step01_rays/src/lib.rs");
        let module = [b"\0asm ", path.as_os_str().as_encoded_bytes(), b" expect"].concat();
        assert_eq!(find_local_folder(&module), Some(workspace()));
    }
}
