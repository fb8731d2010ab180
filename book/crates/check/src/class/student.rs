//! Compares one student's pictures with the pictures of the course.

use crate::class::feedback::{Feedback, judge};
use crate::class::folder::{FolderContents, FoundFile};
use crate::class::skipped_paths::{SkipReason, SkippedPaths};
use crate::target::find_name_in_file_name;
use crate::{Answer, CheckError, check_png, escape_for_terminal, read_bounded_file};
use course::{names_of_right_pictures, read_locked_picture};

/// The maximum number of files that are checked for one picture.
const MAX_FILES_OF_PICTURE: usize = 8;

/// The report on a student's folder.
#[derive(Debug)]
pub(crate) struct StudentReport {
    /// The name of the folder, escaped for a terminal.
    pub name: String,
    pub pictures: Vec<PictureReport>,
    pub notes: Vec<Note>,
    pub skipped_paths: SkippedPaths,
}

/// The report on one of a student's pictures.
#[derive(Debug)]
pub(crate) struct PictureReport {
    /// The name of the picture.
    pub picture: &'static str,
    /// Whether the picture counts towards the points. If the teacher has listed required pictures,
    /// only these count. Otherwise, all pictures count.
    pub is_counted: bool,
    /// The checked files that are named after this picture. If this list is empty, the picture is
    /// missing.
    pub files: Vec<FileReport>,
    /// The number of files named after this picture, including those that weren't checked.
    pub file_count: usize,
}

/// The report on one file.
#[derive(Debug)]
pub(crate) struct FileReport {
    pub printable_path: String,
    pub result: Result<Answer, CheckError>,
    pub feedback: Feedback,
}

/// A fact about a student's folder that the teacher should know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Note {
    NothingHandedIn,
    NoFolder,
    NotInList,
    SameNameInOtherForm,
    SeveralFiles { picture: &'static str, count: usize },
}

impl Note {
    /// The note as a clause.
    pub fn clause(self) -> String {
        match self {
            Self::NothingHandedIn => "nothing was handed in".to_owned(),
            Self::NoFolder => "no folder has this name".to_owned(),
            Self::NotInList => "this name isn't in the list".to_owned(),
            Self::SameNameInOtherForm => {
                "a second folder has this name, in a different Unicode form".to_owned()
            }
            Self::SeveralFiles { picture, count } => format!("{count} files are named {picture}"),
        }
    }
}

impl StudentReport {
    /// The report on a student who is in the list of names but has no folder.
    pub fn without_folder(name: &str, required: &[&'static str]) -> Self {
        let empty_report = |picture: &&'static str| PictureReport {
            picture,
            is_counted: true,
            files: vec![],
            file_count: 0,
        };
        Self {
            name: escape_for_terminal(name),
            pictures: required.iter().map(empty_report).collect(),
            notes: vec![Note::NoFolder],
            skipped_paths: SkippedPaths::default(),
        }
    }

    /// The points earned: the number of counted pictures that have earned their point.
    pub fn points(&self) -> usize {
        self.counted_pictures().filter(|picture| picture.earns_point()).count()
    }

    /// The maximum number of points: the number of counted pictures.
    pub fn max_points(&self) -> usize {
        self.counted_pictures().count()
    }

    pub fn counted_pictures(&self) -> impl Iterator<Item = &PictureReport> {
        self.pictures.iter().filter(|picture| picture.is_counted)
    }
}

impl PictureReport {
    /// Whether the picture has earned its point: there is at least one file of the picture, and
    /// every file earns the point. A file that wasn't checked doesn't earn the point.
    pub fn earns_point(&self) -> bool {
        let deserving = self.files.iter().filter(|file| file.feedback.earns_point());
        self.file_count > 0 && deserving.count() == self.file_count
    }
}

/// Checks those files in a student's folder that are named after a picture of the course.
pub(crate) fn check_student(
    name: String,
    contents: FolderContents,
    required: &[&'static str],
) -> StudentReport {
    let FolderContents { files, mut skipped_paths } = contents;
    let is_empty = files.is_empty() && skipped_paths.is_empty();
    let files_and_pictures: Vec<_> =
        files.iter().map(|file| (file, picture_of_file(file))).collect();
    for (file, _) in files_and_pictures.iter().filter(|(_, picture)| picture.is_none()) {
        skipped_paths.add(file.printable_path.clone(), SkipReason::OtherName);
    }
    let mut pictures: Vec<PictureReport> = vec![];
    let mut notes = vec![];
    for picture in names_of_right_pictures() {
        let files: Vec<_> = files_and_pictures
            .iter()
            .filter(|(_, name)| *name == Some(picture))
            .map(|(file, _)| *file)
            .collect();
        let is_required = required.contains(&picture);
        if files.is_empty() && !is_required {
            continue;
        }
        let (checked_files, skipped_files) = files.split_at(files.len().min(MAX_FILES_OF_PICTURE));
        let reports =
            checked_files.iter().map(|file| check_file(file, picture, &pictures)).collect();
        for file in skipped_files {
            let path = file.printable_path.clone();
            skipped_paths.add(path, SkipReason::TooManyFilesOfPicture);
        }
        if files.len() > 1 {
            notes.push(Note::SeveralFiles { picture, count: files.len() });
        }
        let is_counted = is_required || required.is_empty();
        let file_count = files.len();
        pictures.push(PictureReport { picture, is_counted, files: reports, file_count });
    }
    if is_empty {
        notes.push(Note::NothingHandedIn);
    }
    StudentReport { name, pictures, notes, skipped_paths }
}

/// Returns the name of the picture that a file is named after. Returns None if there is no such
/// picture, or if the file's extension isn't that of a picture.
fn picture_of_file(file: &FoundFile) -> Option<&'static str> {
    let name = file.printable_name();
    find_name_in_file_name(name, names_of_right_pictures().into_iter())
        .filter(|_| file.may_be_picture())
}

/// Compares a file with the locked picture that the file should contain.
fn check_file(file: &FoundFile, picture: &'static str, earlier: &[PictureReport]) -> FileReport {
    let result = read_bounded_file(&file.path)
        .map_err(CheckError::from)
        .and_then(|png| check_png(&png, file.printable_name(), Some(picture), read_locked_picture))
        // Drop the pictures, because the pictures of a whole class would take too much memory.
        .map(|answer| Answer { compared_pictures: None, ..answer });
    let feedback = judge(&result, earlier);
    FileReport { printable_path: file.printable_path.clone(), result, feedback }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Verdict;
    use crate::class::feedback::FileVerdict;

    fn file(verdict: FileVerdict) -> FileReport {
        let feedback = Feedback { verdict, sentence: String::new(), causes: vec![] };
        let printable_path = "step01_rays.png".to_owned();
        FileReport { printable_path, result: Err(CheckError::UnknownName), feedback }
    }

    fn earns_point(verdicts: &[FileVerdict], file_count: usize) -> bool {
        let files = verdicts.iter().copied().map(file).collect();
        PictureReport { picture: "step01_rays", is_counted: true, files, file_count }.earns_point()
    }

    #[test]
    fn picture_earns_its_point_if_each_of_its_files_does() {
        let [right, options, wrong] =
            [Verdict::Right, Verdict::OtherOptions, Verdict::NotRight].map(FileVerdict::Compared);
        assert!(earns_point(&[right, options], 2));
        assert!(!earns_point(&[right, wrong], 2));
        assert!(!earns_point(&[FileVerdict::Unreadable], 1));
        assert!(!earns_point(&[], 0));
        // One file wasn't checked.
        assert!(!earns_point(&[right], 2));
    }
}
