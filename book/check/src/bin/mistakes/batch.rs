//! A copy of the course in which many mistakes are compiled at once, each a module.

use crate::source;
use check::Mistake;
use compare::workspace;
use image::RgbImage;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use std::{fs, io, iter, thread};

/// What a mistake drew: the name of each picture, and the picture.
type Drawn<'a> = (&'a Mistake, Vec<(String, RgbImage)>);

/// How long a picture may take.
const PATIENCE: Duration = Duration::from_secs(20);

/// A folder in `target` with the steps and a program that draws them.
pub struct Batch {
    folder: PathBuf,
}

impl Batch {
    /// Copies the steps.
    pub fn new() -> io::Result<Self> {
        let folder = workspace().join("target/mistakes");
        let _ = fs::remove_dir_all(folder.join("steps"));
        copy(&workspace().join("steps"), &folder.join("steps"))?;
        fs::create_dir_all(folder.join("draw/src"))?;
        fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;
        let text = fs::read_to_string(workspace().join("Cargo.toml"))?;
        fs::write(folder.join("Cargo.toml"), manifest(&text))?;
        let names = ["clap", "fearless_simd", "glam", "image", "rayon"];
        let steps = check::Step::ALL.map(check::Step::name);
        let mut text =
            "[package]\nname = \"draw\"\nedition = \"2024\"\n\n[dependencies]\n"
                .to_owned();
        for name in names.into_iter().chain(steps) {
            text += &format!("{name}.workspace = true\n");
        }
        fs::write(folder.join("draw/Cargo.toml"), text)?;
        Ok(Self { folder })
    }

    /// Compiles and draws; what does not compile draws nothing.
    pub fn draw<'a>(&mut self, all: &[&'a Mistake]) -> io::Result<Vec<Drawn<'a>>> {
        let mut compiled: Vec<usize> = (0..all.len()).collect();
        loop {
            let errors = self.build(all, &compiled)?;
            if errors.is_empty() {
                break;
            }
            let is_wrong = |k: &usize| errors.contains(&format!("src/m{k}/"));
            let (wrong, right): (Vec<_>, Vec<_>) =
                compiled.into_iter().partition(is_wrong);
            for k in &wrong {
                println!("does not compile: {} ({})", all[*k].title, all[*k].file);
            }
            if wrong.is_empty() {
                return Err(io::Error::other(errors));
            }
            compiled = right;
        }
        let jobs = |k: usize| all[k].drawn().map(move |name| (k, name));
        let jobs: Vec<_> = compiled.iter().flat_map(|k| jobs(*k)).collect();
        let half = jobs.len().div_ceil(2).max(1);
        let drawn: Vec<_> = thread::scope(|scope| {
            let parts = jobs.chunks(half).map(|part| {
                scope.spawn(|| {
                    let each = part.iter().map(|(k, name)| self.picture(*k, name));
                    each.collect::<Vec<_>>()
                })
            });
            let parts: Vec<_> = parts.collect();
            parts
                .into_iter()
                .flat_map(|part| part.join().unwrap_or_default())
                .collect()
        });
        let mut pictures: Vec<_> = all.iter().map(|one| (*one, vec![])).collect();
        for ((k, name), picture) in jobs.into_iter().zip(drawn) {
            pictures[k].1.extend(picture.map(|picture| (name, picture)));
        }
        Ok(pictures)
    }

    /// Writes and compiles the program; returns the errors, a line each.
    fn build(&self, all: &[&Mistake], which: &[usize]) -> io::Result<String> {
        let source = self.folder.join("draw/src");
        fs::remove_dir_all(&source)?;
        fs::create_dir_all(&source)?;
        let mut mods = "#![allow(warnings)]\n".to_owned();
        let mut arms = String::new();
        for k in which {
            let folder = source.join(format!("m{k}"));
            fs::create_dir_all(&folder)?;
            if let Err(error) =
                source::write(all[*k], &format!("crate::m{k}"), &folder)
            {
                println!("left out: {error}");
                continue;
            }
            mods += &format!("mod m{k};\n");
            arms += &format!("\"{k}\" => m{k}::draw(&name, &file),\n");
        }
        let main = "fn main() {\n    let asked = |name: &str| std::env::var(name).expect(name);\n    \
            let (name, file) = (asked(\"PICTURE\"), asked(\"FILE\"));\n    match \
            asked(\"MISTAKE\").as_str() {\n";
        fs::write(
            source.join("main.rs"),
            mods + main + &arms + "_ => {}\n    }\n}\n",
        )?;
        let built = Command::new("cargo")
            .args([
                "build",
                "-q",
                "--offline",
                "-p",
                "draw",
                "--message-format=short",
            ])
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", self.folder.join("target"))
            .env("CARGO_INCREMENTAL", "0")
            .env_remove("CARGO_MANIFEST_DIR")
            .output()?;
        let text = String::from_utf8_lossy(&built.stderr);
        let errors = text.lines().filter(|line| line.contains("error"));
        let errors = errors.collect::<Vec<_>>().join("\n");
        Ok(if built.status.success() { String::new() } else { errors + " " })
    }

    /// Runs the program for one picture.
    fn picture(&self, k: usize, name: &str) -> Option<RgbImage> {
        let file = self.folder.join(format!("{k}-{name}.png"));
        let _ = fs::remove_file(&file);
        let child = Command::new(self.folder.join("target/debug/draw"))
            .args(["--output".as_ref(), file.as_os_str()])
            .envs([("MISTAKE", k.to_string().as_str()), ("PICTURE", name)])
            .env("FILE", &file)
            .env("RAYON_NUM_THREADS", "1")
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn();
        wait(child.ok()?);
        let picture = image::open(&file).ok()?.to_rgb8();
        let _ = fs::remove_file(&file);
        Some(picture)
    }
}

/// Waits for a program, and ends it where it takes too long.
fn wait(mut child: Child) {
    let start = Instant::now();
    let running = iter::repeat_with(|| child.try_wait());
    let mut running = running.take_while(|done| matches!(done, Ok(None)));
    let is_late = running.any(|_| {
        thread::sleep(Duration::from_millis(5));
        PATIENCE < start.elapsed()
    });
    drop(running);
    if is_late {
        let _ = child.kill();
        let _ = child.wait();
    }
}

/// The workspace of the copy: that of the course, without what is not in `steps`.
fn manifest(text: &str) -> String {
    let sections = text.split("\n[").filter(|part| part.starts_with("workspace."));
    let is_there =
        |line: &&str| !line.contains("path =") || line.contains("\"steps/");
    let mut new =
        "[workspace]\nresolver = \"3\"\nmembers = [\"steps/*\", \"draw\"]\n"
            .to_owned();
    for section in sections {
        let lines: Vec<_> = section.lines().filter(is_there).collect();
        new += &format!("\n[{}\n", lines.join("\n"));
    }
    new + "\n[profile.dev]\nopt-level = 1\ndebug = false\n\n[profile.dev.package.png]\n\
        opt-level = 3\n"
}

fn copy(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let to = to.join(entry.file_name());
        match entry.file_type()?.is_dir() {
            true => copy(&entry.path(), &to)?,
            false => drop(fs::copy(entry.path(), to)?),
        }
    }
    Ok(())
}
