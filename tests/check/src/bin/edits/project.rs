use super::{edit::Edit, view::View};
use gallery::{Step, workspace};
use std::path::{Path, PathBuf};
use std::{error::Error, fs, process::Command};

/// A copy of the five steps, to be edited, in the target folder; and their pictures.
pub struct Project {
    folder: PathBuf,
}

/// The package that `[patch]` names.
const CLOCK: &str = "book/live/web-time";

type Result<T> = std::result::Result<T, Box<dyn Error>>;

impl Project {
    /// A copy without a mistake, or the pictures alone.
    pub fn new(is_drawn: bool) -> Result<Self> {
        let folder = workspace().join("target/edits");
        let project = Self { folder };
        if is_drawn {
            return Ok(project);
        }
        fs::create_dir_all(project.folder.join("pictures"))?;
        for name in ["Cargo.lock", "Cargo.toml"] {
            let text = fs::read_to_string(workspace().join(name))?;
            let lines: Vec<_> =
                text.lines().filter(|line| is_of_steps(line)).collect();
            changed(&project.folder.join(name), &lines.join("\n"))?;
        }
        let steps = Step::ALL.map(|step| Path::new("steps").join(step.name()));
        // The clock of the progress bar stands in the place of one of a registry.
        for folder in steps.iter().map(PathBuf::as_path).chain([Path::new(CLOCK)]) {
            project.copy(&workspace().join(folder), folder)?;
        }
        Ok(project)
    }

    /// Copies a folder, but not the files that are the same already.
    fn copy(&self, from: &Path, to: &Path) -> Result<()> {
        fs::create_dir_all(self.folder.join(to))?;
        for file in fs::read_dir(from)? {
            let (file, to) = (file?.path(), to.to_owned());
            let to = to.join(file.file_name().unwrap_or_default());
            match file.is_dir() {
                true => self.copy(&file, &to)?,
                false => {
                    changed(&self.folder.join(to), &fs::read_to_string(file)?)?
                }
            }
        }
        Ok(())
    }

    /// The pictures of the first step that shows an edit, and of the last one. They are
    /// kept: drawn once, until the edit changes.
    pub fn pictures(&self, edit: &Edit) -> Result<Vec<(Step, PathBuf)>> {
        let mut texts = vec![];
        for change in &edit.changes {
            let file = change.path();
            let old = match texts.iter().find(|(name, _)| *name == file) {
                Some((_, text)) => String::clone(text),
                None => fs::read_to_string(workspace().join(&file))?,
            };
            texts.retain(|(name, _)| *name != file);
            texts.push((file, change.applied(&old)?));
        }
        let told = format!("{texts:?}{:?}", edit.options);
        let kept = self.folder.join("pictures").join(edit.name() + ".edit");
        if fs::read_to_string(&kept).is_ok_and(|kept| kept == told) {
            return self.kept(edit);
        }
        for (file, text) in &texts {
            changed(&self.folder.join(file), text)?;
        }
        let drawn = self.draw(edit);
        for (file, _) in &texts {
            let right = fs::read_to_string(workspace().join(file))?;
            changed(&self.folder.join(file), &right)?;
        }
        drawn?;
        fs::write(kept, told)?;
        self.kept(edit)
    }

    fn picture(&self, edit: &Edit, step: Step) -> PathBuf {
        let file = format!("{}.{}.png", edit.name(), step.name());
        self.folder.join("pictures").join(file)
    }

    /// The pictures that there are already.
    pub fn kept(&self, edit: &Edit) -> Result<Vec<(Step, PathBuf)>> {
        let all = edit.steps().iter().map(|&step| (step, self.picture(edit, step)));
        let all: Vec<_> = all.filter(|(_, path)| path.exists()).collect();
        if all.is_empty() { Err("no picture shows it".into()) } else { Ok(all) }
    }

    /// Draws the steps from the edit's own on, until one shows it, and the last.
    fn draw(&self, edit: &Edit) -> Result<()> {
        for &step in edit.steps() {
            let _ = fs::remove_file(self.picture(edit, step));
        }
        let first = edit.steps()[0];
        self.build(&[first, Step::Phong])?;
        self.run(edit, Step::Phong)?;
        for &step in edit.steps() {
            self.build(&[step])?;
            if self.run(edit, step)? {
                break;
            }
        }
        Ok(())
    }

    fn build(&self, steps: &[Step]) -> Result<()> {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["build", "--quiet", "--bins", "--target-dir"]);
        cargo.arg(self.folder.join("build")).current_dir(&self.folder);
        cargo.args(steps.iter().flat_map(|step| ["--package", step.name()]));
        // Quick to build, quick enough to draw.
        cargo.env("CARGO_PROFILE_DEV_OPT_LEVEL", "1");
        let output = cargo.output()?;
        let text = String::from_utf8_lossy(&output.stderr);
        let error = text.lines().find(|line| line.starts_with("error"));
        match output.status.success() {
            true => Ok(()),
            false => Err(format!("does not compile: {error:?}").into()),
        }
    }

    /// Draws the picture of a step, and keeps it where it is not the right one.
    fn run(&self, edit: &Edit, step: Step) -> Result<bool> {
        let path = self.picture(edit, step);
        let program = self.folder.join("build/debug").join(step.name());
        let mut run = Command::new(program);
        run.arg("--output").arg(&path).args(&edit.options);
        if !run.output()?.status.success() {
            return Err(format!("{} does not draw", step.name()).into());
        }
        let shows = image::open(&path)?.to_rgb8() != View::of(edit)?.picture(step);
        if !shows {
            fs::remove_file(path)?;
        }
        Ok(shows)
    }
}

/// Whether a line of the workspace's manifest names no folder but those of the steps.
fn is_of_steps(line: &str) -> bool {
    let member = line.trim().trim_matches(['"', ',']);
    member.is_empty() || !workspace().join(member).is_dir()
}

/// Writes a file only where it changes, so that nothing is compiled twice.
fn changed(path: &Path, text: &str) -> Result<()> {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return Ok(());
    }
    Ok(fs::write(path, text)?)
}
