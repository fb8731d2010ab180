//! Reads a folder's files into memory, and resolves relative paths.

use anyhow::{Context, Result};
use course::replace_file;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The folder of the chapters, relative to the root of the workspace.
pub const CHAPTERS: &str = "book/src/";

/// Resolves `path` relative to `base`. A `base` that ends in `/` is a folder. Any other `base` is a
/// file, and `path` is relative to the folder of that file.
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

/// The files of a folder in memory, keyed by their paths relative to that folder.
#[derive(Clone, Debug, Default)]
pub struct Files(pub BTreeMap<String, Vec<u8>>);

impl Files {
    /// Reads every file in `folder` and its subfolders.
    pub fn read(folder: &Path) -> Result<Self> {
        let (mut files, mut folders) = (BTreeMap::new(), vec![folder.to_owned()]);
        while let Some(subfolder) = folders.pop() {
            let unreadable = || format!("{} can't be read", subfolder.display());
            for entry in fs::read_dir(&subfolder).with_context(unreadable)? {
                let path = entry?.path();
                if path.is_dir() {
                    folders.push(path);
                } else {
                    let name = path.strip_prefix(folder)?.to_string_lossy().replace('\\', "/");
                    files.insert(name, fs::read(&path).with_context(unreadable)?);
                }
            }
        }
        Ok(Self(files))
    }

    /// Makes `folder` contain these files and no others. Leaves up-to-date files alone, because
    /// rewriting such a file would make `mdbook serve` rebuild the book.
    pub fn sync_to(&self, folder: &Path) -> Result<()> {
        fs::create_dir_all(folder)
            .with_context(|| format!("{} can't be created", folder.display()))?;
        let old = Self::read(folder)?.0;
        for (name, bytes) in self.0.iter().filter(|(name, bytes)| old.get(*name) != Some(bytes)) {
            let path = folder.join(name);
            replace_file(&path, bytes)
                .with_context(|| format!("{} can't be written", path.display()))?;
        }
        for stale in old.keys().filter(|name| !self.0.contains_key(*name)) {
            let _ = fs::remove_file(folder.join(stale));
        }
        Ok(())
    }

    /// The text of the file at `path`, or None if there is no such file or the file isn't UTF-8.
    pub fn text(&self, path: &str) -> Option<&str> {
        str::from_utf8(self.0.get(path)?).ok()
    }

    /// The path and text of each UTF-8 file whose path ends in `suffix`.
    pub fn texts_with_suffix(&self, suffix: &str) -> impl Iterator<Item = (&str, &str)> {
        let paths = self.0.keys().filter(move |path| path.ends_with(suffix));
        paths.filter_map(|path| Some((path.as_str(), self.text(path)?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn path_is_resolved_from_a_file_or_folder() {
        for (base, path, resolved) in [
            ("a/b.html", "c.html", "a/c.html"),
            ("a/b/", "../c", "a/c"),
            ("a/b/", "./c/./d", "a/b/c/d"),
            ("b.html", "../c", "../c"),
        ] {
            assert_eq!(resolve_path(base, path), resolved, "{base} {path}");
        }
    }
}
