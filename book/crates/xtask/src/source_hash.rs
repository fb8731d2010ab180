//! Hashes source code, to find out whether the WebAssembly modules and the pictures of the mistakes
//! are up to date. Blank lines, indentation and lines that contain only a comment don't affect the
//! hash, except in the files of [`SHOWN_ON_PAGES`].

use crate::error::{XtaskError, XtaskResult};
use course::{fnv_1a, workspace};
use std::fs;
use std::path::{Path, PathBuf};

/// The folders that contain the sources of the WebAssembly modules.
const FOLDERS: [&str; 5] =
    ["steps", "book/crates/check", "book/crates/course", "book/crates/figures", "book/crates/page"];

/// Names of files and folders in [`FOLDERS`] that aren't hashed:
/// - the file that contains the hash;
/// - the folder with the lists of mistakes, which a page loads separately;
/// - the folders with tests and with benchmarks.
const SKIPPED_PATH_ENDS: [&str; 4] = ["modules.txt", "course/mistakes", "tests", "benches"];

/// Source files with text that a page shows for readers to copy. The whole text of these files is
/// hashed, including comments and indentation.
const SHOWN_ON_PAGES: [&str; 3] =
    ["examples/own_scene.rs", "examples/look_at.rs", "figures/src/own_scene/program.rs"];

/// Hashes all sources of the WebAssembly modules, including manifests.
pub fn hash_wasm_module_sources() -> XtaskResult<String> {
    let mut files = ["Cargo.toml", "Cargo.lock"].map(|file| workspace().join(file)).to_vec();
    for folder in FOLDERS {
        push_source_files(&workspace().join(folder), &mut files)?;
    }
    files.sort();
    let source_text = |path: &PathBuf| {
        let text = fs::read_to_string(path).map_err(XtaskError::of_file(path))?;
        let is_shown = SHOWN_ON_PAGES.iter().any(|end| path.ends_with(end));
        Ok(if is_shown { text } else { trimmed_code_lines(&text) })
    };
    let texts: XtaskResult<Vec<_>> = files.iter().map(source_text).collect();
    Ok(format!("{:016x}", hash_texts(texts?)))
}

/// Hashes several texts into a single number. The number also depends on where each text ends.
pub fn hash_texts(texts: impl IntoIterator<Item = String>) -> u64 {
    fnv_1a(texts.into_iter().flat_map(|text| text.into_bytes().into_iter().chain([0])))
}

/// Removes blank lines, indentation, and lines that start with `//`. Comments that follow code on a
/// line stay, and so do the `#` comments in TOML files.
pub fn trimmed_code_lines(code: &str) -> String {
    let lines = code.lines().map(str::trim);
    let lines = lines.filter(|line| !line.is_empty() && !line.starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// Appends to `files` the source files in a folder and in its subfolders.
fn push_source_files(folder: &Path, files: &mut Vec<PathBuf>) -> XtaskResult<()> {
    for entry in fs::read_dir(folder).map_err(XtaskError::of_file(folder))? {
        let path = entry.map_err(XtaskError::of_file(folder))?.path();
        let end = path.extension().and_then(|end| end.to_str()).unwrap_or_default();
        if SKIPPED_PATH_ENDS.iter().any(|end| path.ends_with(end)) {
            continue;
        }
        if path.is_dir() {
            push_source_files(&path, files)?;
        } else if ["rs", "toml", "txt"].contains(&end) {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_blank_lines_and_indentation_are_not_code() {
        let code = "//! A file.\n\nfn f() {\n    // Why.\n    g(); // here\n}\n";
        assert_eq!(trimmed_code_lines(code), "fn f() {\ng(); // here\n}");
    }

    #[test]
    fn code_and_places_are_source_files_but_lists_of_mistakes_are_not() {
        let mut files = vec![];
        push_source_files(&workspace().join("book/crates/course"), &mut files)
            .expect("the files can be read");
        let is_source = |end: &str| files.iter().any(|path| path.ends_with(end));
        for name in ["mistake.rs", "places.txt", "Cargo.toml"] {
            assert!(is_source(name), "{name}");
        }
        assert!(!is_source("step01_rays.txt") && !is_source("table.txt"));
    }

    #[test]
    fn hash_depends_on_where_a_text_ends() {
        let hash = |texts: &[&str]| hash_texts(texts.iter().map(|&text| text.to_owned()));
        assert_ne!(hash(&["ab", "c"]), hash(&["a", "bc"]));
        assert_ne!(hash(&["a"]), hash(&["a", ""]));
        assert_eq!(hash(&["a", "b"]), hash(&["a", "b"]));
    }
}
