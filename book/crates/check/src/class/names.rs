//! Reads the list of a class's names, and compares it with the names of the students' folders.

use crate::class::folder::{MAX_ENTRIES, StudentFolder, printable_name};
use crate::class::student::Note;
use crate::{ReadFileError, read_bounded_file};
use std::collections::{HashMap, HashSet};
use std::path::Path;
use thiserror::Error;
use unicode_normalization::UnicodeNormalization;

/// Why a list of names can't be used. The paths are escaped for a terminal.
#[derive(Debug, Error)]
pub enum NamesError {
    /// The file can't be read.
    #[error(transparent)]
    Read(#[from] ReadFileError),
    /// The file isn't encoded in UTF-8.
    #[error("{0} is not in UTF-8")]
    NotUtf8(String),
    /// The file has nothing but blank lines.
    #[error("{0} contains no names; write one on each line")]
    Empty(String),
    /// The file has more names than a class may have folders.
    #[error("{0} has more than {MAX_ENTRIES} names")]
    TooMany(String),
}

/// Reads a list of names, one per line.
pub fn read_names(list: &Path) -> Result<Vec<String>, NamesError> {
    let printable = printable_name(list.as_os_str());
    let Ok(text) = String::from_utf8(read_bounded_file(list)?) else {
        return Err(NamesError::NotUtf8(printable));
    };
    let names: Vec<_> = text
        .trim_start_matches('\u{feff}')
        .lines()
        .map(str::trim)
        .filter(|name| !name.is_empty())
        .map(compose_characters)
        .collect();
    match names.len() {
        0 => Err(NamesError::Empty(printable)),
        1..=MAX_ENTRIES => Ok(names),
        _ => Err(NamesError::TooMany(printable)),
    }
}

/// Converts a name to NFC, in which "ü" is one character. In a file name from macOS, "ü" may be two
/// characters: "u" and a diaeresis.
pub fn compose_characters(name: &str) -> String {
    name.nfc().collect()
}

/// Returns the name of a student's folder with composed characters, or None if the name isn't
/// UTF-8.
fn composed_folder_name(student: &StudentFolder) -> Option<String> {
    student.name.to_str().map(compose_characters)
}

/// Names that several folders have, in different Unicode forms.
pub(crate) struct DuplicateNames(HashSet<String>);

impl DuplicateNames {
    pub fn new(students: &[StudentFolder]) -> Self {
        let mut earlier_names = HashSet::new();
        let names = students.iter().filter_map(composed_folder_name);
        Self(names.filter(|name| !earlier_names.insert(name.clone())).collect())
    }

    /// Returns a note if another folder has the same name, in a different Unicode form.
    pub fn note(&self, student: &StudentFolder) -> Option<Note> {
        let name = composed_folder_name(student)?;
        self.0.contains(&name).then_some(Note::SameNameInOtherForm)
    }
}

/// A list of names, and whether each name has a folder.
pub(crate) struct ListedNames<'a> {
    names: &'a [String],
    has_folder: HashMap<&'a str, bool>,
}

impl<'a> ListedNames<'a> {
    pub fn new(names: &'a [String], students: &[StudentFolder]) -> Self {
        let mut has_folder: HashMap<_, _> = names.iter().map(|name| (&**name, false)).collect();
        for name in students.iter().filter_map(composed_folder_name) {
            if let Some(has_folder) = has_folder.get_mut(&*name) {
                *has_folder = true;
            }
        }
        Self { names, has_folder }
    }

    /// Returns a note if this folder's name isn't in the list.
    pub fn note(&self, student: &StudentFolder) -> Option<Note> {
        let name = composed_folder_name(student);
        let is_listed = name.is_some_and(|name| self.has_folder.contains_key(&*name));
        (!is_listed).then_some(Note::NotInList)
    }

    /// The names without a folder, in the order of the list.
    pub fn names_that_have_no_folder(&self) -> impl Iterator<Item = &'a str> {
        self.names.iter().map(String::as_str).filter(|name| !self.has_folder[name])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn student(name: &str) -> StudentFolder {
        StudentFolder { name: name.into(), path: name.into() }
    }

    #[test]
    fn names_in_different_unicode_forms_are_equal() {
        assert_eq!(compose_characters("Do\u{308}ra"), "D\u{f6}ra");
        let students = [student("Do\u{308}ra"), student("D\u{f6}ra"), student("Bob")];
        let duplicates = DuplicateNames::new(&students);
        let notes = students.each_ref().map(|student| duplicates.note(student));
        let note = Some(Note::SameNameInOtherForm);
        assert!(notes == [note, note, None]);
    }

    #[test]
    fn folder_not_in_the_list_and_name_without_a_folder_are_found() {
        let names = ["Ada", "D\u{f6}ra"].map(str::to_owned);
        let students = [student("Do\u{308}ra"), student("Bob")];
        let listed_names = ListedNames::new(&names, &students);
        assert!(
            students.each_ref().map(|student| listed_names.note(student))
                == [None, Some(Note::NotInList)]
        );
        assert_eq!(listed_names.names_that_have_no_folder().collect::<Vec<_>>(), ["Ada"]);
    }
}
