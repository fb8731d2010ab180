//! A scene of a name that students don't know, drawn by their own crates.

use crate::class::report::{Row, count_right, report_answer};
use crate::{Answer, LockedPictures, check_scene_png, escape_for_terminal, read_bounded_file};
use course::{
    NAMED_SCENE_EXAMPLE, OwnScene, Step, format_scene_program, named_scene, target_folder,
    workspace,
};
use std::env::consts::EXE_EXTENSION;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How long the crates of a student may take to compile, and the picture to be drawn.
const COMPILE_TIME: Duration = Duration::from_secs(300);
const DRAW_TIME: Duration = Duration::from_secs(30);

/// The most folders around the five crates in a workspace.
const MOST_FOLDERS: usize = 3;

/// Draws the scene of a name with the crates of each workspace in a folder, and says of each
/// picture whether it is right.
///
/// The sources are compiled in a folder of the course, with its manifests; nothing else of a
/// workspace is copied, no setting of Cargo and no build script. The programs run as the one
/// who asks, unprotected.
pub fn report_on_workspaces(folder: &Path, scene: &str, is_csv: bool) -> Answer {
    let paths = match folders_in(folder) {
        Ok(paths) => paths,
        Err(error) => return Answer::error(format!("{}: {error}", folder.display())),
    };
    let (trial, locked) = (target_folder().join("trial"), LockedPictures::in_workspace());
    let rows = paths.iter().enumerate().flat_map(|(k, path)| {
        let student = path.file_name().unwrap_or_default().to_string_lossy();
        let answer = match draw_with_crates(path, scene, &trial, &trial.join(k.to_string())) {
            Ok(png) => check_scene_png(&png, "its picture", scene, &[], &locked),
            Err(why) => Answer::error(why),
        };
        let row = Row::new(&student, NAMED_SCENE_EXAMPLE, answer, &[]);
        let mut rows = [Row { counts: true, ..row }];
        count_right(&mut rows);
        rows
    });
    report_answer(&rows.collect::<Vec<_>>(), is_csv)
}

/// The folders in a folder that aren't hidden, by their names.
fn folders_in(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder)?.flatten();
    let shown = entries.filter(|entry| !entry.file_name().to_string_lossy().starts_with('.'));
    let mut paths: Vec<_> = shown.map(|entry| entry.path()).filter(|path| path.is_dir()).collect();
    paths.sort();
    Ok(paths)
}

/// The bytes of the picture that the crates in a workspace draw of a scene, or why there is none.
/// They are copied into a folder, which is made anew.
fn draw_with_crates(
    workspace: &Path,
    scene: &str,
    trial: &Path,
    folder: &Path,
) -> Result<Vec<u8>, String> {
    let steps = find_steps(workspace, 0).ok_or("there aren't the five crates")?;
    let _ = fs::remove_dir_all(folder);
    copy_crates(&steps, scene, folder).map_err(|error| format!("can't be copied: {error}"))?;
    let (log, target) = (folder.join("errors.txt"), trial.join("target"));
    let mut cargo = Command::new("cargo");
    cargo.args(["build", "--offline", "--quiet", "-p", Step::Phong.name()]);
    cargo.args(["--example", NAMED_SCENE_EXAMPLE]).env("CARGO_TARGET_DIR", &target);
    if !run_within(cargo.current_dir(folder), &log, COMPILE_TIME)? {
        let text = String::from_utf8_lossy(&fs::read(&log).unwrap_or_default()).into_owned();
        let error = text.lines().find(|line| line.starts_with("error")).unwrap_or_default();
        return Err(format!("the crates don't compile: {}", escape_for_terminal(error)));
    }
    let program = target.join("debug/examples").join(NAMED_SCENE_EXAMPLE);
    let mut program = Command::new(program.with_extension(EXE_EXTENSION));
    if !run_within(program.current_dir(folder), &log, DRAW_TIME)? {
        return Err("the program ends with an error".into());
    }
    read_bounded_file(&folder.join(NAMED_SCENE_EXAMPLE).with_extension("png"))
}

/// The folder in which the five crates are.
fn find_steps(folder: &Path, depth: usize) -> Option<PathBuf> {
    if Step::NAMES.iter().all(|name| folder.join(name).join("src").is_dir()) {
        return Some(folder.to_owned());
    }
    let folders = folders_in(folder).ok().filter(|_| depth < MOST_FOLDERS)?;
    folders.iter().find_map(|folder| find_steps(folder, depth + 1))
}

/// Makes a workspace with the manifests of the course, the sources of a student, and a scene.
fn copy_crates(steps: &Path, scene: &str, folder: &Path) -> io::Result<()> {
    let course = workspace();
    for name in Step::NAMES {
        let (from, to) = (course.join("steps").join(name), folder.join("steps").join(name));
        copy_sources(&steps.join(name).join("src"), &to.join("src"))?;
        let manifest = fs::read_to_string(from.join("Cargo.toml"))?;
        // What only tests and benchmarks need isn't there.
        let end = manifest.find("[dev-dependencies]").unwrap_or(manifest.len());
        fs::write(to.join("Cargo.toml"), &manifest[..end])?;
    }
    let examples = folder.join("steps").join(Step::Phong.name()).join("examples");
    fs::create_dir_all(&examples)?;
    let program = format_scene_program(&OwnScene::new(named_scene(scene)));
    fs::write(examples.join(NAMED_SCENE_EXAMPLE).with_extension("rs"), program)?;
    fs::copy(course.join("book/reader/Cargo.toml"), folder.join("Cargo.toml"))?;
    fs::copy(course.join("Cargo.lock"), folder.join("Cargo.lock"))?;
    Ok(())
}

/// Copies the Rust files of a folder, and of those in it; no links. Each is as new as its copy,
/// so that Cargo takes none for one that it has compiled.
fn copy_sources(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)?.flatten() {
        let (path, copy, kind) = (entry.path(), to.join(entry.file_name()), entry.file_type()?);
        if kind.is_dir() {
            copy_sources(&path, &copy)?;
        } else if kind.is_file() && path.extension().is_some_and(|one| one == "rs") {
            fs::write(copy, fs::read(&path)?)?;
        }
    }
    Ok(())
}

/// Runs a program, whose errors go into a file; false where it fails, an error where it can't be
/// started or takes longer.
fn run_within(command: &mut Command, errors: &Path, limit: Duration) -> Result<bool, String> {
    let file = File::create(errors).map_err(|error| error.to_string())?;
    let command = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(file);
    let mut child = command.spawn().map_err(|error| format!("can't be started: {error}"))?;
    let start = Instant::now();
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Ok(status.success()),
            _ if start.elapsed() < limit => sleep(Duration::from_millis(20)),
            _ => {
                let _ = (child.kill(), child.wait());
                return Err(format!("takes longer than {} seconds", limit.as_secs()));
            }
        }
    }
}
