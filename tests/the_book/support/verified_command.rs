use super::page_items::{FAILED_TEST_EXIT_CODE, PageCommand};
use super::reader_workspace::ReaderWorkspace;
use anyhow::{Context, Result, bail, ensure};
use course::{Difference, workspace};
use std::fs;
use tests::read_snapshot;

/// Runs a command of a page in the reader's workspace. Fails unless its exit code, output
/// and pictures are as the page says; returns the names of the locked pictures it drew.
pub fn run_and_verify_command(
    reader: &ReaderWorkspace,
    command: &PageCommand,
) -> Result<Vec<String>> {
    let package = command.option_value("-p").context("the command names no package")?;
    let subcommand = command.arguments[1].as_str();
    if subcommand == "bench" {
        reader.build(&["-p", package, "--bench", "*"])?;
        return Ok(vec![]);
    }
    for path in reader.picture_paths()? {
        fs::remove_file(path)?;
    }
    make_edit(reader, command)?;
    let (arguments, is_small) = quick_arguments(command);
    let output = reader.cargo(&arguments).envs(command.environment.clone()).output()?;
    let text = [output.stderr, output.stdout].concat();
    let text = String::from_utf8_lossy(&text);
    ensure!(output.status.code() == Some(command.exit_code), "{text}");
    if let Some(line) = command.first_missing_line(&text) {
        bail!("it does not print {line:?}, but {text:?}");
    }
    let paths = reader.picture_paths()?;
    // A program that prints anything but the name of a picture draws none.
    let should_draw = command.exit_code == 0
        && subcommand == "run"
        && command.arguments.iter().all(|word| word != "--help")
        && command.expected_output.iter().all(|line| line.contains(".png"));
    ensure!(should_draw || paths.is_empty(), "it draws");
    ensure!(!should_draw || !paths.is_empty(), "it draws nothing");
    let names = paths.iter().filter_map(|path| path.file_stem()?.to_str());
    let is_locked =
        |name: &&str| workspace().join(format!("tests/snapshots/{name}.snap")).is_file();
    let names: Vec<_> = names.filter(|name| is_locked(name) && !is_small).collect();
    for name in &names {
        let picture = image::open(reader.folder.join(format!("{name}.png")))?;
        if let Some(difference) = Difference::between(&read_snapshot(name), &picture.to_rgb8()) {
            bail!("{name} is another picture: {difference}");
        }
    }
    Ok(names.into_iter().map(str::to_owned).collect())
}

/// The arguments of a command for Cargo, changed to take less time, and whether the
/// picture is smaller therefore: the programs are not optimised here.
fn quick_arguments(command: &PageCommand) -> (Vec<&str>, bool) {
    let arguments = command.arguments[1..].iter();
    let mut arguments: Vec<_> = arguments.map(String::as_str).collect();
    let index = |option| arguments.iter().position(|word| *word == option);
    let width_index = index("--width");
    let is_large = width_index.or(index("--samples")).is_some();
    if command.exit_code != 0 || !is_large {
        return (arguments, false);
    }
    if let Some(index) = width_index {
        arguments.drain(index..index + 2);
    }
    arguments.extend(["--width", "64"]);
    (arguments, true)
}

/// What a page asks to change before the command, in words: a file, and what is written in it
/// instead of what is there. The next listings that are typed change it back.
fn asked_edit(command: &PageCommand) -> Option<(&'static str, [&'static str; 2])> {
    if command.exit_code == FAILED_TEST_EXIT_CODE {
        return Some(("steps/step01_rays/src/direction_colour.rs", ["0.3 *", "0.31 *"]));
    }
    let new = match command.option_value("--output")? {
        "rash.png" => "0, 0.0",
        "shadowed.png" => "0, OFFSET",
        _ => return None,
    };
    Some(("steps/step05_phong/examples/mirror.rs", ["10, OFFSET", new]))
}

fn make_edit(reader: &ReaderWorkspace, command: &PageCommand) -> Result<()> {
    let Some((path, [old, new])) = asked_edit(command) else { return Ok(()) };
    let text = fs::read_to_string(reader.folder.join(path))?;
    ensure!(text.contains(old), "{path} has no {old} to change");
    reader.write_if_changed(path, &text.replace(old, new))
}
