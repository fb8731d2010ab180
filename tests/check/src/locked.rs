use crate::{Step, png, workspace};
use image::RgbImage;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::fs::{self, File};
use std::io::BufReader;
use std::path::PathBuf;

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
        let all = names().into_par_iter();
        all.map(|name| Ok(Self { picture: locked(&name)?, name })).collect()
    }
}

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
    let path = path(name);
    let unread = |what| format!("{} {what}", path.display());
    let file =
        File::open(&path).map_err(|e| unread(format!("can't be read: {e}")))?;
    let (view, _) = png::read(BufReader::new(file)).map_err(unread)?;
    Ok(view.kept)
}

fn path(name: &str) -> PathBuf {
    workspace().join("tests/snapshots").join(format!("{name}.snap.png"))
}
