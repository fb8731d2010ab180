//! Finds the students' folders in a class's folder, and the files in a student's folder. Both
//! searches skip links and limit the number of entries. The search for files also limits the depth
//! of nesting. Also finds a reader's own pictures. That search accepts links to pictures.

use crate::class::skipped_paths::{SkipReason, SkippedPaths};
use crate::escape_for_terminal;
use std::collections::VecDeque;
use std::ffi::{OsStr, OsString};
use std::fs::{self, DirEntry};
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The maximum number of files and folders in a class's folder. A student's folder and its
/// subfolders together have the same limit.
pub(crate) const MAX_ENTRIES: usize = 10_000;

/// The maximum depth of nested folders. The student's own folder has depth 1.
const MAX_DEPTH: usize = 8;

/// Folders that Git and Cargo fill. We skip them, because they contain nothing that was handed in
/// on purpose.
const TOOL_FOLDERS: [&str; 2] = [".git", "target"];

/// The extensions of files that may have been meant as pictures.
const PICTURE_EXTENSIONS: [&str; 14] = [
    "png", "jpg", "jpeg", "jfif", "webp", "gif", "bmp", "ppm", "tif", "tiff", "heic", "avif",
    "svg", "pdf",
];

/// Why a folder can't be reported on. The paths are escaped for a terminal.
#[derive(Debug, Error)]
pub enum FolderError {
    /// The path isn't a folder, or the folder can't be read.
    #[error("{0} is not a folder that can be read")]
    Unreadable(String),
    /// The folder has too many entries.
    #[error("{0} has more than {MAX_ENTRIES} entries")]
    TooManyEntries(String),
    /// The class's folder contains no folders.
    #[error("{folder} contains no folders; it needs one for each student{}", prepend_semicolon(.skipped_paths))]
    NoStudents {
        /// The class's folder.
        folder: String,
        /// A clause that lists what the class's folder contains instead. None if the folder is
        /// empty.
        skipped_paths: Option<String>,
    },
}

fn prepend_semicolon(clause: &Option<String>) -> String {
    clause.as_ref().map(|clause| format!("; {clause}")).unwrap_or_default()
}

/// A class's folder.
pub(crate) struct ClassFolder {
    pub students: Vec<StudentFolder>,
    /// Everything in the class's folder that isn't a student's folder.
    pub skipped_paths: SkippedPaths,
}

/// A student's folder.
pub(crate) struct StudentFolder {
    pub name: OsString,
    pub path: PathBuf,
}

/// The contents of a student's folder.
#[derive(Default)]
pub(crate) struct FolderContents {
    /// The files in the folder and its subfolders, the least deeply nested first.
    pub files: Vec<FoundFile>,
    pub skipped_paths: SkippedPaths,
}

/// A file in a student's folder, or one of a reader's own pictures.
pub(crate) struct FoundFile {
    pub path: PathBuf,
    /// The path relative to the student's or the reader's folder, escaped for a terminal.
    pub printable_path: String,
}

impl FoundFile {
    /// The file name, escaped for a terminal.
    pub fn printable_name(&self) -> &str {
        self.printable_path.rsplit('/').next().unwrap_or_default()
    }

    /// Whether the extension suggests that the file was meant as a picture.
    pub fn may_be_picture(&self) -> bool {
        let extension = self.path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        PICTURE_EXTENSIONS.contains(&&*extension)
    }
}

/// Reads a class's folder. Every folder inside belongs to one student.
pub(crate) fn read_class_folder(folder: &Path) -> Result<ClassFolder, FolderError> {
    let mut class = ClassFolder { students: vec![], skipped_paths: SkippedPaths::default() };
    for entry in read_top_folder(folder)? {
        let (name, path, kind) = (entry.file_name(), entry.path(), entry.file_type());
        let mut skip = |reason| class.skipped_paths.add(printable_name(&name), reason);
        match kind {
            Ok(kind) if kind.is_dir() => class.students.push(StudentFolder { name, path }),
            Ok(kind) if kind.is_symlink() => skip(SkipReason::Link),
            Ok(_) => skip(SkipReason::BesideFolders),
            Err(_) => skip(SkipReason::Unreadable),
        }
    }
    if class.students.is_empty() {
        let folder = printable_name(folder.as_os_str());
        let skipped_paths = class.skipped_paths.clause();
        return Err(FolderError::NoStudents { folder, skipped_paths });
    }
    Ok(class)
}

/// Finds a reader's own pictures in a folder. Ignores subfolders.
pub(crate) fn find_own_pictures(folder: &Path) -> Result<FolderContents, FolderError> {
    let mut contents = FolderContents::default();
    for entry in read_top_folder(folder)? {
        let (path, printable_path) = (entry.path(), printable_name(&entry.file_name()));
        let file = FoundFile { path, printable_path };
        if file.may_be_picture() && !file.path.is_dir() {
            contents.files.push(file);
        }
    }
    Ok(contents)
}

