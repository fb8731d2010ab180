//! The texts of a mistake as a module: copies of the steps from its own on.

use check::{Mistake, Step};
use compare::workspace;
use std::path::Path;
use std::{fs, io};

/// What stands for a program where the mistake is elsewhere: it is long to compile.
const NO_PROGRAM: &str = "use crate::Camera;\nuse image::RgbImage;\n\
    pub fn run(_: &str, _: impl Fn(&Camera, u32) -> RgbImage) {}\n";

/// Writes the module of a mistake into `folder`; it has a `pub fn draw(name: &str,
/// file: &str)`. `module` is its path in the crate, such as `crate::m7`.
pub fn write(mistake: &Mistake, module: &str, folder: &Path) -> io::Result<()> {
    let first = mistake.step().ok_or(io::Error::other("it is of no step"))?;
    if mistake.file.contains("/examples/") {
        return write_example(mistake, module, folder);
    }
    let own: Vec<_> = Step::ALL.into_iter().filter(|step| first <= *step).collect();
    let program = ["/program.rs", "/main.rs", "/aspect_ratio.rs"];
    let is_program = program.iter().any(|name| mistake.file.ends_with(name));
    let mut text = String::new();
    for step in &own {
        let name = step.name();
        write_step(mistake, *step, &own, module, is_program, &folder.join(name))?;
        text += &format!("pub mod {name};\n");
    }
    text += "pub fn draw(name: &str, file: &str) {\n    match name {\n";
    for name in own.iter().map(|step| step.name()) {
        let camera = match first {
            Step::Rays => format!("{module}::step01_rays::Camera"),
            _ => "step01_rays::Camera".to_owned(),
        };
        text += &match is_program {
            true => format!("\"{name}\" => {name}::main::main(),\n"),
            false => format!(
                "\"{name}\" => {name}::picture(&{camera}::new(640, 360, \
                 60_f64.to_radians()), 1).save(file).expect(\"a file\"),\n"
            ),
        };
    }
    fs::write(folder.join("mod.rs"), text + "_ => {}\n    }\n}\n")
}

/// Writes one step of its module.
fn write_step(
    mistake: &Mistake,
    step: Step,
    own: &[Step],
    module: &str,
    is_program: bool,
    folder: &Path,
) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let source = format!("steps/{}/src", step.name());
    for file in fs::read_dir(workspace().join(&source))? {
        let name = file?.file_name().to_string_lossy().into_owned();
        let path = format!("{source}/{name}");
        let mut text = fs::read_to_string(workspace().join(&path))?;
        if path == mistake.file {
            text = applied(mistake, &text)?;
        } else if name == "program.rs" && !is_program {
            text = NO_PROGRAM.to_owned();
        }
        text =
            bare(&text).replace("crate::", &format!("{module}::{}::", step.name()));
        for other in own.iter().map(|other| other.name()) {
            let inside = format!("{module}::{other}::");
            text = text.replace(&inside, "\0").replace(&format!("{other}::"), "\0");
            text = text.replace('\0', &inside);
        }
        let name = match name.as_str() {
            "lib.rs" => {
                text += if is_program { "pub mod main;\n" } else { "" };
                "mod.rs"
            }
            name => name,
        };
        fs::write(folder.join(name), text.replace("\nfn main", "\npub fn main"))?;
    }
    Ok(())
}

/// Without the documentation of a file, which would not be at its top.
fn bare(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("//!"));
    lines.fold("\n".to_owned(), |text, line| text + line + "\n")
}

/// Writes an example, and draws it as the package `exercises` does.
fn write_example(mistake: &Mistake, module: &str, folder: &Path) -> io::Result<()> {
    let text = fs::read_to_string(workspace().join(&mistake.file))?;
    let text = bare(&applied(mistake, &text)?);
    let text = text.replace("crate::", &format!("{module}::"));
    let name = mistake.drawn().next().unwrap_or_default();
    let list = fs::read_to_string(workspace().join("book/exercises/lib.rs"))?;
    let start = format!("(\"{name}\", ");
    let picture =
        list.split(&start).nth(1).and_then(|rest| rest.split("),\n").next());
    let Some(picture) = picture else {
        return Err(io::Error::other(format!("exercises has no {name}")));
    };
    let picture = picture.replace(&format!("{name}::"), &format!("{module}::"));
    let draw = format!(
        "pub fn draw(_: &str, file: &str) {{\n    let draw: fn(&step01_rays::Camera, u32) \
         -> image::RgbImage = {picture};\n    let camera = step01_rays::Camera::new(640, \
         360, 60_f64.to_radians());\n    draw(&camera, 1).save(file).expect(\"a \
         file\");\n}}\n"
    );
    fs::create_dir_all(folder)?;
    fs::write(folder.join("mod.rs"), text + &draw)
}

fn applied(mistake: &Mistake, text: &str) -> io::Result<String> {
    let Mistake { title, file, .. } = mistake;
    mistake.applied(text).ok_or_else(|| {
        io::Error::other(format!("{title}: its text is not in {file}, once"))
    })
}
