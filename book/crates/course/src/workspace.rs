//! Where the project is, and how to run Cargo there.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The modules of the pages: `live` draws what is interactive, `check` looks at a reader's picture,
/// and `expressions` draws with the lines that a reader edits.
pub const MODULES: [&str; 3] = ["live", "check", "expressions"];

/// The folder of the project, even if it was moved after this program was built.
///
/// It is searched for upwards from the package that Cargo runs, then from the current folder and
/// from the program.
pub fn workspace() -> PathBuf {
    let package = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let starts = [package, env::current_dir().ok(), env::current_exe().ok()];
    let parts = ["Cargo.toml", "steps", "tests/snapshots"];
    let is_workspace = |folder: &&Path| parts.iter().all(|part| folder.join(part).exists());
    let folder = starts.iter().flatten().find_map(|start| start.ancestors().find(is_workspace));
    let compiled = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../.."));
    folder.unwrap_or(compiled).to_owned()
}

/// The target folder that this program is in, which Cargo marks by a file, or that of the workspace
/// if the program was copied elsewhere.
pub fn target_folder() -> PathBuf {
    let program = env::current_exe().unwrap_or_default();
    let mut around = program.ancestors();
    let target = around.find(|folder| folder.join("CACHEDIR.TAG").is_file());
    target.map_or_else(|| workspace().join("target"), Path::to_owned)
}

/// A command that starts Cargo, the one that runs this program if there is one. It compiles for
/// this machine, so the programs are directly in the folder `debug`.
pub fn cargo_command() -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    command.env_remove("CARGO_BUILD_TARGET");
    command
}
