//! A scene of a name that students don't know, drawn by their own crates.

use crate::class::found_file::FoundFile;
use crate::class::report::{Row, count_right, report_answer};
use crate::class::search::{MOST_FOLDERS, find_files};
use crate::class::student::group_by_student;
use crate::{Answer, check_scene_png, read_bounded_file};
use course::{
    NAMED_SCENE_EXAMPLE, OwnScene, Step, cargo_command, format_scene_program, named_scene,
    target_folder, workspace,
};
use std::env::consts::EXE_SUFFIX;
use std::error::Error;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How long the crates of a student may take to compile, and the picture to be drawn.
const COMPILE_TIME: Duration = Duration::from_secs(300);
const DRAW_TIME: Duration = Duration::from_secs(30);

/// Where a workspace has the crate that needs all others.
const LAST_CRATE: &str = "step05_phong/src/lib.rs";

/// Draws the scene of a name with the crates of each student in a folder, and says of each
/// picture whether it is right.
///
/// The sources are compiled in a folder of the course, with its manifests; nothing else is
/// copied, no setting of Cargo and no build script. The programs run as the one who asks,
/// unprotected.
pub fn report_on_workspaces(folder: &Path, scene: &str, is_csv: bool) -> Result<Answer, String> {
    let (students, _) = group_by_student(find_files(folder, MOST_FOLDERS)?);
    let rows = students.iter().flat_map(|student| {
        let answer = match draw_with_crates(&student.files, scene) {
            Ok(png) => check_scene_png(&png, "its picture", scene, &[]),
            Err(why) => Answer::error(why),
        };
        count_right(vec![Row::new(&student.key, NAMED_SCENE_EXAMPLE, answer, &[])])
    });
    Ok(report_answer(&rows.collect::<Vec<_>>(), is_csv))
}

/// The bytes of the picture that the crates among some files draw of a scene, or why there is
/// none. They are copied into a folder that is emptied first, and the last program is removed, so
/// that nobody gets what another's have drawn.
fn draw_with_crates(files: &[FoundFile], scene: &str) -> Result<Vec<u8>, String> {
    let trial = target_folder().join("trial");
    let (folder, target) = (&trial.join("workspace"), trial.join("target"));
    let mut starts = files.iter().filter_map(|file| file.path.strip_suffix(LAST_CRATE));
    let start = starts.next().ok_or("there aren't the five crates")?;
    let _ = fs::remove_dir_all(folder);
    make_workspace(files, start, scene, folder)
        .map_err(|error| format!("can't be copied: {error}"))?;
    let log = folder.join("errors.txt");
    let program = target.join(format!("debug/examples/{NAMED_SCENE_EXAMPLE}{EXE_SUFFIX}"));
    let _ = fs::remove_file(&program);
    let mut cargo = cargo_command();
    cargo.args(["build", "--offline", "--quiet", "-p", Step::Phong.name()]);
    cargo.args(["--example", NAMED_SCENE_EXAMPLE]).env("CARGO_TARGET_DIR", &target);
    if !run_within(cargo.current_dir(folder), &log, COMPILE_TIME)? {
        let text = String::from_utf8_lossy(&fs::read(&log).unwrap_or_default()).into_owned();
        let error = text.lines().find(|line| line.starts_with("error")).unwrap_or_default();
        return Err(format!("the crates don't compile: {error}"));
    }
    if !run_within(Command::new(program).current_dir(folder), &log, DRAW_TIME)? {
        return Err("the program ends with an error".into());
    }
    read_bounded_file(&folder.join(NAMED_SCENE_EXAMPLE).with_extension("png"))
}

/// Makes a workspace of the Rust files of the five crates in the folder `start`, the manifests of
/// the course, and a scene as a program. Each file is as new as its copy, so that Cargo takes none
/// for one that it has compiled.
fn make_workspace(
    files: &[FoundFile],
    start: &str,
    scene: &str,
    folder: &Path,
) -> Result<(), Box<dyn Error>> {
    let write = |path: &str, bytes: &[u8]| {
        let path = folder.join("steps").join(path);
        fs::create_dir_all(path.parent().unwrap_or(folder))?;
        fs::write(path, bytes)
    };
    for name in Step::NAMES {
        let manifest = fs::read_to_string(workspace().join(format!("steps/{name}/Cargo.toml")))?;
        // What only tests and benchmarks need isn't there.
        let end = manifest.find("[dev-dependencies]").unwrap_or(manifest.len());
        write(&format!("{name}/Cargo.toml"), &manifest.as_bytes()[..end])?;
        let sources = format!("{start}{name}/src/");
        let is_source = |path: &str| path.starts_with(&sources) && path.ends_with(".rs");
        for file in files.iter().filter(|file| is_source(&file.path)) {
            write(&file.path[start.len()..], &file.read()?)?;
        }
    }
    let program = format_scene_program(&OwnScene::new(named_scene(scene)));
    let path = format!("{}/examples/{NAMED_SCENE_EXAMPLE}.rs", Step::Phong.name());
    write(&path, program.as_bytes())?;
    fs::copy(workspace().join("book/reader/Cargo.toml"), folder.join("Cargo.toml"))?;
    fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;
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
