//! Many mistakes in one program: each is a module, a copy of the steps from its own on, or of
//! its example, with the mistake in it. What it does not touch is that of the course.

use check::{Mistake, Step};
use compare::{target_folder, workspace};
use image::RgbImage;
use std::collections::BTreeSet;
use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;
use std::{env, fs};

/// The pictures that a mistake may spoil, in the order of [`Mistake::drawn`]; None where it
/// panics.
pub type Pictures = Vec<Option<RgbImage>>;

/// The manifest of the program, up to its dependencies.
const MANIFEST: &str = "[package]\nname = \"batch\"\nedition = \"2024\"\n\n[workspace]\n\n\
    [profile.dev]\ndebug = false\nincremental = false\n";

/// The program, up to its modules and the lists of what it draws.
const MAIN: &str = include_str!("batch_main.rs");

/// The camera of the course's pictures, in code.
const CAMERA: &str = "Camera::new(640, 360, 60_f64.to_radians())";

/// The files of the program around the pictures.
const AROUND: [&str; 2] = ["program", "aspect_ratio"];

/// Mistakes in one program: as many as a compiler takes with little memory.
const COUNT: usize = 100;

/// Draws `mistakes`, and hands each to `finish` with its pictures; without any where it does
/// not compile, or brings the program down.
pub fn draw<'a>(
    mut mistakes: Vec<&'a Mistake>,
    mut finish: impl FnMut(&'a Mistake, Pictures) -> io::Result<()>,
) -> io::Result<()> {
    let (start, all) = (Instant::now(), mistakes.len());
    println!("{all} mistakes to draw");
    while !mistakes.is_empty() {
        let mut batch: Vec<_> =
            mistakes.drain(..COUNT.min(mistakes.len())).collect();
        write_program(&batch)?;
        let faulty = compile()?;
        for k in faulty.iter().rev() {
            let mistake = batch.remove(*k);
            println!("does not compile: {} ({})", mistake.title, mistake.file);
            finish(mistake, vec![])?;
        }
        if faulty.is_empty() {
            let mut program = cargo("run");
            program.stdout(Stdio::piped()).stderr(Stdio::null());
            let mut program = program.spawn()?;
            let mut output = program.stdout.take().map(BufReader::new);
            let mut is_running = true;
            while is_running && !batch.is_empty() {
                let mistake = batch.remove(0);
                let pictures = mistake.drawn().into_iter();
                let pictures = pictures.map(|_| read_picture(output.as_mut()?));
                let pictures: Option<Pictures> = pictures.collect();
                is_running = pictures.is_some();
                if !is_running {
                    let Mistake { title, file, .. } = mistake;
                    println!("never ends, or crashes: {title} ({file})");
                }
                finish(mistake, pictures.unwrap_or_default())?;
            }
            program.wait()?;
        }
        // What is left is compiled again, without those.
        mistakes.splice(..0, batch);
        let drawn = all - mistakes.len();
        let left = start.elapsed() * mistakes.len() as u32 / drawn as u32;
        println!("{drawn} of {all} drawn, about {} s left", left.as_secs());
    }
    Ok(())
}

/// Writes the package: its manifest, a module for each mistake, and what `main` draws.
fn write_program(mistakes: &[&Mistake]) -> io::Result<()> {
    let folder = target_folder().join("mistakes");
    let _ = fs::remove_dir_all(folder.join("src"));
    let [course, exercises] = ["Cargo.toml", "book/exercises/Cargo.toml"].map(read);
    let (course, exercises) = (course?, exercises?);
    let section = |text: &str, name: &str| {
        let found = text.split("\n[").find(|section| section.starts_with(name));
        found.map_or(String::new(), |section| format!("\n[{section}\n"))
    };
    let root = workspace().display().to_string().replace('\\', "/");
    let versions = section(&course, "workspace.dependencies]");
    let versions = versions.replace("path = \"", &format!("path = \"{root}/"));
    let used = section(&exercises, "dependencies]") + "clap.workspace = true\n";
    write(&folder.join("Cargo.toml"), &(MANIFEST.to_owned() + &versions + &used))?;
    fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;

    let (mut modules, mut pictures, mut programs) =
        (String::new(), String::new(), vec![]);
    for (mistake, k) in mistakes.iter().zip(0..) {
        let (names, step) =
            (mistake.drawn(), mistake.step().map_or("", Step::name));
        let source = folder.join(format!("src/m{k}"));
        let is_around = AROUND
            .iter()
            .any(|name| mistake.file.ends_with(&format!("/{name}.rs")));
        for name in &names {
            let path = format!("m{k}::{name}");
            let is_step = Step::named(name).is_some();
            if is_step {
                write_step(&source.join(name), mistake, name, k)?;
            } else {
                let beside = format!("#[path = \"{root}/steps/{step}/examples/");
                let text = apply(mistake)?.replace("#[path = \"", &beside);
                write(&source.join(format!("{name}.rs")), &text)?;
            }
            let camera = if is_step { &path } else { step };
            pictures += &match &**name {
                _ if is_around => {
                    format!("    || draw_with_program({}),\n", programs.len())
                }
                "gradient" => format!("    {path}::picture,\n"),
                _ => format!("    || {path}::picture(&{camera}::{CAMERA}, 1),\n"),
            };
            if is_around {
                programs.push(format!(
                    "    || {path}::run(\"{name}\", {path}::picture),\n"
                ));
            }
        }
        let names: String =
            names.iter().map(|name| format!("pub mod {name};\n")).collect();
        write(&source.join("mod.rs"), &names)?;
        modules += &format!("mod m{k};\n");
    }
    let text = format!(
        "{MAIN}\n{modules}\nconst PICTURES: &[fn() -> RgbImage] = &[\n{pictures}];\n\n\
         const PROGRAMS: &[fn()] = &[\n{}];\n",
        programs.concat()
    );
    write(&folder.join("src/main.rs"), &text)
}

