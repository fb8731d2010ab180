use crate::Difference;
use crate::locked::{locked, target};
use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::Once;
use std::{env, fs};

/// A program of one of the five steps, run in a folder of its own.
pub struct Program {
    name: &'static str,
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
        Self { name, folder: folder(&format!("{name}-{test}")) }
    }

    /// Runs it with the arguments in `line`, which are separated by blanks.
    pub fn run(&self, line: &str) -> Output {
        let path =
            profile().join(self.name).with_extension(env::consts::EXE_EXTENSION);
        let mut command = Command::new(&path);
        let run = command
            .args(line.split_whitespace())
            .current_dir(&self.folder)
            .output();
        run.unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    /// Fails unless, run without arguments, it writes the locked picture and
    /// nothing else.
    pub fn assert_writes_locked(&self) {
        let output = self.run("");
        assert!(output.status.success(), "{output:?}");
        let file = format!("{}.png", self.name);
        assert_eq!(self.files(), [file.as_str()]);
        let written =
            image::open(self.folder.join(&file)).expect("a PNG").to_rgb8();
        let difference = Difference::between(&locked(self.name), &written);
        assert_eq!(
            difference.map(|difference| difference.to_string()),
            None,
            "{file}"
        );
    }

    /// Fails unless `--help` and `--version` tell what they should, and write no file.
    pub fn assert_helps(&self) {
        let help = self.run("--help");
        let text = String::from_utf8_lossy(&help.stdout).into_owned();
        assert!(help.status.success() && help.stderr.is_empty(), "{help:?}");
        let own = format!("[default: {}.png]", self.name);
        for word in
            ["--width", "640", "--aspect", "16:9", "--fov", "60", "--samples", &own]
        {
            assert!(text.contains(word), "{word} is missing: {text}");
        }
        let version =
            String::from_utf8_lossy(&self.run("--version").stdout).into_owned();
        assert_eq!(
            version,
            format!("{} {}\n", self.name, env!("CARGO_PKG_VERSION"))
        );
        assert_eq!(self.files(), [""; 0]);
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

/// An empty folder in the target folder.
pub fn folder(name: &str) -> PathBuf {
    let folder = target().join("tests").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}

/// Builds the program `name` of this test's profile: `cargo test` does not.
///
/// With the features that the whole workspace asks for, as all else is built.
fn build(name: &str) {
    // The dev profile writes to the folder `debug`; every other one to its own name.
    let profile = match profile().file_name().and_then(|name| name.to_str()) {
        Some("debug") | None => "dev".to_owned(),
        Some(name) => name.to_owned(),
    };
    let status = Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--workspace", "--bin", name])
        .args(["--profile", &profile, "--target-dir"])
        .arg(target())
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status();
    let built = status.is_ok_and(|status| status.success());
    assert!(built, "cargo build --workspace --bin {name} fails");
}

/// The folder of this test program's profile in the target folder.
fn profile() -> PathBuf {
    let program = env::current_exe().expect("a running program has a path");
    program.ancestors().nth(2).expect("target/PROFILE/deps/program").to_owned()
}
