use crate::{Step, png, workspace};
use image::RgbImage;
use std::fs;
use std::path::PathBuf;

/// The names of all pictures that there are to compare with: those of the steps, and
/// those of the exercises, which are examples of a step, in the steps' order.
pub fn names() -> Vec<String> {
    let steps = Step::ALL.map(|step| step.name().to_owned());
    let exercises = Step::ALL.into_iter().flat_map(examples);
    steps.into_iter().chain(exercises).filter(|name| path(name).exists()).collect()
}

/// The names of the examples of a step, sorted.
fn examples(step: Step) -> Vec<String> {
    let folder = workspace().join("steps").join(step.name()).join("examples");
    let files = fs::read_dir(folder).into_iter().flatten().flatten();
    let name = |file: fs::DirEntry| {
        Some(file.file_name().to_str()?.strip_suffix(".rs")?.to_owned())
    };
    let mut names: Vec<_> = files.filter_map(name).collect();
    names.sort();
    names
}

/// The locked picture `name`, or a sentence about why it can't be had.
pub fn locked(name: &str) -> Result<RgbImage, String> {
    png::read(&path(name))
}

fn path(name: &str) -> PathBuf {
    workspace().join("tests/snapshots").join(format!("{name}.snap.png"))
}
