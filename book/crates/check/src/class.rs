//! What a folder has of the course's pictures: one's own, or those of a class, as a learning
//! platform gives them.

mod check_student;
mod found_file;
mod report_text;
mod search;
mod student;
mod trial;

pub use trial::report_on_workspaces;

use crate::class::check_student::{check_student, tell_common_causes};
use crate::class::found_file::FoundFile;
use crate::class::report_text::{format_class, format_csv, format_json, format_own};
use crate::class::search::find_files;
use crate::class::student::{Student, add_names, group_by_student, split_canvas_name};
use crate::{Answer, LockedPictures, Verdict};
use course::NAMED_SCENE_EXAMPLE;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::path::Path;

/// The most folders, one in the other, around a file of a class, and around one's own.
const MOST_FOLDERS: usize = 8;
const MOST_OWN_FOLDERS: usize = 1;

struct Report {
    student: String,
    /// Pictures that were asked for or are there, in the course's order.
    pictures: Vec<Entry>,
    /// Files that weren't looked at, and why those can't be read that can't.
    unchecked: Vec<String>,
}

/// A picture of the course, and what a student has of it.
struct Entry {
    name: &'static str,
    is_required: bool,
    /// The path of the file that was looked at.
    file: Option<String>,
    answer: Answer,
    /// The earlier picture that is wrong by the same cause, and this cause.
    follows: Option<(&'static str, String)>,
}

impl Entry {
    /// What a student has of a picture. The pictures that an answer compares aren't kept.
    fn new(name: &'static str, is_required: bool, file: Option<String>, answer: Answer) -> Self {
        let answer = Answer { compared: None, ..answer };
        Self { name, is_required, file, answer, follows: None }
    }

    fn is_right(&self) -> bool {
        self.answer.verdict == Verdict::Right
    }

    fn is_missing(&self) -> bool {
        self.answer.verdict == Verdict::Missing
    }
}

impl Report {
    fn required_count(&self) -> usize {
        self.pictures.iter().filter(|entry| entry.is_required).count()
    }

    /// The pictures that count: those that were asked for, or all if none were.
    fn counted(&self) -> impl Iterator<Item = &Entry> {
        let counts_all = self.required_count() == 0;
        self.pictures.iter().filter(move |entry| entry.is_required || counts_all)
    }

    fn right_count(&self) -> usize {
        self.counted().filter(|entry| entry.is_right()).count()
    }
}

/// Says of each picture in a folder or an archive whether it is right. It is one's own if it has
/// pictures of the course or a workspace of Cargo, else that of a class, some names of which may
/// be known. The text is a table, or, for a spreadsheet, a row for each student and picture.
///
/// The verdict is right if all pictures are that were required, or else all that are there.
pub fn report_on_folder(
    folder: &Path,
    names: &[String],
    required: &[&'static str],
    is_csv: bool,
) -> Answer {
    let is_workspace = folder.join("Cargo.toml").exists();
    let most_folders = if is_workspace { MOST_OWN_FOLDERS } else { MOST_FOLDERS };
    let mut files = match find_files(folder, most_folders) {
        Ok(files) => files,
        Err(why) => return Answer::error(why),
    };
    let is_of_class =
        |file: &FoundFile| 0 < file.depth() || split_canvas_name(&file.path).is_some();
    let is_own = is_workspace
        || files.iter().any(|file| file.picture.is_some() && !is_of_class(file))
        || !files.iter().any(is_of_class);
    let (mut students, stray) = if is_own {
        files.retain(|file| file.depth() <= MOST_OWN_FOLDERS && file.may_be_picture());
        // Whose scene it is isn't known, but where that is asked for.
        let is_known = |name: &&str| *name != NAMED_SCENE_EXAMPLE || required.contains(name);
        files.iter_mut().for_each(|file| file.picture = file.picture.filter(is_known));
        let path = folder.canonicalize().unwrap_or_default();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        (vec![Student::new(&name, files)], vec![])
    } else {
        group_by_student(files)
    };
    add_names(&mut students, names);
    let names: Vec<_> = students.iter().map(|student| student.name.clone()).collect();
    let locked = LockedPictures::in_workspace();
    let check = |student| check_student(student, required, &names, &locked);
    let reports = students.par_iter().map(check).collect();
    let stray = stray.iter().filter(|file| file.may_be_picture()).map(FoundFile::describe);
    report(reports, stray.collect(), is_csv, is_own)
}

/// The answer made of reports on students, and of files that are nobody's.
fn report(mut reports: Vec<Report>, stray: Vec<String>, is_csv: bool, is_own: bool) -> Answer {
    reports.iter_mut().for_each(tell_common_causes);
    let text = match (is_csv, is_own) {
        (true, _) => format_csv(&reports),
        (_, true) => format_own(&reports[0]),
        _ => format_class(&reports, &stray),
    };
    let pictures = || reports.iter().flat_map(|report| &report.pictures);
    let verdict = match reports.iter().flat_map(Report::counted).all(Entry::is_right) {
        _ if pictures().all(Entry::is_missing) => Verdict::Missing,
        true => Verdict::Right,
        false => Verdict::NotRight,
    };
    let json = format_json(&reports, &stray);
    Answer { report: Some(json), ..Answer::new(verdict, text) }
}
