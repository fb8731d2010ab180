//! Finds the project's folders, and prepares a command that runs Cargo there.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The WebAssembly modules that pages load: `live` draws the interactive figures, `check` examines
/// a reader's picture, and `expressions` draws with the lines that a reader edits.
pub const WASM_MODULES: [&str; 3] = ["live", "check", "expressions"];

/// The root folder of the project, even if it was moved after this program was built.
///
/// We search upwards from the package that Cargo is running, then from the current folder, then
/// from the program. If none of them is inside the project, we return the root folder at the time
/// of the build.
pub fn workspace() -> PathBuf {
    let package = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let starts = [package, env::current_dir().ok(), env::current_exe().ok()];
    let parts = ["Cargo.toml", "steps", "tests/snapshots"];
    let is_workspace = |folder: &&Path| parts.iter().all(|part| folder.join(part).exists());
    let folder = starts.iter().flatten().find_map(|start| start.ancestors().find(is_workspace));
    let compiled = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../.."));
    folder.unwrap_or(compiled).to_owned()
}

/// The target folder that contains this program, recognised by the tag file that Cargo puts there.
/// If the program was copied to a place outside any target folder, returns `target` in the
/// workspace.
pub fn target_folder() -> PathBuf {
    let program = env::current_exe().unwrap_or_default();
    let mut around = program.ancestors();
    let target = around.find(|folder| folder.join("CACHEDIR.TAG").is_file());
    target.map_or_else(|| workspace().join("target"), Path::to_owned)
}

/// A command that runs Cargo: the same Cargo that runs this program, if one does.
///
/// The variable `CARGO_BUILD_TARGET` is removed: if it were set, Cargo would put programs into a
/// folder named after that target instead of directly into `debug`.
pub fn cargo_command() -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    command.env_remove("CARGO_BUILD_TARGET");
    command
}