/// Writes the library of a step, with the mistake, as a part of module `k`. The program
/// around the pictures is that of the course, unless the mistake is there.
fn write_step(
    folder: &Path,
    mistake: &Mistake,
    step: &str,
    k: usize,
) -> io::Result<()> {
    let is_around = |path: &str| {
        AROUND.iter().any(|name| path.ends_with(&format!("/{name}.rs")))
    };
    for entry in fs::read_dir(workspace().join(format!("steps/{step}/src")))? {
        let file = entry?.file_name().into_string().unwrap_or_default();
        let path = format!("steps/{step}/src/{file}");
        if file == "main.rs" || is_around(&path) && !is_around(&mistake.file) {
            continue;
        }
        let mut text =
            if path == mistake.file { apply(mistake)? } else { read(&path)? };
        text = text.replace("crate::", &format!("crate::m{k}::{step}::"));
        for name in mistake.drawn() {
            text = text.replace(
                &format!("use {name}"),
                &format!("use crate::m{k}::{name}"),
            );
        }
        if !is_around(&mistake.file) {
            for name in AROUND {
                text = text.replace(
                    &format!("mod {name};"),
                    &format!("use ::{step} as {name};"),
                );
            }
        }
        let file = if file == "lib.rs" { "mod.rs" } else { &file };
        write(&folder.join(file), &text)?;
    }
    Ok(())
}

/// Compiles the program, and returns the numbers of the modules that have errors.
fn compile() -> io::Result<BTreeSet<usize>> {
    let output = cargo("build").args(["--message-format", "short"]).output()?;
    if output.status.success() {
        return Ok(BTreeSet::new());
    }
    let text = String::from_utf8_lossy(&output.stderr).replace('\\', "/");
    let errors = text.lines().filter(|line| line.contains(": error"));
    let module =
        |line: &str| line.strip_prefix("src/m")?.split('/').next()?.parse().ok();
    let faulty: BTreeSet<_> = errors.filter_map(module).collect();
    if faulty.is_empty() {
        return Err(io::Error::other(format!(
            "the mistakes do not compile:\n{text}"
        )));
    }
    Ok(faulty)
}

fn cargo(command: &str) -> Command {
    let folder = target_folder().join("mistakes");
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo
        .args([command, "--quiet", "--offline", "--target-dir"])
        .arg(folder.join("target"));
    cargo.current_dir(folder);
    cargo
}

/// The next picture of the program, None inside where it panics; None where it has ended.
fn read_picture(output: &mut impl BufRead) -> Option<Option<RgbImage>> {
    let mut line = String::new();
    output.read_line(&mut line).ok()?;
    let (columns, rows) = line.trim().split_once(' ')?;
    let mut image = RgbImage::new(columns.parse().ok()?, rows.parse().ok()?);
    output.read_exact(&mut image).ok()?;
    Some(Some(image).filter(|image| !image.is_empty()))
}

/// The text of a mistake's file, with the mistake in it.
fn apply(mistake: &Mistake) -> io::Result<String> {
    mistake.applied(&read(&mistake.file)?).ok_or_else(|| {
        let Mistake { title, file, .. } = mistake;
        io::Error::other(format!("{title}: its text is not in {file}, once"))
    })
}

fn read(path: &str) -> io::Result<String> {
    fs::read_to_string(workspace().join(path))
}

fn write(path: &Path, text: &str) -> io::Result<()> {
    fs::create_dir_all(path.parent().unwrap_or(path))?;
    fs::write(path, text)
}
