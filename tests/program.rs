use crate::locked;
use crate::refusals;
use compare::{Difference, target_folder, workspace};
use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::Once;
use std::{env, fs, process};

/// A program of one of the five steps, run in a folder of its own.
pub struct Program {
    /// Its step.
    pub name: &'static str,
    /// The folder in which it runs.
    pub folder: PathBuf,
}

impl Program {
    /// The program of the step `name`, in an empty folder for the test `test`.
    ///
    /// Builds it once: a test program may run that of one step only.
    pub fn new(name: &'static str, test: &str) -> Self {
        static BUILT: Once = Once::new();
        BUILT.call_once(|| build(name));
        let folder = target_folder().join("tests");
        let folder = folder.join(format!("{name}-{test}-{}", process::id()));
        fs::create_dir_all(&folder).expect("a folder in the target folder");
        Self { name, folder }
    }

    /// Runs it with the arguments in `line`, which are separated by single blanks.
    pub fn run(&self, line: &str) -> Output {
        let path = self.path();
        let mut command = Command::new(&path);
        let arguments = line.split(' ').filter(|argument| !argument.is_empty());
        let run = command.args(arguments).current_dir(&self.folder).output();
        run.unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    /// The file of the program.
    pub fn path(&self) -> PathBuf {
        profile().join(self.name).with_extension(env::consts::EXE_EXTENSION)
    }

    /// The names of the files in its folder, sorted.
    pub fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.folder).expect("the folder of the test");
        let names = entries
            .flatten()
            .map(|entry| entry.file_name().to_string_lossy().into_owned());
        let mut names: Vec<_> = names.collect();
        names.sort();
        names
    }
}

/// Fails unless the program of the step `name` writes the locked picture and nothing
/// else, says what it can be told, and refuses what it can't draw.
pub fn assert_program(name: &'static str) {
    let program = Program::new(name, "draws");
    let help = program.run("--help");
    let text = String::from_utf8_lossy(&help.stdout).into_owned();
    assert!(help.status.success() && help.stderr.is_empty(), "{help:?}");
    let options = "--width 640 --aspect 16:9 --fov 60 --samples --output";
    for word in options.split(' ').chain([name]) {
        assert!(text.contains(word), "{word} is missing: {text}");
    }
    assert_eq!(program.files(), [""; 0]);
    let output = program.run("");
    assert!(output.status.success(), "{output:?}");
    assert_eq!(program.files(), [format!("{name}.png")]);
    let written = image::open(program.folder.join(format!("{name}.png")));
    let written = written.expect("a PNG").to_rgb8();
    let difference = Difference::between(&locked(name), &written);
    assert!(difference.is_none(), "{name}.png: {}", difference.unwrap());
    refusals::assert_refuses(&Program::new(name, "bad"));
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// Builds the program `name` for this test's platform and profile: `cargo test` does not.
///
/// With the features that the whole workspace asks for, as all else is built.
fn build(name: &str) {
    let (folder, target) = (profile(), target_folder());
    let inside =
        folder.strip_prefix(&target).expect("a folder in the target folder");
    let inside = inside.to_str().expect("Cargo's own names").replace('\\', "/");
    let (platform, profile) = inside.split_once('/').unwrap_or(("", &inside));
    // The dev profile writes to the folder `debug`; every other one to its own name.
    let profile = if profile == "debug" { "dev" } else { profile };
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--workspace", "--bin", name]);
    cargo.args(["--profile", profile, "--target-dir"]).arg(&target);
    if platform.is_empty() {
        cargo.env_remove("CARGO_BUILD_TARGET");
    } else {
        cargo.args(["--target", platform]);
    }
    let built = cargo.current_dir(workspace()).status();
    let built = built.is_ok_and(|status| status.success());
    assert!(built, "cargo build --workspace --bin {name} fails");
}

/// The folder of this test program's profile: target/debug, or target/PLATFORM/debug.
fn profile() -> PathBuf {
    let program = env::current_exe().expect("a running program has a path");
    program.ancestors().nth(2).expect("PROFILE/deps/program").to_owned()
}
