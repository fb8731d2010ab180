use super::listing::joined;
use super::reading::{Asked, FAILED};
use super::typed::Typed;
use anyhow::{Context, Result, bail, ensure};
use book::Files;
use compare::{Difference, target_folder, workspace};
use image::RgbImage;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use tests::locked;

/// The crates, in the order in which a reader writes them.
pub const STEPS: [&str; 5] = {
    let [rays, sphere, nearest, diffuse, phong] = exercises::STEPS;
    [rays.0, sphere.0, nearest.0, diffuse.0, phong.0]
};

/// The manifest of the states.
const STATES: &str = "
    package = { name = \"states\", edition.workspace = true }
    [dependencies]
    clap.workspace = true
    glam.workspace = true
    image.workspace = true
    rayon.workspace = true
    step01_rays = { path = \"../step01_rays\" }
    step02_sphere = { path = \"../step02_sphere\" }
    step03_nearest = { path = \"../step03_nearest\" }
    step04_diffuse = { path = \"../step04_diffuse\" }
";

/// A crate as a page shows it at some place, under a name of its own.
pub struct State {
    pub name: String,
    /// The text of each file of its folder `src`, but for its program.
    pub files: BTreeMap<String, String>,
}

/// A reader's workspace: what the book shows, and nothing else.
pub struct Typist {
    folder: PathBuf,
    /// Locked, so that another process waits until this one has done.
    _lock: File,
}

impl Typist {
    /// A workspace from which every file is put aside, until the book shows it.
    ///
    /// A file that is moved keeps its time, so Cargo has nothing to do for it.
    pub fn new() -> Self {
        let folder = target_folder().join("typed");
        let (steps, later) = (folder.join("steps"), folder.join("later/steps"));
        let put_aside = || -> Result<()> {
            fs::create_dir_all(&steps)?;
            for path in Files::read(&steps)?.0.keys() {
                rename(&steps.join(path), &later.join(path))?;
            }
            Ok(fs::remove_dir_all(&steps)?)
        };
        fs::create_dir_all(&folder).expect("a folder in the target folder");
        let lock = File::create(folder.join("lock")).expect("a file there");
        lock.lock().expect("other processes end");
        put_aside().expect("the files can be moved");
        Self { folder, _lock: lock }
    }

    /// Writes the files that the book has shown so far.
    ///
    /// The parts of a file go in the order of its lines.
    pub fn write(&self, typed: &Typed) -> Result<()> {
        for (path, parts) in typed {
            let aside = self.folder.join("later").join(path);
            if aside.is_file() {
                rename(&aside, &self.folder.join(path))?;
            }
            self.save(path, &joined(parts))?;
        }
        fs::copy(workspace().join("Cargo.lock"), self.folder.join("Cargo.lock"))?;
        Ok(())
    }

    /// Writes a file, unless it is there as it should be.
    pub fn save(&self, path: &str, text: &str) -> Result<()> {
        let path = self.folder.join(path);
        if fs::read_to_string(&path).ok().as_deref() != Some(text) {
            fs::create_dir_all(path.with_file_name(""))?;
            fs::write(path, text)?;
        }
        Ok(())
    }

    /// Does what a command of the book says, and compares what is printed and drawn;
    /// gives the names of the pictures that were compared.
    pub fn run(&self, asked: &Asked) -> Result<Vec<String>> {
        let package = asked.option("-p").context("the command names no package")?;
        if asked.words[1] == "bench" {
            build(&mut self.cargo(&["build", "-p", package, "--bench", "*"]))?;
            return Ok(vec![]);
        }
        let (mut words, is_small) = drawn_small(asked);
        if words[1] == "check" {
            // It does more, and takes what is compiled already, which a check can't.
            words[1] = "build";
        }
        let own =
            words.iter().position(|word| *word == "--").unwrap_or(words.len());
        self.pictures()?.iter().try_for_each(fs::remove_file)?;
        if asked.code == FAILED {
            self.change_a_number()?;
        }
        let mut cargo = self.cargo(&words[1..own]);
        let output =
            cargo.args(&words[own..]).envs(asked.settings.clone()).output()?;
        let text = [output.stderr, output.stdout].concat();
        let text = String::from_utf8_lossy(&text);
        ensure!(output.status.code() == Some(asked.code), "{}", error(&text));
        if let Some(line) = asked.unsaid(&text) {
            bail!("it does not print {line:?}, but {text:?}");
        }
        let drawn = self.pictures()?;
        // What prints something else than a picture's name draws none.
        let draws = asked.words[1] == "run"
            && asked.words.iter().all(|word| word != "--help")
            && asked.says.iter().all(|line| line.contains(".png"));
        let is_refused = asked.code != 0;
        ensure!(draws && !is_refused || drawn.is_empty(), "it draws");
        ensure!(!draws || is_refused || !drawn.is_empty(), "it draws nothing");
        let names = drawn.iter().filter_map(|path| path.file_stem()?.to_str());
        let names = names.filter(|name| is_locked(name) && !is_small);
        names.map(|name| self.compare(name).map(|()| name.to_owned())).collect()
    }

    /// Changes what step 1 has the reader change, so that a locked picture is another;
    /// what is written next puts it back.
    fn change_a_number(&self) -> Result<()> {
        let path = "steps/step01_rays/src/picture.rs";
        let text = fs::read_to_string(self.folder.join(path))?;
        ensure!(text.contains("0.3 *"), "{path} has no number to change");
        self.save(path, &text.replace("0.3 *", "0.31 *"))
    }

    /// Says which of the states of the crates on the way does not compile: each is a
    /// module, all of one crate.
    pub fn check_states(&self, states: &[State]) -> Result<()> {
        let mut lib = String::new();
        for State { name, files } in states {
            ensure!(files.contains_key("lib.rs"), "{name} has no lib.rs");
            for (file, text) in files {
                let file = if file == "lib.rs" { "mod.rs" } else { file };
                let text = text.replace("crate::", &format!("crate::{name}::"));
                self.save(&format!("steps/states/src/{name}/{file}"), &text)?;
            }
            lib += &format!("mod {name};\n");
        }
        self.save("steps/states/Cargo.toml", STATES)?;
        self.save("steps/states/src/lib.rs", &lib)?;
        build(&mut self.cargo(&["build", "-p", "states"]))
    }

    /// The picture that an example of a crate draws with these options; a warning is an
    /// error.
    pub fn draw(
        &self,
        step: &str,
        example: &str,
        options: &str,
    ) -> Result<RgbImage> {
        let mut cargo = self.cargo(&["run", "-p", step, "--example", example]);
        let output = cargo.arg("--").args(options.split_whitespace()).output()?;
        let told = String::from_utf8_lossy(&output.stderr);
        ensure!(output.status.success() && told.is_empty(), "{told}");
        Ok(image::open(self.folder.join(format!("{example}.png")))?.to_rgb8())
    }

    /// The pictures that are in the reader's folder.
    fn pictures(&self) -> Result<Vec<PathBuf>> {
        let files = fs::read_dir(&self.folder)?.flatten().map(|file| file.path());
        let is_png = |path: &PathBuf| path.extension().is_some_and(|e| e == "png");
        Ok(files.filter(is_png).collect())
    }

    /// Compares the picture `name` there with the locked one.
    fn compare(&self, name: &str) -> Result<()> {
        let picture = image::open(self.folder.join(format!("{name}.png")));
        let picture = picture.with_context(|| format!("no program {name}"))?;
        match Difference::between(&locked(name), &picture.to_rgb8()) {
            Some(how) => bail!("{name} draws another picture: {how}"),
            None => Ok(()),
        }
    }

    /// Cargo in the reader's folder, told to do `what`.
    fn cargo(&self, what: &[&str]) -> Command {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(what).args(["--offline", "--quiet"]);
        cargo.args(["--target-dir", "target"]).current_dir(&self.folder);
        // What the crates depend on is compiled already, for ours, with the same settings.
        // As the crates have the names of ours, a setting of their own keeps them apart.
        cargo.env("CARGO_BUILD_BUILD_DIR", target_folder());
        cargo.env("CARGO_PROFILE_DEV_OPT_LEVEL", "0");
        // Each crate is compiled once or twice: there is nothing to keep for later.
        cargo.env("CARGO_INCREMENTAL", "0");
        // A command of the book says itself what insta is to do, and does it there.
        cargo.env_remove("INSTA_UPDATE").env("INSTA_WORKSPACE_ROOT", &self.folder);
        // So that the programs are where we look for them.
        cargo.env_remove("CARGO_BUILD_TARGET");
        cargo
    }
}

/// Moves a file into a folder that need not be there.
fn rename(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to.with_file_name(""))?;
    Ok(fs::rename(from, to)?)
}

/// Builds, or tells why Cargo does not, in its own words.
fn build(cargo: &mut Command) -> Result<()> {
    let output = cargo.args(["--message-format", "short"]).output()?;
    let text = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{}", error(&text));
    Ok(())
}

/// The first of Cargo's lines that tells of an error, and the one after it.
fn error(text: &str) -> String {
    let mut lines = text.lines().skip_while(|line| !line.contains("error"));
    let [first, second] =
        [lines.next().unwrap_or(text), lines.next().unwrap_or("")];
    format!("Cargo says: {first} {}", second.trim())
}

/// The words of a command, with a small picture where it would draw one that takes long
/// here, where nothing is optimised.
fn drawn_small(asked: &Asked) -> (Vec<&str>, bool) {
    let mut words: Vec<_> = asked.words.iter().map(String::as_str).collect();
    let at = |words: &[&str], name| words.iter().position(|word| *word == name);
    let is_large = at(&words, "--samples").or(at(&words, "--width")).is_some();
    if asked.code != 0 || !is_large {
        return (words, false);
    }
    if let Some(at) = at(&words, "--width") {
        words.drain(at..at + 2);
    }
    words.extend(["--width", "64"]);
    (words, true)
}

/// Whether there is a locked picture of this name.
fn is_locked(name: &str) -> bool {
    workspace().join(format!("tests/snapshots/{name}.snap.png")).is_file()
}
