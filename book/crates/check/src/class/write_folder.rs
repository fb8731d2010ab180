//! Writes a new folder with all its files, or nothing at all.

use crate::class::folder::printable_name;
use std::path::Path;
use std::{fs, io, process};
use thiserror::Error;

/// Why no folder was written. The paths are escaped for a terminal.
#[derive(Debug, Error)]
pub enum WriteFolderError {
    /// The path doesn't end in a name. An example is `..`.
    #[error("{0} is not the name of a new folder")]
    NoName(String),
    /// Something already exists at this path.
    #[error("{0} exists already; choose a folder that doesn't")]
    Exists(String),
    /// The system couldn't write the folder.
    #[error("{folder} can't be written, so no files were written: {source}")]
    Io {
        /// The path of the folder.
        folder: String,
        /// The system's error.
        source: io::Error,
    },
}

/// The name and the text of a file to write.
pub(crate) struct NewFile {
    pub name: String,
    pub text: String,
}

/// Writes files to a new folder. The folder has a temporary name until all of the files are in it,
/// so nobody finds it half-written. Returns lines that list the files.
pub(crate) fn write_new_folder(
    folder: &Path,
    files: &[NewFile],
) -> Result<String, WriteFolderError> {
    let printable = printable_name(folder.as_os_str());
    let Some(name) = folder.file_name() else {
        return Err(WriteFolderError::NoName(printable));
    };
    if fs::symlink_metadata(folder).is_ok() {
        return Err(WriteFolderError::Exists(printable));
    }
    let mut unfinished_name = name.to_owned();
    unfinished_name.push(format!(".{}.part", process::id()));
    let unfinished = folder.with_file_name(unfinished_name);
    let result = write_files(&unfinished, files).and_then(|()| fs::rename(&unfinished, folder));
    if let Err(source) = result {
        let _ = fs::remove_dir_all(&unfinished);
        return Err(WriteFolderError::Io { folder: printable, source });
    }
    let lines: String = files.iter().flat_map(|file| ["\n", &file.name]).collect();
    Ok(format!("Written to {printable}:{lines}"))
}

fn write_files(folder: &Path, files: &[NewFile]) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    files.iter().try_for_each(|file| fs::write(folder.join(&file.name), &file.text))
}