/// A folder that hasn't been read yet.
struct UnreadFolder {
    path: PathBuf,
    /// The path relative to the student's folder, ending in `/`. Empty for the student's folder
    /// itself.
    printable_path: String,
    /// The depth of nesting, which is 1 for the student's own folder.
    depth: usize,
}

/// Finds the files in a student's folder and its subfolders. The search is breadth-first, so that
/// the limit on entries cuts off the most deeply nested files.
pub(crate) fn find_files(student: &StudentFolder) -> FolderContents {
    let FolderContents { mut files, mut skipped_paths } = FolderContents::default();
    let mut entries_left = MAX_ENTRIES;
    let top_folder =
        UnreadFolder { path: student.path.clone(), printable_path: String::new(), depth: 1 };
    let mut unread = VecDeque::from([top_folder]);
    while let Some(folder) = unread.pop_front() {
        let entries = match read_entries(&folder.path, entries_left) {
            Ok(entries) => entries,
            Err(reason) => {
                let is_top = folder.printable_path.is_empty();
                let name = if is_top { "the folder".to_owned() } else { folder.printable_path };
                skipped_paths.add(name, reason);
                continue;
            }
        };
        entries_left -= entries.len();
        for entry in entries {
            let (path, name) = (entry.path(), entry.file_name());
            let printable_path = format!("{}{}", folder.printable_path, printable_name(&name));
            let is_tool_folder = TOOL_FOLDERS.iter().any(|tool| name == *tool);
            match entry.file_type() {
                Err(_) => skipped_paths.add(printable_path, SkipReason::Unreadable),
                Ok(kind) if kind.is_symlink() => {
                    skipped_paths.add(printable_path, SkipReason::Link);
                }
                Ok(kind) if !kind.is_dir() => files.push(FoundFile { path, printable_path }),
                Ok(_) if is_tool_folder => {
                    skipped_paths.add(printable_path + "/", SkipReason::ToolFolder);
                }
                Ok(_) if folder.depth == MAX_DEPTH => {
                    skipped_paths.add(printable_path + "/", SkipReason::TooDeep);
                }
                Ok(_) => {
                    let (printable_path, depth) = (printable_path + "/", folder.depth + 1);
                    unread.push_back(UnreadFolder { path, printable_path, depth });
                }
            }
        }
    }
    FolderContents { files, skipped_paths }
}

/// Reads the entries of a folder that was given on the command line.
fn read_top_folder(folder: &Path) -> Result<Vec<DirEntry>, FolderError> {
    let printable = printable_name(folder.as_os_str());
    read_entries(folder, MAX_ENTRIES).map_err(|reason| match reason {
        SkipReason::TooManyEntries => FolderError::TooManyEntries(printable),
        _ => FolderError::Unreadable(printable),
    })
}

/// Reads the entries of a folder, sorted by name. If there are more than `max_entries`, returns an
/// error instead of the first few entries, because their order in the file system is arbitrary.
fn read_entries(folder: &Path, max_entries: usize) -> Result<Vec<DirEntry>, SkipReason> {
    let mut entries = fs::read_dir(folder)
        .and_then(|entries| entries.take(max_entries + 1).collect::<io::Result<Vec<_>>>())
        .map_err(|_| SkipReason::Unreadable)?;
    if entries.len() > max_entries {
        return Err(SkipReason::TooManyEntries);
    }
    entries.sort_by_key(DirEntry::file_name);
    Ok(entries)
}

/// Formats a name for a table or a message. Escapes bytes that aren't UTF-8, and characters that a
/// terminal would interpret.
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
    fn names_that_are_not_utf8_stay_distinct() {
        use std::os::unix::ffi::OsStrExt;
        let names = [b"J\x94rg", b"J\x81rg"].map(|bytes| printable_name(OsStr::from_bytes(bytes)));
        assert_eq!(names, ["J\\x94rg", "J\\x81rg"]);
    }

    #[test]
    fn files_that_may_be_pictures_are_recognised_by_their_extension() {
        let file = |path: &str| FoundFile { path: path.into(), printable_path: path.to_owned() };
        for path in ["a.png", "b/c.JPEG", "d.old.svg"] {
            assert!(file(path).may_be_picture(), "{path}");
        }
        for path in ["png", "a.png.zip", "a", ".png"] {
            assert!(!file(path).may_be_picture(), "{path}");
        }
        assert_eq!(file("b/c.png").printable_name(), "c.png");
        assert_eq!(file("c.png").printable_name(), "c.png");
    }
}
