//! Records which files and folders were skipped, and why.

use std::fmt::{self, Display, Formatter};

/// The maximum number of skipped paths that are listed in JSON.
const MAX_LISTED: usize = 100;

/// The maximum number of skipped paths that are listed in a clause.
const MAX_IN_CLAUSE: usize = 8;

/// The first skipped paths, up to `MAX_LISTED` of them, and the number of all skipped paths.
#[derive(Debug, Default)]
pub(crate) struct SkippedPaths {
    pub first: Vec<SkippedPath>,
    pub count: usize,
}

/// A file or folder that was skipped.
#[derive(Debug)]
pub(crate) struct SkippedPath {
    pub printable_path: String,
    pub reason: SkipReason,
}

/// Why a file or folder was skipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SkipReason {
    /// The file isn't named after a picture, or its extension isn't that of a picture.
    OtherName,
    /// The file is in the class's folder, but not in a student's folder.
    BesideFolders,
    Link,
    ToolFolder,
    TooDeep,
    TooManyEntries,
    TooManyFilesOfPicture,
    Unreadable,
}

impl SkippedPaths {
    pub fn add(&mut self, printable_path: String, reason: SkipReason) {
        self.count += 1;
        if self.first.len() < MAX_LISTED {
            self.first.push(SkippedPath { printable_path, reason });
        }
    }

    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Returns a clause that lists up to `MAX_IN_CLAUSE` skipped paths, and says how many more were
    /// skipped. Files that aren't named after a picture come last. Returns None if nothing was
    /// skipped.
    pub fn clause(&self) -> Option<String> {
        let mut sorted: Vec<_> = self.first.iter().collect();
        sorted.sort_by_key(|path| path.reason == SkipReason::OtherName);
        let mut names: Vec<_> = sorted.iter().map(ToString::to_string).collect();
        names.truncate(MAX_IN_CLAUSE);
        let more = self.count - names.len();
        if more > 0 {
            names.push(format!("{more} more"));
        }
        (!self.is_empty()).then(|| format!("not looked at: {}", names.join(", ")))
    }
}

impl Display for SkippedPath {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        let reason = match self.reason {
            SkipReason::OtherName | SkipReason::BesideFolders => "",
            SkipReason::Link => " (a link)",
            SkipReason::ToolFolder => " (a folder of Git or Cargo)",
            SkipReason::TooDeep => " (nested too deeply)",
            SkipReason::TooManyEntries => " (too many files)",
            SkipReason::TooManyFilesOfPicture => " (too many files of this picture)",
            SkipReason::Unreadable => " (can't be read)",
        };
        write!(formatter, "{}{reason}", self.printable_path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clause_puts_other_names_last_and_counts_paths_beyond_the_eighth() {
        let mut skipped = SkippedPaths::default();
        assert_eq!(skipped.clause(), None);
        skipped.add("a.txt".to_owned(), SkipReason::OtherName);
        skipped.add("b".to_owned(), SkipReason::Link);
        assert_eq!(skipped.clause().as_deref(), Some("not looked at: b (a link), a.txt"));
        for k in 0..200 {
            skipped.add(format!("{k}"), SkipReason::OtherName);
        }
        let clause = "not looked at: b (a link), a.txt, 0, 1, 2, 3, 4, 5, 194 more";
        assert_eq!(skipped.clause().as_deref(), Some(clause));
        assert_eq!((skipped.first.len(), skipped.count), (100, 202));
    }
}
