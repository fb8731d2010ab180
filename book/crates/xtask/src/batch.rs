//! Many mistakes in one program: each is a module, a copy of the steps from its own on, or of
//! its example, with the mistake in it. What it does not touch is that of the course.

use course::{Mistake, Step};
use course::{target_folder, workspace};
use image::RgbImage;
use std::collections::BTreeSet;
use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;
use std::{env, fs};

/// The pictures that a mistake may spoil, in the order of
/// [`Mistake::affected_picture_names`]; None where it panics.
pub type Pictures = Vec<Option<RgbImage>>;

/// The manifest of the program, up to its dependencies.
const MANIFEST: &str = "[package]\nname = \"batch\"\nedition = \"2024\"\n\n[workspace]\n\n\
    [profile.dev]\ndebug = false\nincremental = false\n";

/// The program, up to its modules and the lists of what it draws.
const MAIN: &str = include_str!("batch_main.rs");

/// The camera of the course's pictures, in code.
const CAMERA: &str = "Camera::new(640, 360, 60_f64.to_radians())";

/// The modules of a step with the program around its picture.
const CLI_MODULES: [&str; 2] = ["program", "aspect_ratio"];

/// Mistakes in one program: as many as a compiler takes with little memory.
const COUNT: usize = 100;

/// Draws `mistakes`, and hands each to `finish` with its pictures; without any where it does
/// not compile, never ends or crashes.
pub fn draw_mistakes<'a>(
    mut mistakes: Vec<&'a Mistake>,
    mut finish: impl FnMut(&'a Mistake, Pictures) -> io::Result<()>,
) -> io::Result<()> {
    // What takes a person's hand is told before minutes are spent.
    for mistake in &mistakes {
        unindented_text_with_mistake(mistake)?;
    }
    let (start, all) = (Instant::now(), mistakes.len());
    println!("Mistakes to draw: {all}");
    while !mistakes.is_empty() {
        let count = COUNT.min(mistakes.len());
        write_package(&mistakes[..count])?;
        let faulty = find_modules_with_errors()?;
        for k in faulty.iter().rev() {
            let mistake = mistakes.remove(*k);
            println!("does not compile: {}", title_and_file(mistake));
            finish(mistake, vec![])?;
        }
        // What is left is compiled again, without those.
        if faulty.is_empty() {
            let finished_count = run_and_read_pictures(&mistakes[..count], &mut finish)?;
            mistakes.drain(..finished_count);
        }
        let done_count = all - mistakes.len();
        let time_left = start.elapsed() * mistakes.len() as u32 / done_count as u32;
        println!("{done_count} of {all} done, about {} s left", time_left.as_secs());
    }
    Ok(())
}

