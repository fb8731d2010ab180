//! The files in a folder, and what in it isn't looked at, and why. Links aren't followed, and a
//! folder is read within bounds of its entries and of its depth.

use crate::answer::join_first;
use crate::escape_for_terminal;
use std::collections::VecDeque;
use std::ffi::{OsStr, OsString};
use std::fmt::{self, Display, Formatter};
use std::fs::{self, DirEntry};
use std::path::{Path, PathBuf};

/// The most entries of a class's folder, and the most that a student's has with all below it.
pub(crate) const MOST_ENTRIES: usize = 10_000;

/// The most folders in each other, the student's own among them.
const MOST_FOLDERS: usize = 8;

/// The most names of files in a clause.
const MOST_NAMES: usize = 8;

/// Folders that Git and Cargo fill, and that hold nothing to look at.
const TOOL_FOLDERS: [&str; 2] = [".git", "target"];

/// Extensions of files that may have been meant as a picture.
const PICTURE_EXTENSIONS: [&str; 14] = [
    "png", "jpg", "jpeg", "jfif", "webp", "gif", "bmp", "ppm", "tif", "tiff", "heic", "avif",
    "svg", "pdf",
];

/// The folder of a class.
pub(crate) struct ClassFolder {
    pub students: Vec<StudentFolder>,
    /// What lies beside the students' folders.
    pub not_looked_at: Vec<Skipped>,
}

/// A student's folder.
pub(crate) struct StudentFolder {
    pub name: OsString,
    /// The files in it and below, those with fewest folders around them first.
    pub files: Vec<FoundFile>,
    pub not_looked_at: Vec<Skipped>,
}

/// A file in a student's folder.
pub(crate) struct FoundFile {
    pub path: PathBuf,
    /// The path below the student's folder, for a table.
    pub printable_path: String,
}

impl FoundFile {
    /// The file's own name, for a table.
    pub fn printable_name(&self) -> &str {
        self.printable_path.rsplit('/').next().unwrap_or_default()
    }

    /// Whether the file may have been meant as a picture, by the end of its name.
    pub fn may_be_picture(&self) -> bool {
        let extension = self.path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        PICTURE_EXTENSIONS.contains(&&*extension)
    }
}

/// Something that isn't looked at.
#[derive(Clone)]
pub(crate) struct Skipped {
    pub printable_path: String,
    pub reason: SkipReason,
}

/// Why something isn't looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum SkipReason {
    /// The name of a file isn't that of a picture.
    OtherName,
    /// A file or a link lies beside the students' folders.
    BesideFolders,
    Link,
    ToolFolder,
    TooDeep,
    TooManyEntries,
    TooManyFilesOfPicture,
    Unreadable,
}

impl Display for Skipped {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        let reason = match self.reason {
            SkipReason::OtherName | SkipReason::BesideFolders => "",
            SkipReason::Link => " (a link)",
            SkipReason::ToolFolder => " (a folder of Git or Cargo)",
            SkipReason::TooDeep => " (in too many folders)",
            SkipReason::TooManyEntries => " (too many files)",
            SkipReason::TooManyFilesOfPicture => " (too many files of this picture)",
            SkipReason::Unreadable => " (can't be read)",
        };
        write!(formatter, "{}{reason}", self.printable_path)
    }
}

/// A clause with the first of what wasn't looked at, and how much more there is. What has a reason
/// comes first.
pub(crate) fn not_looked_at_clause(skipped: &[Skipped]) -> Option<String> {
    let mut sorted: Vec<_> = skipped.iter().collect();
    sorted.sort_by_key(|one| one.reason == SkipReason::OtherName);
    let names = sorted.iter().map(ToString::to_string).collect();
    let clause = || format!("not looked at: {}", join_first(names, MOST_NAMES, ", "));
    (!skipped.is_empty()).then(clause)
}

/// Reads the folder of a class, in which each folder is a student's.
pub(crate) fn read_class_folder(folder: &Path) -> Result<ClassFolder, String> {
    let mut class = ClassFolder { students: vec![], not_looked_at: vec![] };
    for entry in read_top_folder(folder)? {
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            class.students.push(read_student_folder(entry.file_name(), entry.path()));
        } else {
            let printable_path = printable_name(&entry.file_name());
            class.not_looked_at.push(Skipped { printable_path, reason: SkipReason::BesideFolders });
        }
    }
    if class.students.is_empty() {
        let folder = printable_name(folder.as_os_str());
        let clause = not_looked_at_clause(&class.not_looked_at);
        let clause = clause.map(|clause| format!("; {clause}")).unwrap_or_default();
        return Err(format!("{folder} has no folders, one for each student{clause}"));
    }
    Ok(class)
}

