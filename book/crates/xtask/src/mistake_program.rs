//! Many mistakes in one program: each is a module, a copy of the steps from its own on with the
//! mistake in it. What it does not touch is that of the course.

use course::{Mistake, Step, crate_as_module, target_folder, workspace};
use image::RgbImage;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// The pictures that a mistake may spoil, in the order of [`Mistake::affected_steps`]; None
/// where it panics.
pub type Pictures = Vec<Option<RgbImage>>;

/// The manifest of the program, up to its dependencies.
const MANIFEST: &str = "[package]\nname = \"mistakes\"\nedition = \"2024\"\n\n[workspace]\n\n\
    [profile.dev]\ndebug = false\nincremental = false\n";

/// The program, up to its modules and the list of what it draws.
const MAIN: &str = include_str!("draw_mistakes_main.rs");

/// The modules of a step with the program around its picture.
const CLI_MODULES: [&str; 2] = ["program", "aspect_ratio"];

/// Draws mistakes in one program, and returns the pictures of each.
pub fn draw(mistakes: &[&Mistake]) -> io::Result<Vec<Pictures>> {
    write_package(mistakes)?;
    let build = cargo_command("build").args(["--message-format", "short"]).output()?;
    if !build.status.success() {
        let text = String::from_utf8_lossy(&build.stderr).replace('\\', "/");
        let faulty =
            mistakes.iter().enumerate().filter(|(k, _)| text.contains(&format!("src/m{k}/")));
        let titles = faulty.map(|(k, mistake)| format!("m{k}: {}\n", title_and_file(mistake)));
        let titles: String = titles.collect();
        return Err(io::Error::other(format!("does not compile:\n{titles}{text}")));
    }
    let mut run = cargo_command("run");
    let mut program = run.stdout(Stdio::piped()).stderr(Stdio::null()).spawn()?;
    let mut output = BufReader::new(program.stdout.take().expect("it is piped"));
    let draw = |mistake: &&Mistake| {
        let pictures: Option<_> =
            mistake.affected_steps().map(|_| read_picture(&mut output)).collect();
        pictures.ok_or_else(|| {
            io::Error::other(format!("never ends, or crashes: {}", title_and_file(mistake)))
        })
    };
    let pictures = mistakes.iter().map(draw).collect();
    drop(output);
    program.wait()?;
    pictures
}

/// The text of a mistake's file with the mistake in it, no line indented; an error where its
/// place is not there once.
pub fn text_with_mistake(mistake: &Mistake) -> io::Result<String> {
    let text = fs::read_to_string(workspace().join(&mistake.file))?;
    mistake.apply_and_unindent(&text).ok_or_else(|| {
        let mistake = title_and_file(mistake);
        io::Error::other(format!("the text is not there, or not once: {mistake}"))
    })
}

/// The title and the file of a mistake.
pub fn title_and_file(mistake: &Mistake) -> String {
    format!("{} ({})", mistake.title, mistake.file)
}

fn package_folder() -> PathBuf {
    target_folder().join("mistakes")
}

/// Writes the package: its manifest, a module for each mistake, and the list of what its main file
/// draws.
fn write_package(mistakes: &[&Mistake]) -> io::Result<()> {
    let folder = package_folder();
    let _ = fs::remove_dir_all(folder.join("src"));
    write_with_folders(&folder.join("Cargo.toml"), &manifest_text()?)?;
    fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;
    let (mut modules, mut pictures) = (String::new(), String::new());
    for (k, mistake) in mistakes.iter().enumerate() {
        let module = format!("m{k}");
        let mut steps = String::new();
        for step in mistake.affected_steps().map(Step::name) {
            write_step(&folder.join("src"), mistake, step, &module)?;
            steps += &format!("pub mod {step};\n");
            let path = format!("{module}::{step}");
            pictures += &if is_cli_file(&mistake.file) {
                format!("|| draw_with_program(|| {path}::run(\"\", {path}::picture)),\n")
            } else {
                let camera = format!("{path}::Camera::new(640, 360, 60_f64.to_radians())");
                format!("|| {path}::picture(&{camera}, 1),\n")
            };
        }
        write_with_folders(&folder.join(format!("src/{module}/mod.rs")), &steps)?;
        modules += &format!("mod {module};\n");
    }
    let pictures = format!("const PICTURES: &[fn() -> RgbImage] = &[\n{pictures}];\n");
    write_with_folders(&folder.join("src/main.rs"), &format!("{MAIN}\n{modules}\n{pictures}"))
}

/// The manifest: the program needs what the course and step 1 need.
fn manifest_text() -> io::Result<String> {
    let section = |path: &str, name: &str| {
        let text = fs::read_to_string(workspace().join(path))?;
        let section_text = text.split("\n[").find(|section| section.starts_with(name));
        Ok::<_, io::Error>(section_text.unwrap_or_default().to_owned())
    };
    let versions = section("Cargo.toml", "workspace.dependencies]")?;
    let folder = workspace().display().to_string().replace('\\', "/");
    let versions = versions.replace("path = \"", &format!("path = \"{folder}/"));
    let dependencies = section("book/crates/course/Cargo.toml", "dependencies]")?;
    Ok(format!(
        "{MANIFEST}\n[{versions}\n[{dependencies}\nclap.workspace = true\nrayon.workspace = true\n"
    ))
}

/// Writes the library of a step, with the mistake, as a part of `module`. The program around the
/// picture is that of the course, unless the mistake is there.
fn write_step(source: &Path, mistake: &Mistake, step: &str, module: &str) -> io::Result<()> {
    let is_left_out = |path: &str| is_cli_file(path) && !is_cli_file(&mistake.file);
    for entry in fs::read_dir(workspace().join(format!("steps/{step}/src")))? {
        let file = entry?.file_name().into_string().unwrap_or_default();
        let path = format!("steps/{step}/src/{file}");
        if file == "main.rs" || is_left_out(&path) {
            continue;
        }
        let text = match path == mistake.file {
            true => text_with_mistake(mistake)?,
            false => fs::read_to_string(workspace().join(&path))?,
        };
        let siblings = mistake.affected_steps().map(Step::name);
        let mut text = crate_as_module(&text, &format!("{module}::{step}"), siblings);
        // The program has one option, and says nothing among the pictures.
        let options = "Options::parse_from([\"\", \"--output\", \"picture.png\"])";
        text = text.replace("Options::parse()", options).replace("stdout()", "std::io::sink()");
        for name in CLI_MODULES.iter().filter(|name| is_left_out(&format!("/{name}.rs"))) {
            text = text.replace(&format!("mod {name};"), &format!("use ::{step} as {name};"));
        }
        let file = if file == "lib.rs" { "mod.rs" } else { &file };
        write_with_folders(&source.join(module).join(step).join(file), &text)?;
    }
    Ok(())
}

/// Whether a file belongs to the program around a picture.
fn is_cli_file(path: &str) -> bool {
    CLI_MODULES.iter().any(|name| path.ends_with(&format!("/{name}.rs")))
}

fn cargo_command(command: &str) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args([command, "--quiet", "--offline", "--target-dir"]);
    cargo.arg(package_folder().join("target")).current_dir(package_folder());
    cargo.env_remove("CARGO_BUILD_TARGET");
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

fn write_with_folders(path: &Path, text: &str) -> io::Result<()> {
    fs::create_dir_all(path.parent().unwrap_or(path))?;
    fs::write(path, text)
}
