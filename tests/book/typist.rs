use crate::listing::Listing;
use anyhow::{Context, Result, bail, ensure};
use book::Files;
use gallery::workspace;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};
use tests::{Difference, locked, target};

/// The crates, in the order in which a reader writes them.
pub const STEPS: [&str; 5] = [
    "step01_rays",
    "step02_sphere",
    "step03_nearest",
    "step04_diffuse",
    "step05_phong",
];

/// A reader's workspace: what the book shows, and nothing else.
pub struct Typist {
    pub folder: PathBuf,
}

impl Typist {
    /// Moves every file out of the crates, until the book shows it.
    ///
    /// A file that is moved keeps its time, so Cargo has nothing to do for it.
    pub fn put_aside(&self) -> Result<()> {
        let steps = self.folder.join("steps");
        fs::create_dir_all(&steps)?;
        for path in Files::read(&steps)?.0.keys() {
            rename(&steps.join(path), &self.folder.join("later/steps").join(path))?;
        }
        Ok(fs::remove_dir_all(&steps)?)
    }

    /// Writes the files that the book has shown so far.
    ///
    /// A part of a file goes where its caption says.
    pub fn write(&self, files: &BTreeMap<&str, Vec<Listing>>) -> Result<()> {
        for (path, parts) in files {
            let mut parts: Vec<_> = parts.iter().collect();
            parts.sort_by_key(|part| part.lines());
            let lines = parts.iter().flat_map(|part| part.code.split('\n'));
            let text: String = lines.flat_map(|line| [line, "\n"]).collect();
            let aside = self.folder.join("later").join(path);
            let path = self.folder.join(path);
            if aside.is_file() {
                rename(&aside, &path)?;
            }
            if fs::read_to_string(&path).ok().as_ref() != Some(&text) {
                fs::create_dir_all(path.with_file_name(""))?;
                fs::write(path, text)?;
            }
        }
        fs::copy(workspace().join("Cargo.lock"), self.folder.join("Cargo.lock"))?;
        Ok(())
    }

    /// Says what is wrong with the workspace now that the chapter of `step` is typed.
    pub fn check(&self, step: &str) -> Result<()> {
        let program = self.folder.join("target/debug").join(step);
        let program = program.with_extension(env::consts::EXE_EXTENSION);
        // What an earlier run left does not count.
        let _ = fs::remove_file(&program);
        let mut cargo = self.cargo(&["build", "--bins"]);
        if self.folder.join("steps").join(step).join("benches").is_dir() {
            cargo.args(["--bench", "*"]);
        }
        build(cargo)?;
        let lock = |folder: &Path| fs::read_to_string(folder.join("Cargo.lock"));
        let (ours, theirs) = (lock(&workspace())?, lock(&self.folder)?);
        if let Some(package) = packages(&theirs).difference(&packages(&ours)).next()
        {
            bail!("Cargo takes a package not in our lock: {package}");
        }
        self.compare(&program, step)
    }

    /// Says what is wrong with these examples, and with all that are typed by now.
    pub fn check_examples(&self, names: &BTreeSet<&str>) -> Result<()> {
        build(self.cargo(&["build", "--bins", "--examples"]))?;
        let programs = self.folder.join("target/debug/examples");
        names.iter().try_for_each(|name| {
            let program = programs.join(name);
            self.compare(&program.with_extension(env::consts::EXE_EXTENSION), name)
        })
    }

    /// Says which group of a table of contents needs a later one, or which numbers by
    /// hand do not compile: each group ends an example, a crate of its own.
    pub fn check_groups(&self) -> Result<()> {
        for step in STEPS {
            let (folder, mut root) =
                (self.folder.join("steps").join(step), String::new());
            fs::create_dir_all(folder.join("examples"))?;
            let whole = fs::read_to_string(folder.join("src/lib.rs"))?;
            for (number, group) in whole.split("\n\n").enumerate() {
                for line in group.lines() {
                    if let Some(name) = line.strip_prefix("mod ") {
                        let file = name.replace(';', ".rs");
                        root += &format!("#[path = \"../src/{file}\"]\n");
                    }
                    root += &format!("{line}\n");
                }
                let example = folder.join(format!("examples/{step}_{number}.rs"));
                fs::write(example, format!("{root}fn main() {{}}\n"))?;
            }
        }
        let what = ["check", "--example", "step*_?", "--test", "by_hand"];
        build(self.cargo(&what))
    }

    /// Compares the picture that `program` writes with the locked one of its name.
    fn compare(&self, program: &Path, name: &str) -> Result<()> {
        let file = self.folder.join(format!("{name}.png"));
        let _ = fs::remove_file(&file);
        let _ = Command::new(program).current_dir(&self.folder).output();
        let picture = image::open(file);
        let picture = picture.with_context(|| format!("no program {name}"))?;
        match Difference::between(&locked(name), &picture.to_rgb8()) {
            Some(how) => bail!("{name} draws another picture: {how}"),
            None => Ok(()),
        }
    }

    /// Cargo in the reader's folder, told to do `what`.
    fn cargo(&self, what: &[&str]) -> Command {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(what).args([
            "--offline",
            "--quiet",
            "--message-format",
            "short",
        ]);
        cargo.args(["--target-dir", "target"]).current_dir(&self.folder);
        // What the crates depend on is compiled already, for ours. As the crates have
        // the names of ours, a setting of their own keeps them apart.
        cargo.env("CARGO_BUILD_BUILD_DIR", target());
        // So that the programs are where we look for them.
        cargo.env_remove("CARGO_BUILD_TARGET");
        for step in STEPS {
            let setting = format!("profile.dev.package.{step}.opt-level=0");
            cargo.args(["--config", &setting]);
        }
        cargo
    }
}

/// Moves a file into a folder that need not be there.
fn rename(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to.with_file_name(""))?;
    Ok(fs::rename(from, to)?)
}

/// Builds, or tells why Cargo does not, in its own words.
fn build(mut cargo: Command) -> Result<()> {
    let output = cargo.output()?;
    let text = String::from_utf8_lossy(&output.stderr);
    let error = text.lines().find(|line| line.contains("error")).unwrap_or(&text);
    ensure!(output.status.success(), "Cargo says: {error}");
    Ok(())
}

/// The packages in a lock file, each with its version.
fn packages(lock: &str) -> BTreeSet<String> {
    let lines = |package: &str| {
        package.trim().lines().take(2).collect::<Vec<_>>().join(" ")
    };
    lock.split("[[package]]").skip(1).map(lines).collect()
}

#[test]
fn packages_of_another_version_are_others() {
    let lock =
        |version: &str| format!("[[package]]\nname = \"a\"\nversion = {version}\n");
    let (old, new) = (lock("1.0.0"), lock("1.0.1"));
    assert_eq!(packages(&format!("{old}\n{new}")).len(), 2);
    assert_eq!(packages(&old).difference(&packages(&new)).count(), 1);
}
