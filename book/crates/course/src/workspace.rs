//! The folders of the workspace, and a command of Cargo in it.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The modules of the pages. One draws the interactive figures, one looks at a reader's picture, and
/// one draws with lines that a reader edits.
pub const MODULES: [&str; 3] = ["live", "check", "expressions"];

/// The folder of the course, even if it was moved since this program was built.
///
/// Searched upwards from the package that Cargo runs, then from the current
/// folder and from the program.
pub fn workspace() -> PathBuf {
    let package = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let starts = [package, env::current_dir().ok(), env::current_exe().ok()];
    let parts = ["Cargo.toml", "steps", "tests/snapshots"];
    let is_workspace = |folder: &&Path| parts.iter().all(|part| folder.join(part).exists());
    let folder = starts.iter().flatten().find_map(|start| start.ancestors().find(is_workspace));
    let compiled = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../.."));
    folder.unwrap_or(compiled).to_owned()
}

/// The target folder, marked by Cargo, in which this program lies; that of the workspace
/// where the program was taken elsewhere.
pub fn target_folder() -> PathBuf {
    let program = env::current_exe().unwrap_or_default();
    let mut around = program.ancestors();
    let target = around.find(|folder| folder.join("CACHEDIR.TAG").is_file());
    target.map_or_else(|| workspace().join("target"), Path::to_owned)
}

/// A command of Cargo, the one that runs this program if there is one. It compiles for this
/// machine, so that the programs are in the folder `debug` itself.
pub fn cargo_command() -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    command.env_remove("CARGO_BUILD_TARGET");
    command
}
