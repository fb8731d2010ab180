use super::listing::{Listing, join_listings, page_listings};
use anyhow::{Result, ensure};
use builder::{Page, Site};
use course::{target_folder, workspace};
use image::RgbImage;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::PathBuf;
use std::process::Command;

/// The pages of a step, in the order of the book: the first word of their names is the step's.
pub fn pages_of_step<'a>(book: &'a Site, step: &str) -> impl Iterator<Item = &'a Page> {
    let pages = book.chapters_in_order().into_iter();
    pages.filter(move |page| page.name.split('_').next() == step.split('_').next())
}

/// The listings of each file that were typed so far, by path.
pub type TypedListings<'a> = BTreeMap<&'a str, Vec<Listing<'a>>>;

/// The listings of whole pages.
pub fn typed_listings<'a>(pages: impl IntoIterator<Item = &'a Page>) -> TypedListings<'a> {
    let mut typed = TypedListings::new();
    for listing in pages.into_iter().flat_map(page_listings) {
        typed.entry(listing.path).or_default().push(listing);
    }
    typed
}

/// A workspace with the files that the book shows, and nothing else.
pub struct ReaderWorkspace {
    pub folder: PathBuf,
    /// Makes other processes wait until this one no longer uses the folder.
    _lock: File,
}

impl ReaderWorkspace {
    /// Opens the workspace, in which files of an earlier run may lie: what is written again as it
    /// was, Cargo need not compile again.
    pub fn open() -> Self {
        let folder = target_folder().join("typed");
        fs::create_dir_all(&folder).expect("a folder in the target folder");
        let lock = File::create(folder.join("lock")).expect("a file there");
        lock.lock().expect("other processes end");
        Self { folder, _lock: lock }
    }

    pub fn write_listings(&self, typed: &TypedListings) -> Result<()> {
        for (path, listings) in typed {
            self.write_if_changed(path, &join_listings(listings))?;
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

    /// Runs an example of a step with these options, and reads the picture that it draws;
    /// a warning is an error.
    pub fn draw_example(&self, step: &str, example: &str, options: &str) -> Result<RgbImage> {
        let mut cargo = self.cargo(&["run", "-p", step, "--example", example, "--"]);
        let output = cargo.args(options.split_whitespace()).output()?;
        let message = String::from_utf8_lossy(&output.stderr);
        ensure!(output.status.success() && message.is_empty(), "{message}");
        Ok(image::open(self.folder.join(format!("{example}.png")))?.to_rgb8())
    }

    /// The paths of the pictures that are in the folder itself.
    pub fn picture_paths(&self) -> Result<Vec<PathBuf>> {
        let files = fs::read_dir(&self.folder)?.flatten().map(|file| file.path());
        let is_png = |path: &PathBuf| path.extension().is_some_and(|e| e == "png");
        Ok(files.filter(is_png).collect())
    }

    /// Builds with these arguments of Cargo; an error has Cargo's message.
    pub fn build(&self, arguments: &[&str]) -> Result<()> {
        let output = self.cargo(&["build"]).args(arguments).output()?;
        ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        Ok(())
    }

    /// A command that starts Cargo in the folder, with these arguments.
    pub fn cargo(&self, arguments: &[&str]) -> Command {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["--offline", "--quiet"]).args(arguments).current_dir(&self.folder);
        cargo.env("CARGO_TARGET_DIR", "target");
        // Dependencies are shared with the course: they are compiled already, with the same
        // settings. The five crates have the same names there, and another setting here, so
        // that neither overwrites the other.
        cargo.env("CARGO_BUILD_BUILD_DIR", target_folder());
        cargo.env("CARGO_PROFILE_DEV_OPT_LEVEL", "0");
        // Incremental compilation would not pay: each crate is compiled once or twice.
        cargo.env("CARGO_INCREMENTAL", "0");
        // Commands on a page set INSTA_UPDATE themselves, and lock pictures in this folder.
        cargo.env_remove("INSTA_UPDATE").env("INSTA_WORKSPACE_ROOT", &self.folder);
        // Another platform would put the programs into another folder.
        cargo.env_remove("CARGO_BUILD_TARGET");
        cargo
    }
}