/// Runs the program until it ends, and returns the number of mistakes that are finished.
fn run_and_read_pictures<'a>(
    mistakes: &[&'a Mistake],
    mut finish: impl FnMut(&'a Mistake, Pictures) -> io::Result<()>,
) -> io::Result<usize> {
    let mut run = cargo_command("run");
    let mut program = run.stdout(Stdio::piped()).stderr(Stdio::null()).spawn()?;
    let mut output = BufReader::new(program.stdout.take().expect("it is piped"));
    let mut count = 0;
    for mistake in mistakes {
        count += 1;
        let names = mistake.affected_picture_names().into_iter();
        let pictures = names.map(|_| read_picture(&mut output)).collect();
        let Some(pictures) = pictures else {
            println!("never ends, or crashes: {}", title_and_file(mistake));
            finish(mistake, vec![])?;
            break;
        };
        finish(mistake, pictures)?;
    }
    drop(output);
    program.wait()?;
    Ok(count)
}

/// Writes the package: its manifest, a module for each mistake, and the lists of what its
/// main file draws.
fn write_package(mistakes: &[&Mistake]) -> io::Result<()> {
    let folder = target_folder().join("mistakes");
    let _ = fs::remove_dir_all(folder.join("src"));
    write_with_folders(&folder.join("Cargo.toml"), &manifest_text()?)?;
    fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;
    let (mut modules, mut pictures, mut programs) = (vec![], vec![], vec![]);
    for (mistake, k) in mistakes.iter().zip(0..) {
        let source = folder.join(format!("src/m{k}"));
        let own_step = mistake.step().map_or("", Step::name);
        let names = mistake.affected_picture_names();
        let text: String = names.iter().map(|name| format!("pub mod {name};\n")).collect();
        write_with_folders(&source.join("mod.rs"), &text)?;
        modules.push(format!("mod m{k};"));
        for name in names {
            let path = format!("m{k}::{name}");
            let is_step = Step::from_name(&name).is_some();
            if is_step {
                write_step(&source.join(&name), mistake, &name, k)?;
            } else {
                // An example may have the module of another in it.
                let folder =
                    format!("#[path = \"{}/steps/{own_step}/examples/", quotable_workspace_path());
                let text = unindented_text_with_mistake(mistake)?.replace("#[path = \"", &folder);
                write_with_folders(&source.join(format!("{name}.rs")), &text)?;
            }
            let camera = if is_step { &path } else { own_step };
            pictures.push(match &*name {
                _ if is_cli_file(&mistake.file) => {
                    programs.push(format!("|| {path}::run(\"\", {path}::picture),"));
                    format!("|| draw_with_program({}),", programs.len() - 1)
                }
                "gradient" => format!("{path}::picture,"),
                _ => format!("|| {path}::picture(&{camera}::{CAMERA}, 1),"),
            });
        }
    }
    let [modules, pictures, programs] = [modules, pictures, programs].map(|lines| lines.join("\n"));
    let main = format!(
        "{MAIN}\n{modules}\n\nconst PICTURES: &[fn() -> RgbImage] = &[\n{pictures}\n];\n\n\
         const PROGRAMS: &[fn()] = &[\n{programs}\n];\n"
    );
    write_with_folders(&folder.join("src/main.rs"), &main)
}

/// The manifest: it needs what the examples and the program around a picture need.
fn manifest_text() -> io::Result<String> {
    let section = |path: &str, name: &str| {
        let text = read_in_workspace(path)?;
        let section_text = text.split("\n[").find(|section| section.starts_with(name));
        Ok::<_, io::Error>(section_text.unwrap_or_default().to_owned())
    };
    let versions = section("Cargo.toml", "workspace.dependencies]")?;
    let versions =
        versions.replace("path = \"", &format!("path = \"{}/", quotable_workspace_path()));
    let dependencies = section("book/crates/course/Cargo.toml", "dependencies]")?;
    Ok(format!("{MANIFEST}\n[{versions}\n[{dependencies}\nclap.workspace = true\n"))
}

/// Writes the library of a step, with the mistake, as a part of module `k`. The program
/// around the picture is that of the course, unless the mistake is there.
fn write_step(folder: &Path, mistake: &Mistake, step: &str, k: usize) -> io::Result<()> {
    let is_left_out = |path: &str| is_cli_file(path) && !is_cli_file(&mistake.file);
    for entry in fs::read_dir(workspace().join(format!("steps/{step}/src")))? {
        let file = entry?.file_name().into_string().unwrap_or_default();
        let path = format!("steps/{step}/src/{file}");
        if file == "main.rs" || is_left_out(&path) {
            continue;
        }
        let mut text = if path == mistake.file {
            unindented_text_with_mistake(mistake)?
        } else {
            read_in_workspace(&path)?
        };
        text = text.replace("crate::", &format!("crate::m{k}::{step}::"));
        for name in mistake.affected_picture_names() {
            text = text.replace(&format!("use {name}"), &format!("use crate::m{k}::{name}"));
        }
        for name in CLI_MODULES.iter().filter(|name| is_left_out(&format!("/{name}.rs"))) {
            text = text.replace(&format!("mod {name};"), &format!("use ::{step} as {name};"));
        }
        let file = if file == "lib.rs" { "mod.rs" } else { &file };
        write_with_folders(&folder.join(file), &text)?;
    }
    Ok(())
}

/// Whether a file belongs to the program around a picture.
fn is_cli_file(path: &str) -> bool {
    CLI_MODULES.iter().any(|name| path.ends_with(&format!("/{name}.rs")))
}

/// Compiles the program, and returns the numbers of the modules that have errors.
fn find_modules_with_errors() -> io::Result<BTreeSet<usize>> {
    let output = cargo_command("build").args(["--message-format", "short"]).output()?;
    if output.status.success() {
        return Ok(BTreeSet::new());
    }
    let text = String::from_utf8_lossy(&output.stderr).replace('\\', "/");
    let errors = text.lines().filter(|line| line.contains(": error"));
    let module = |line: &str| line.strip_prefix("src/m")?.split('/').next()?.parse().ok();
    let faulty: BTreeSet<_> = errors.filter_map(module).collect();
    if faulty.is_empty() {
        return Err(io::Error::other(format!("the mistakes do not compile:\n{text}")));
    }
    Ok(faulty)
}

fn cargo_command(command: &str) -> Command {
    let folder = target_folder().join("mistakes");
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args([command, "--quiet", "--offline", "--target-dir"]).arg(folder.join("target"));
    cargo.current_dir(folder).env_remove("CARGO_BUILD_TARGET");
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

/// The title and the file of a mistake.
pub fn title_and_file(mistake: &Mistake) -> String {
    format!("{} ({})", mistake.title, mistake.file)
}

/// The folder of the course, as it can be quoted.
fn quotable_workspace_path() -> String {
    workspace().display().to_string().replace('\\', "/")
}

/// The text of a mistake's file, with the mistake in it.
fn unindented_text_with_mistake(mistake: &Mistake) -> io::Result<String> {
    mistake.apply_and_unindent(&read_in_workspace(&mistake.file)?).ok_or_else(|| {
        let mistake = title_and_file(mistake);
        io::Error::other(format!("the text is not there, or not once: {mistake}"))
    })
}

fn read_in_workspace(path: &str) -> io::Result<String> {
    fs::read_to_string(workspace().join(path))
}

fn write_with_folders(path: &Path, text: &str) -> io::Result<()> {
    fs::create_dir_all(path.parent().unwrap_or(path))?;
    fs::write(path, text)
}
