//! Files that are written all or not at all, into a folder that doesn't exist yet.

use crate::class::folder::printable_name;
use std::path::Path;
use std::{fs, io, process};

/// A file to write, and its text.
pub(crate) struct NewFile {
    pub name: String,
    pub text: String,
}

/// Writes files into a folder beside the one that is meant, and renames it when all are there.
/// Returns lines that name them.
pub(crate) fn write_new_folder(folder: &Path, files: &[NewFile]) -> Result<String, String> {
    let printable = printable_name(folder.as_os_str());
    let Some(name) = folder.file_name() else {
        return Err(format!("{printable} is no name of a new folder"));
    };
    if fs::symlink_metadata(folder).is_ok() {
        return Err(format!("{printable} exists already; choose a folder that doesn't"));
    }
    let mut unfinished_name = name.to_owned();
    unfinished_name.push(format!(".{}.part", process::id()));
    let unfinished = folder.with_file_name(unfinished_name);
    let result = write_files(&unfinished, files).and_then(|()| fs::rename(&unfinished, folder));
    if let Err(error) = result {
        let _ = fs::remove_dir_all(&unfinished);
        return Err(format!("{printable} can't be written, and no file was: {error}"));
    }
    let lines: String = files.iter().flat_map(|file| ["\n", &file.name]).collect();
    Ok(format!("Written into {printable}:{lines}"))
}

fn write_files(folder: &Path, files: &[NewFile]) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    files.iter().try_for_each(|file| fs::write(folder.join(&file.name), &file.text))
}
