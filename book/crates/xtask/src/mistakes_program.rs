//! Generates and runs a program that draws many mistakes. Each mistake has a module in this
//! program. The module contains a copy of the mistake's step, with the mistake in it, and unchanged
//! copies of all later steps. For earlier steps, the copies use the course's own crates.

use crate::error::{XtaskError, XtaskResult};
use course::{
    Mistake, Step, cargo_command, crate_as_module, dependencies_of_step_copies, target_folder,
    workspace,
};
use image::RgbImage;
use std::fs;
use std::path::{Path, PathBuf};

/// The pictures that a mistake may change, each with its step. A picture is None if drawing it
/// panics.
pub type DrawnPictures = Vec<(Step, Option<RgbImage>)>;

/// The start of the program's manifest, before the dependencies.
const MANIFEST_START: &str = r#"
workspace = {}
package = { name = "mistakes", edition = "2024" }
profile.dev = { debug = false, incremental = false, package.png.opt-level = 3 }
"#;

/// The start of the program's main file, before the modules and the list of pictures to draw.
const MAIN_START: &str = "#![allow(warnings)]
use rayon::prelude::*;

fn main() {
    std::panic::set_hook(Box::new(|_| {}));
    PICTURES.par_iter().for_each(|draw| drop(std::panic::catch_unwind(draw)));
}
";

/// Draws mistakes with a single program. Returns the pictures of each mistake.
pub fn draw_mistakes(mistakes: &[&Mistake]) -> XtaskResult<Vec<DrawnPictures>> {
    let folder = generated_package_folder();
    let _ = fs::remove_dir_all(folder.join("src"));
    write_package(mistakes)?;
    let mut cargo = cargo_command();
    cargo.args(["run", "--quiet", "--offline", "--message-format=short", "--target-dir=target"]);
    let output = cargo.current_dir(&folder).output();
    let output = output.map_err(|source| XtaskError::Program { program: "cargo", source })?;
    if !output.status.success() {
        let output = String::from_utf8_lossy(&[output.stderr, output.stdout].concat()).into_owned();
        return Err(XtaskError::MistakesNotDrawn { output, folder });
    }
    let read_picture = |k, step: Step| {
        let path = folder.join(format!("{}.png", picture_path_without_extension(k, step)));
        (step, image::open(path).ok().map(|picture| picture.into_rgb8()))
    };
    let mistakes = mistakes.iter().enumerate();
    Ok(mistakes
        .map(|(k, mistake)| mistake.affected_steps().map(|step| read_picture(k, step)).collect())
        .collect())
}

/// Reads the file of a mistake and applies the mistake. Returns the resulting text without
/// indentation.
pub fn unindented_text_with_mistake(mistake: &Mistake) -> XtaskResult<String> {
    let text = read_text(&workspace().join(&mistake.file))?;
    mistake.apply_and_strip_indentation(&text).map_err(|count| {
        let (title, file) = (mistake.title, mistake.file.clone());
        XtaskError::MistakeNotOnce { title, file, count }
    })
}

fn read_text(path: &Path) -> XtaskResult<String> {
    fs::read_to_string(path).map_err(XtaskError::of_file(path))
}

fn write_text(path: &Path, text: &str) -> XtaskResult<()> {
    fs::write(path, text).map_err(XtaskError::of_file(path))
}

/// Returns the title of a mistake, followed by the mistake's file in parentheses.
pub fn title_and_file(mistake: &Mistake) -> String {
    format!("{} ({})", mistake.title, mistake.file)
}

fn generated_package_folder() -> PathBuf {
    target_folder().join("mistakes")
}

/// The path of the file in which the program saves a step's picture with mistake `k`, without the
/// extension.
fn picture_path_without_extension(k: usize, step: Step) -> String {
    format!("src/m{k}/{}", step.name())
}

/// Writes the program's package: the manifest and the lock file, a module for each mistake, and the
/// main file.
fn write_package(mistakes: &[&Mistake]) -> XtaskResult<()> {
    let folder = generated_package_folder();
    let manifest = MANIFEST_START.to_owned() + &dependencies_of_step_copies();
    let (mut modules, mut pictures) = (String::new(), String::new());
    for (k, mistake) in mistakes.iter().enumerate() {
        modules += &format!("/// {}\nmod m{k} {{\n", title_and_file(mistake));
        for step in mistake.affected_steps() {
            write_step(&folder.join("src"), mistake, step.name(), &format!("m{k}"))?;
            modules += &format!("pub mod {};\n", step.name());
            let (path, name) =
                (format!("m{k}::{}", step.name()), picture_path_without_extension(k, step));
            pictures += &format!("|| {path}::draw_and_save({name:?}, {path}::picture),\n");
        }
        modules += "}\n";
    }
    let main = format!("{MAIN_START}\n{modules}\nconst PICTURES: &[fn()] = &[\n{pictures}];\n");
    write_text(&folder.join("src/main.rs"), &main)?;
    write_text(&folder.join("Cargo.toml"), &manifest)?;
    write_text(&folder.join("Cargo.lock"), &read_text(&workspace().join("Cargo.lock"))?)
}

/// Writes a copy of a step's library into `module`. If the mistake is in one of this step's files,
/// the copy of that file contains the mistake.
fn write_step(
    source_folder: &Path,
    mistake: &Mistake,
    step: &str,
    module: &str,
) -> XtaskResult<()> {
    let folder = source_folder.join(module).join(step);
    fs::create_dir_all(&folder).map_err(XtaskError::of_file(&folder))?;
    let step_folder = workspace().join(format!("steps/{step}/src"));
    let entries = fs::read_dir(&step_folder).map_err(XtaskError::of_file(&step_folder))?;
    for entry in entries {
        let entry = entry.map_err(XtaskError::of_file(&step_folder))?;
        let file = entry.file_name().into_string().unwrap_or_default();
        let path = format!("steps/{step}/src/{file}");
        let text = if path == mistake.file {
            unindented_text_with_mistake(mistake)?
        } else {
            read_text(&workspace().join(&path))?
        };
        let siblings = mistake.affected_steps().map(Step::name);
        let text = crate_as_module(&text, &format!("{module}::{step}"), siblings);
        let file = if file == "lib.rs" { "mod.rs" } else { &file };
        write_text(&folder.join(file), &text)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn picture_path_contains_the_mistakes_number_and_the_step() {
        assert_eq!(picture_path_without_extension(7, Step::Nearest), "src/m7/step03_nearest");
    }

    #[test]
    fn mistake_whose_code_is_gone_cannot_be_applied() {
        let mut mistake = course::mistakes()[0].clone();
        assert!(
            unindented_text_with_mistake(&mistake).is_ok_and(|text| text.contains(&mistake.new))
        );
        mistake.old = "no such code".to_owned();
        let error = unindented_text_with_mistake(&mistake)
            .expect_err("code that is gone can't be replaced");
        let message = "the code of the mistake \"the angle is in degrees\" must appear once in \
                       steps/step01_rays/src/program.rs, but appears 0 times";
        assert_eq!(error.to_string(), message);
    }
}
