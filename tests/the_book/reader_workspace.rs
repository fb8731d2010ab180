//! A workspace like a reader's, in which the tests run the book's commands.

use super::built_book::built_book;
use super::page_items::{TypedFiles, typed_files};
use anyhow::Result;
use builder::{Page, Site};
use course::{target_folder, workspace};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Returns the pages about a step, in the book's order. The pages' names begin with the first word
/// of the step's name, such as `step01`.
pub fn pages_of_step<'a>(book: &'a Site, step: &str) -> impl Iterator<Item = &'a Page> {
    let pages = book.pages_in_order().into_iter();
    pages.filter(move |page| page.name.split('_').next() == step.split('_').next())
}

/// A workspace with only the files that the book shows.
pub struct ReaderWorkspace {
    pub folder: PathBuf,
    /// A lock that makes other tests wait until this test is done with the folder.
    _lock: File,
}

impl ReaderWorkspace {
    /// Opens the workspace. The files from an earlier run are still there, so Cargo only recompiles
    /// what has changed.
    pub fn open() -> Self {
        let folder = target_folder().join("typed");
        fs::create_dir_all(&folder).expect("the folder can be created");
        let lock = File::create(folder.join("lock")).expect("the lock file can be created");
        lock.lock().expect("the lock file can be locked");
        Self { folder, _lock: lock }
    }

    /// Opens the workspace, and writes all of the book's listings into it.
    pub fn with_typed_book() -> Self {
        let (book, reader) = (built_book(), Self::open());
        let typed = typed_files(book.pages_in_order());
        reader.write_files_and_cargo_lock(&typed).expect("the files can be written");
        reader
    }

    pub fn write_files_and_cargo_lock(&self, typed: &TypedFiles) -> Result<()> {
        for (path, text) in typed {
            self.write_if_changed(path, text)?;
        }
        fs::copy(workspace().join("Cargo.lock"), self.folder.join("Cargo.lock"))?;
        Ok(())
    }

    /// Writes a text to a file, unless the file already has this text. Rewriting the same text
    /// would make Cargo compile the file again.
    pub fn write_if_changed(&self, path: &str, text: &str) -> Result<()> {
        let path = self.folder.join(path);
        if fs::read_to_string(&path).ok().as_deref() != Some(text) {
            fs::create_dir_all(path.with_file_name(""))?;
            fs::write(path, text)?;
        }
        Ok(())
    }

    /// Replaces the pattern `steps/*` in the manifest with the paths of the members. Cargo would
    /// put the workspace's path in front of the pattern. If the workspace's path contained square
    /// brackets, Cargo would take the brackets for a part of the pattern, and find no members.
    fn list_members_in_manifest(&self) -> Result<()> {
        let mut members = vec![];
        for entry in fs::read_dir(self.folder.join("steps"))? {
            let entry = entry?;
            if entry.path().join("Cargo.toml").is_file() {
                members.push(format!("steps/{}", entry.file_name().display()));
            }
        }
        members.sort();
        let manifest = fs::read_to_string(self.folder.join("Cargo.toml"))?;
        let expanded = manifest.replace("[\"steps/*\"]", &format!("{members:?}"));
        self.write_if_changed("Cargo.toml", &expanded)
    }

    /// Runs a command with this optimisation level. Returns the command's exit code and what the
    /// command prints.
    pub fn run_command(
        &self,
        program_and_arguments: &[&str],
        opt_level: &str,
    ) -> Result<(Option<i32>, String)> {
        self.list_members_in_manifest()?;
        let mut command = command_in_reader_folder(&self.folder, program_and_arguments);
        command.env("CARGO_TARGET_DIR", "target").env("CARGO_PROFILE_DEV_OPT_LEVEL", opt_level);
        let Output { status, stdout, stderr } = command.output()?;
        let text = String::from_utf8_lossy(&[stderr, stdout].concat()).into_owned();
        Ok((status.code(), text))
    }
}

/// Prepares a command to run in a reader's folder.
pub fn command_in_reader_folder(folder: &Path, program_and_arguments: &[&str]) -> Command {
    let mut command = Command::new(program_and_arguments[0]);
    command.args(&program_and_arguments[1..]).current_dir(folder);
    command.env("CARGO_NET_OFFLINE", "true").env("CARGO_TERM_QUIET", "true");
    // Share our build folder, which already contains the dependencies, compiled with the same
    // settings. The reader's five crates have the same names as our crates. At our optimisation
    // level, the reader's crates would overwrite ours. So callers choose another level.
    command.env("CARGO_BUILD_BUILD_DIR", target_folder()).env("CARGO_INCREMENTAL", "0");
    // The book's commands set INSTA_UPDATE themselves, and INSTA_WORKSPACE_ROOT would point to our
    // folder.
    command.env_remove("INSTA_UPDATE").env_remove("INSTA_WORKSPACE_ROOT");
    // If this variable were set, Cargo would put the programs into a different folder.
    command.env_remove("CARGO_BUILD_TARGET");
    command
}
