use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, io};

/// The folder of the chapters, as seen from the root of the workspace.
pub const CHAPTERS: &str = "book/src/";

/// The path to which `path` leads from the file or folder/ `base`.
pub fn resolve_path(base: &str, path: &str) -> String {
    let mut parts: Vec<&str> = base.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." if !parts.is_empty() => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

/// The files of a folder in memory, each by its path in that folder.
#[derive(Clone, Debug, Default)]
pub struct Files(pub BTreeMap<String, Vec<u8>>);

impl Files {
    /// Reads every file in `folder` and in the folders in it.
    pub fn read(folder: &Path) -> io::Result<Self> {
        let mut files = Self::default();
        files.read_into("", folder)?;
        Ok(files)
    }

    fn read_into(&mut self, prefix: &str, folder: &Path) -> io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                self.read_into(&format!("{name}/"), &entry.path())?;
            } else {
                self.0.insert(name, fs::read(entry.path())?);
            }
        }
        Ok(())
    }

    /// The text of the file at `path`, if it is there and is text.
    pub fn text(&self, path: &str) -> Option<&str> {
        str::from_utf8(self.0.get(path)?).ok()
    }

    /// The paths and texts of all files whose path ends in `suffix`.
    pub fn texts_with_suffix(&self, suffix: &str) -> impl Iterator<Item = (&str, &str)> {
        let paths = self.0.keys().filter(move |path| path.ends_with(suffix));
        paths.filter_map(|path| Some((path.as_str(), self.text(path)?)))
    }
}
