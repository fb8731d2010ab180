use check::{Mistake, Step};
use compare::workspace;
use image::RgbImage;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{fs, io};

/// A copy of the steps in `target`, in which one mistake at a time is compiled and drawn.
pub struct Copy {
    folder: PathBuf,
}

impl Copy {
    /// Copies the steps.
    pub fn new() -> io::Result<Self> {
        let folder = workspace().join("target/mistakes");
        let _ = fs::remove_dir_all(folder.join("steps"));
        copy(&workspace().join("steps"), &folder.join("steps"))?;
        fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;
        let text = fs::read_to_string(workspace().join("Cargo.toml"))?;
        fs::write(folder.join("Cargo.toml"), manifest(&text))?;
        Ok(Self { folder })
    }

    /// The pictures that a mistake may spoil, each after its name; none where it does not
    /// compile.
    pub fn draw(&self, mistake: &Mistake) -> io::Result<Vec<(String, RgbImage)>> {
        let file = self.folder.join(&mistake.file);
        let right = fs::read_to_string(&file)?;
        let wrong = mistake.applied(&right).ok_or_else(|| {
            let Mistake { title, file, .. } = mistake;
            io::Error::other(format!("{title}: its text is not in {file}, once"))
        })?;
        fs::write(&file, wrong)?;
        let names = mistake.drawn();
        let is_step = Step::named(&names[0]).is_some();
        let mut build = Command::new("cargo");
        build.args(["build", "--quiet", "--offline"]).current_dir(&self.folder);
        build.env("CARGO_TARGET_DIR", self.folder.join("target"));
        build.env_remove("CARGO_BUILD_TARGET");
        match is_step {
            true => build.arg("--bins"),
            false => build.args(["--example", &names[0]]),
        };
        let built = build.stderr(Stdio::null()).status();
        fs::write(&file, right)?;
        if !built?.success() {
            println!("does not compile: {} ({})", mistake.title, mistake.file);
            return Ok(vec![]);
        }
        let folder = if is_step { "target/debug" } else { "target/debug/examples" };
        let picture = |name: String| {
            let program = self.folder.join(folder).join(&name);
            Some((name, self.picture(&program)?))
        };
        Ok(names.into_iter().filter_map(picture).collect())
    }

    /// What a program draws without options.
    fn picture(&self, program: &Path) -> Option<RgbImage> {
        let file = self.folder.join("picture.png");
        let _ = fs::remove_file(&file);
        let mut program = Command::new(program);
        program.args(["--output".as_ref(), file.as_os_str()]);
        program.stdout(Stdio::null()).stderr(Stdio::null()).status().ok()?;
        Some(image::open(&file).ok()?.to_rgb8())
    }
}

/// The workspace of the copy: that of the course, without what is not in `steps`.
fn manifest(text: &str) -> String {
    let sections = text.split("\n[").filter(|part| part.starts_with("workspace."));
    let is_there =
        |line: &&str| !line.contains("path =") || line.contains("\"steps/");
    let mut new = "[workspace]\nresolver = \"3\"\nmembers = [\"steps/*\"]\n\n\
        [profile.dev]\nopt-level = 1\ndebug = false\n"
        .to_owned();
    for section in sections {
        let lines: Vec<_> = section.lines().filter(is_there).collect();
        new += &format!("\n[{}\n", lines.join("\n"));
    }
    new
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
