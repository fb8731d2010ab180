//! Finds the project's folders, and prepares commands that run Cargo.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The WebAssembly modules that pages load: `live` draws the interactive figures, `check` examines
/// a reader's picture, and `expressions` draws the picture that results from the lines that a
/// reader has edited.
pub const WASM_MODULES: [&str; 3] = ["live", "check", "expressions"];

/// The root folder of the project, even if the folder was moved after this program was built.
///
/// We search upwards from the package that Cargo is running, then from the current folder, then
/// from this program's file. If none of these is inside the project, we return the path that the
/// root folder had when this program was built.
pub fn workspace() -> PathBuf {
    let package = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let starts = [package, env::current_dir().ok(), env::current_exe().ok()];
    let parts = ["Cargo.toml", "steps", "tests/snapshots"];
    let is_workspace = |folder: &&Path| parts.iter().all(|part| folder.join(part).exists());
    let folder = starts.iter().flatten().find_map(|start| start.ancestors().find(is_workspace));
    let compiled = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../.."));
    folder.unwrap_or(compiled).to_owned()
}

/// The target folder that contains this program. We recognise the folder by the file CACHEDIR.TAG,
/// which Cargo puts into every target folder. If the program was copied out of its target folder,
/// we return `target` in the workspace.
pub fn target_folder() -> PathBuf {
    let program = env::current_exe().unwrap_or_default();
    let mut around = program.ancestors();
    let target = around.find(|folder| folder.join("CACHEDIR.TAG").is_file());
    target.map_or_else(|| workspace().join("target"), Path::to_owned)
}

/// A command that runs Cargo. If Cargo is running this program, the command uses the same Cargo.
///
/// We remove the variable `CARGO_BUILD_TARGET`. If it were set, Cargo would put programs into
/// `target/TARGET/debug` instead of `target/debug`.
pub fn cargo_command() -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    command.env_remove("CARGO_BUILD_TARGET");
    command
}
