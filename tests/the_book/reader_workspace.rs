//! A workspace as a reader has it, in which the commands of the book are run.

use super::built_book::built_book;
use super::page_items::{TypedFiles, typed_files};
use anyhow::Result;
use builder::{Page, Site};
use course::{target_folder, workspace};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The pages of a step, in the order of the book. Their names begin with the first word of the
/// step's name.
pub fn pages_of_step<'a>(book: &'a Site, step: &str) -> impl Iterator<Item = &'a Page> {
    let pages = book.pages_in_order().into_iter();
    pages.filter(move |page| page.name.split('_').next() == step.split('_').next())
}

/// A workspace with the files that the book shows, and nothing else.
pub struct ReaderWorkspace {
    pub folder: PathBuf,
    /// Makes other tests wait until this one no longer uses the folder.
    _lock: File,
}

impl ReaderWorkspace {
    /// Opens the workspace. Files of an earlier run may be in it, so that Cargo doesn't compile
    /// again what hasn't changed.
    pub fn open() -> Self {
        let folder = target_folder().join("typed");
        fs::create_dir_all(&folder).expect("a folder in the target folder");
        let lock = File::create(folder.join("lock")).expect("a file there");
        lock.lock().expect("other tests end");
        Self { folder, _lock: lock }
    }

    /// Opens the workspace and writes all the listings of the book into it.
    pub fn with_typed_book() -> Self {
        let (book, reader) = (built_book(), Self::open());
        let typed = typed_files(book.pages_in_order());
        reader.write_files(&typed).expect("the files can be written");
        reader
    }

    pub fn write_files(&self, typed: &TypedFiles) -> Result<()> {
        for (path, text) in typed {
            self.write_if_changed(path, text)?;
        }
        fs::copy(workspace().join("Cargo.lock"), self.folder.join("Cargo.lock"))?;
        Ok(())
    }

    pub fn write_if_changed(&self, path: &str, text: &str) -> Result<()> {
        let path = self.folder.join(path);
        if fs::read_to_string(&path).ok().as_deref() != Some(text) {
            fs::create_dir_all(path.with_file_name(""))?;
            fs::write(path, text)?;
        }
        Ok(())
    }

    /// Lists the members of the workspace by name. Cargo reads `steps/*` as a pattern together with
    /// the path of the folder, so it finds no member if that path has square brackets.
    fn list_members(&self) -> Result<()> {
        let mut members = vec![];
        for entry in fs::read_dir(self.folder.join("steps"))? {
            let entry = entry?;
            if entry.path().join("Cargo.toml").is_file() {
                members.push(format!("steps/{}", entry.file_name().display()));
            }
        }
        members.sort();
        let manifest = fs::read_to_string(self.folder.join("Cargo.toml"))?;
        let manifest = manifest.replace("[\"steps/*\"]", &format!("{members:?}"));
        self.write_if_changed("Cargo.toml", &manifest)
    }

    /// Runs a program with its arguments, at this optimisation level. Returns the exit code and
    /// what is printed.
    pub fn run(&self, words: &[&str], opt_level: &str) -> Result<(Option<i32>, String)> {
        self.list_members()?;
        let mut command = folder_command(&self.folder, words);
        command.env("CARGO_TARGET_DIR", "target").env("CARGO_PROFILE_DEV_OPT_LEVEL", opt_level);
        let Output { status, stdout, stderr } = command.output()?;
        let text = String::from_utf8_lossy(&[stderr, stdout].concat()).into_owned();
        Ok((status.code(), text))
    }
}

/// A command that runs a program with its arguments in a reader's folder.
pub fn folder_command(folder: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(words[0]);
    command.args(&words[1..]).current_dir(folder);
    command.env("CARGO_NET_OFFLINE", "true").env("CARGO_TERM_QUIET", "true");
    // Dependencies are shared with ours, which are already compiled with the same settings. The
    // five crates have the same names here and there, so the callers optimise them differently, and
    // neither overwrites the other.
    command.env("CARGO_BUILD_BUILD_DIR", target_folder()).env("CARGO_INCREMENTAL", "0");
    // The commands set INSTA_UPDATE themselves, and INSTA_WORKSPACE_ROOT is our folder.
    command.env_remove("INSTA_UPDATE").env_remove("INSTA_WORKSPACE_ROOT");
    // With a target, the programs would be in another folder.
    command.env_remove("CARGO_BUILD_TARGET");
    command
}