/// Reads the folder of somebody's own pictures; what is below it isn't looked at.
pub(crate) fn read_own_folder(folder: &Path) -> Result<StudentFolder, String> {
    let mut own = StudentFolder { name: OsString::new(), files: vec![], not_looked_at: vec![] };
    for entry in read_top_folder(folder)? {
        let (path, printable_path) = (entry.path(), printable_name(&entry.file_name()));
        let file = FoundFile { path, printable_path };
        if file.may_be_picture() && !file.path.is_dir() {
            own.files.push(file);
        }
    }
    Ok(own)
}

/// Reads a student's folder and all below it, breadth first, so that the bound cuts off what lies
/// deepest.
fn read_student_folder(name: OsString, path: PathBuf) -> StudentFolder {
    let mut student = StudentFolder { name, files: vec![], not_looked_at: vec![] };
    let mut entries_left = MOST_ENTRIES;
    let mut unread = VecDeque::from([(path, String::new(), 1)]);
    while let Some((folder, printable_folder, depth)) = unread.pop_front() {
        let mut skip = |printable_path: String, reason| {
            student.not_looked_at.push(Skipped { printable_path, reason });
        };
        let entries = match read_entries(&folder, entries_left) {
            Ok(entries) => entries,
            Err(reason) => {
                let is_top = printable_folder.is_empty();
                skip(if is_top { "the folder".to_owned() } else { printable_folder }, reason);
                continue;
            }
        };
        entries_left -= entries.len();
        for entry in entries {
            let (path, name) = (entry.path(), entry.file_name());
            let printable_path = format!("{printable_folder}{}", printable_name(&name));
            match entry.file_type() {
                Err(_) => skip(printable_path, SkipReason::Unreadable),
                Ok(kind) if kind.is_symlink() => skip(printable_path, SkipReason::Link),
                Ok(kind) if !kind.is_dir() => {
                    student.files.push(FoundFile { path, printable_path });
                }
                Ok(_) if TOOL_FOLDERS.iter().any(|tool| name == *tool) => {
                    skip(printable_path + "/", SkipReason::ToolFolder);
                }
                Ok(_) if depth == MOST_FOLDERS => skip(printable_path + "/", SkipReason::TooDeep),
                Ok(_) => unread.push_back((path, printable_path + "/", depth + 1)),
            }
        }
    }
    student
}

/// The entries of the folder that somebody names.
fn read_top_folder(folder: &Path) -> Result<Vec<DirEntry>, String> {
    let printable = printable_name(folder.as_os_str());
    read_entries(folder, MOST_ENTRIES).map_err(|reason| match reason {
        SkipReason::TooManyEntries => format!("{printable} has more than {MOST_ENTRIES} entries"),
        _ => format!("{printable} is no folder that can be read"),
    })
}

/// The entries of a folder in the order of their names. A folder with more than `most` isn't read
/// in part, since which part would depend on the file system.
fn read_entries(folder: &Path, most: usize) -> Result<Vec<DirEntry>, SkipReason> {
    let entries = fs::read_dir(folder).map_err(|_| SkipReason::Unreadable)?;
    let entries: Result<Vec<_>, _> = entries.take(most + 1).collect();
    let mut entries = entries.map_err(|_| SkipReason::Unreadable)?;
    if entries.len() > most {
        return Err(SkipReason::TooManyEntries);
    }
    entries.sort_by_key(DirEntry::file_name);
    Ok(entries)
}

/// A name for a table, in which bytes that aren't UTF-8 are escaped, and so are characters that a
/// terminal obeys.
pub(crate) fn printable_name(name: &OsStr) -> String {
    let mut printable = String::new();
    for chunk in name.as_encoded_bytes().utf8_chunks() {
        printable += &escape_for_terminal(chunk.valid());
        printable.extend(chunk.invalid().iter().map(|byte| format!("\\x{byte:02x}")));
    }
    printable
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(unix)]
    fn names_that_are_not_utf8_stay_apart() {
        use std::os::unix::ffi::OsStrExt;
        let names = [b"J\x94rg", b"J\x81rg"].map(|bytes| printable_name(OsStr::from_bytes(bytes)));
        assert_eq!(names, ["J\\x94rg", "J\\x81rg"]);
    }
}
