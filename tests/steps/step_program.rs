use course::{Step, target_folder, workspace};
use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::Once;
use std::{env, fs, process};

/// The program of a step, run in a folder of its own, which is deleted in the end.
pub struct StepProgram {
    /// The name of the step, and of its program.
    pub step: &'static str,
    /// The folder in which the program runs.
    pub folder: PathBuf,
}

impl StepProgram {
    /// Builds the programs of the steps, once, and makes an empty folder for the test `test`.
    pub fn new(step: &'static str, test: &str) -> Self {
        static BUILD: Once = Once::new();
        BUILD.call_once(build_programs);
        let folder = target_folder().join("tests");
        let folder = folder.join(format!("{step}-{test}-{}", process::id()));
        fs::create_dir_all(&folder).expect("a folder in the target folder");
        Self { step, folder }
    }

    /// Runs the program with these arguments, which are separated by single blanks.
    pub fn run(&self, arguments: &str) -> Output {
        let executable = target_folder().join("debug").join(self.step);
        let executable = executable.with_extension(env::consts::EXE_EXTENSION);
        let mut command = Command::new(&executable);
        command.args(arguments.split(' ').filter(|argument| !argument.is_empty()));
        // The width for which help is wrapped.
        let output = command.current_dir(&self.folder).env("COLUMNS", "100").output();
        output.unwrap_or_else(|error| panic!("{}: {error}", executable.display()))
    }

    /// The names of the files in the folder, sorted.
    pub fn file_names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.folder).expect("the folder of the test");
        let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
        let mut names: Vec<_> = names.collect();
        names.sort();
        names
    }
}

impl Drop for StepProgram {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// Builds the programs, as `cargo test` builds none of other packages.
///
/// `--workspace` gives them the features with which everything else is built.
fn build_programs() {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--workspace", "--target-dir"]).arg(target_folder());
    cargo.args(Step::NAMES.iter().flat_map(|name| ["--bin", name]));
    let status = cargo.env_remove("CARGO_BUILD_TARGET").current_dir(workspace()).status();
    assert!(status.is_ok_and(|status| status.success()), "the programs do not compile");
}
