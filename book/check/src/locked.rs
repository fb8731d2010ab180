use crate::{Step, png};
use compare::workspace;
use image::RgbImage;
use std::fs::{self, File};
use std::io::BufReader;

/// A picture to compare with.
#[derive(Clone, Debug, PartialEq)]
pub struct Locked {
    /// Its name: that of a step or of an example of a step.
    pub name: String,
    /// What the picture has to be.
    pub picture: RgbImage,
}

impl Locked {
    /// All that there are in the folder of the course, or a sentence about why one of
    /// them can't be had.
    pub fn all() -> Result<Vec<Self>, String> {
        let one = |name: String| Ok(Self { picture: locked(&name)?, name });
        names().into_iter().map(one).collect()
    }
}

/// The names of all pictures that there are to compare with: those of the steps, and
/// those of the exercises, which are examples of a step, in the steps' order.
pub fn names() -> Vec<String> {
    let steps = Step::ALL.map(|step| step.name().to_owned());
    let exercises = Step::ALL.into_iter().flat_map(examples);
    let is_there = |name: &String| workspace().join(path(name)).exists();
    steps.into_iter().chain(exercises).filter(is_there).collect()
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
fn locked(name: &str) -> Result<RgbImage, String> {
    let path = path(name);
    let file = File::open(workspace().join(&path));
    let file = file.map_err(|error| format!("can't read {path}: {error}"))?;
    let (picture, _) =
        png::read(BufReader::new(file)).map_err(|what| format!("{path} {what}"))?;
    Ok(picture)
}

fn path(name: &str) -> String {
    format!("tests/snapshots/{name}.snap.png")
}
