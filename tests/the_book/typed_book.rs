//! Tests that a reader needs nothing but the book. The test types the book's listings from the
//! first page to the last, and asserts that the commands do what the pages say. `source_listings`
//! tests that every file is complete at the end.

use super::built_book::built_book;
use super::page_items::{PageCommand, PageItem, TypedFiles, headings_listings_and_commands};
use super::reader_workspace::ReaderWorkspace;
use anyhow::{Error, Result, ensure};
use course::{PICTURES, describe_difference, locked_picture_path, read_locked_picture};
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

/// An edit that a page asks the reader to make before a command. Before the next command, the files
/// are written again, which undoes the edit.
struct Edit {
    /// The end of the command's line. The line begins with the prompt `$ `.
    command_end: &'static str,
    file: &'static str,
    old: &'static str,
    new: &'static str,
}

const EDITS: [Edit; 3] = [
    Edit {
        command_end: "$ cargo test -p locked",
        file: "steps/step01_rays/src/direction_colour.rs",
        old: "0.3 *",
        new: "0.31 *",
    },
    Edit {
        command_end: "rash.png",
        file: "steps/step05_phong/examples/mirror.rs",
        old: "10, OFFSET",
        new: "0, 0.0",
    },
    Edit {
        command_end: "shadowed.png",
        file: "steps/step05_phong/examples/mirror.rs",
        old: "10, OFFSET",
        new: "0, OFFSET",
    },
];

#[test]
#[ignore = "takes minutes: cargo test -- --include-ignored"]
fn commands_do_what_their_pages_say() -> Result<()> {
    let (book, reader) = (built_book(), ReaderWorkspace::open());
    let _ = fs::remove_dir_all(reader.folder.join("steps"));
    let (mut typed, mut commands_for_later) = (TypedFiles::new(), vec![]);
    let mut drawn_names = BTreeSet::new();
    for item in book.pages_in_order().into_iter().flat_map(headings_listings_and_commands) {
        match item {
            PageItem::Listing(path, code) => *typed.entry(path).or_default() += &code,
            PageItem::Command(command) if runs_unlisted_example(&command, &typed) => {
                commands_for_later.push(command);
            }
            PageItem::Command(command) => {
                reader.write_files_and_cargo_lock(&typed)?;
                drawn_names.extend(run_and_list_verified_pictures(&reader, &command)?);
            }
            PageItem::Heading => {}
        }
    }
    reader.write_files_and_cargo_lock(&typed)?;
    for command in commands_for_later {
        drawn_names.extend(run_and_list_verified_pictures(&reader, &command)?);
    }
    let names = PICTURES.iter().map(|(name, _)| *name).chain(["cover", "shadowed", "goodbye"]);
    let missing: Vec<_> = names.filter(|name| !drawn_names.contains(*name)).collect();
    ensure!(missing.is_empty(), "no command draws {missing:?}");
    Ok(())
}

/// Whether a command runs an example that isn't among the files typed so far. Such an example is
/// the reader's own solution to an exercise.
fn runs_unlisted_example(PageCommand { line, .. }: &PageCommand, typed: &TypedFiles) -> bool {
    line.split_once("--example ").is_some_and(|(_, words)| {
        let file = format!("/examples/{}.rs", words.split(' ').next().unwrap_or_default());
        !typed.keys().any(|path| path.ends_with(&file))
    })
}

/// Runs a page's command in the reader's workspace. Returns the names of the locked pictures that
/// the command drew, or an error if the exit code, the output or a picture differs from what the
/// page says.
fn run_and_list_verified_pictures(
    reader: &ReaderWorkspace,
    command: &PageCommand,
) -> Result<Vec<String>> {
    for path in png_paths(reader)? {
        fs::remove_file(path)?;
    }
    for Edit { command_end, file, old, new } in EDITS {
        if format!("$ {}", command.line).ends_with(command_end) {
            let text = fs::read_to_string(reader.folder.join(file))?;
            ensure!(text.contains(old), "{file} does not contain `{old}`");
            reader.write_if_changed(file, &text.replace(old, new))?;
        }
    }
    // Avoid release builds and benchmarks, because either would take minutes.
    let line = command.line.replace("cargo bench", "cargo build").replace(" --release", "");
    let location = format!("At {}, {}", command.location, command.line);
    let (code, text) = reader.run_command(&["bash", "-c", &line], "1")?;
    ensure!(code == Some(command.exit_code), "{location}: {text}");
    let mut expected_parts = command.output.lines().flat_map(|line| line.split('…'));
    let missing_part = expected_parts.find(|part| !text.contains(part));
    ensure!(missing_part.is_none(), "{location} does not print {missing_part:?}, but {text}");
    let mut names = vec![];
    let has_custom_size = command.line.contains("--width") && !command.line.contains("--output");
    for path in png_paths(reader)?.into_iter().filter(|_| !has_custom_size) {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if locked_picture_path(&name).is_file() {
            let picture = image::open(path)?.to_rgb8();
            let locked = read_locked_picture(&name).map_err(Error::msg)?;
            let difference = describe_difference(&locked, &picture);
            ensure!(difference.is_none(), "{location} draws a wrong {name}: {difference:?}");
            names.push(name);
        }
    }
    Ok(names)
}

/// The paths of the PNG files directly in the reader's folder.
fn png_paths(reader: &ReaderWorkspace) -> Result<Vec<PathBuf>> {
    let files = fs::read_dir(&reader.folder)?.flatten().map(|file| file.path());
    Ok(files.filter(|path| path.extension().is_some_and(|end| end == "png")).collect())
}
