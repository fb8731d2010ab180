//! Checks what a class has handed in, given a folder that contains one folder per student. All
//! pictures in a student's folder and its subfolders belong to that student. The whole name of the
//! folder serves as the student's name. This module also writes the sheets for a class.

mod feedback;
mod folder;
mod names;
mod report;
mod scene_sheet;
mod skipped_paths;
mod student;
mod table;
mod write_folder;

pub use folder::FolderError;
pub use names::{NamesError, compose_characters, read_names};
pub use report::{ClassReport, OwnPicturesReport};
pub use scene_sheet::{SheetError, format_sheet, write_sheets};
pub use write_folder::WriteFolderError;

use crate::class::folder::{
    StudentFolder, find_files, find_own_pictures, printable_name, read_class_folder,
};
use crate::class::names::{DuplicateNames, ListedNames};
use crate::class::student::{StudentReport, check_student};
use rayon::prelude::*;
use std::path::Path;

/// Reports on every picture in the students' folders. `names` lists the names that the folders of
/// the class should have. With this list, the report says which folders are missing, and which
/// folders aren't in the list. Only the `required` pictures count towards a student's points. If no
/// pictures are required, all pictures count.
pub fn report_on_class(
    folder: &Path,
    names: Option<&[String]>,
    required: &[&'static str],
) -> Result<ClassReport, FolderError> {
    let class = read_class_folder(folder)?;
    let duplicates = DuplicateNames::new(&class.students);
    let listed_names = names.map(|names| ListedNames::new(names, &class.students));
    let check = |student: &StudentFolder| {
        let name = printable_name(&student.name);
        let mut report = check_student(name, find_files(student), required);
        report.notes.extend(duplicates.note(student));
        report.notes.extend(listed_names.as_ref().and_then(|names| names.note(student)));
        report
    };
    let mut students: Vec<_> = class.students.par_iter().map(check).collect();
    let names_that_have_no_folder =
        listed_names.iter().flat_map(ListedNames::names_that_have_no_folder);
    students.extend(
        names_that_have_no_folder.map(|name| StudentReport::without_folder(name, required)),
    );
    Ok(ClassReport { students, skipped_paths: class.skipped_paths })
}

/// Reports on a reader's own pictures in a folder. Ignores subfolders.
pub fn report_on_own_pictures(
    folder: &Path,
    required: &[&'static str],
) -> Result<OwnPicturesReport, FolderError> {
    let report = check_student(String::new(), find_own_pictures(folder)?, required);
    Ok(OwnPicturesReport { report })
}
