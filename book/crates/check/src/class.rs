//! What a folder has of the course's pictures: one's own, or those of a class, as a learning
//! platform gives them.

mod check_student;
mod found_file;
mod report_text;
mod search;
mod student;
mod trial;

pub use trial::report_on_workspaces;

use crate::class::check_student::{check_students, tell_common_causes};
use crate::class::found_file::FoundFile;
use crate::class::report_text::{format_class, format_csv, format_json, format_table};
use crate::class::search::find_files;
use crate::class::student::{Student, add_names, group_by_student};
use crate::{Answer, Verdict};
use std::path::Path;

/// The most folders, one in the other, around a file of a class.
const MOST_FOLDERS: usize = 8;

/// The form of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// For people.
    Table,
    /// For a spreadsheet: a row for each student and picture.
    Csv,
    /// For machines.
    Json,
}

/// A student's pictures.
struct Report {
    student: String,
    /// Pictures that were asked for or are there, or all of the course, in its order.
    pictures: Vec<Entry>,
    /// Files that may have been meant as pictures, and weren't looked at.
    unchecked: Vec<String>,
    /// Files that are something else.
    other_files: Vec<String>,
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

impl Report {
    /// How many pictures are right, and how many there are, of those that are required or of the
    /// others.
    fn count_right(&self, are_required: bool) -> (usize, usize) {
        let entries = self.pictures.iter().filter(|entry| entry.is_required == are_required);
        let right = entries.clone().filter(|entry| entry.answer.verdict == Verdict::Right);
        (right.count(), entries.count())
    }
}

/// Says of each picture in a folder or an archive whether it is right. It is one's own if it has
/// pictures of the course or a workspace of Cargo, else that of a class, some names of which may
/// be known.
///
/// The verdict is right if all pictures are that were required, or else all that are there.
pub fn report_on_folder(
    folder: &Path,
    names: &[String],
    required: &[&'static str],
    format: Format,
) -> Answer {
    let is_workspace = folder.join("Cargo.toml").exists();
    let files = match find_files(folder, if is_workspace { 1 } else { MOST_FOLDERS }) {
        Ok(files) => files,
        Err(why) => return Answer::error(why),
    };
    let is_of_class = |file: &FoundFile| 1 < file.path.len() || file.is_of_canvas();
    let is_own = is_workspace
        || files.iter().any(|file| file.picture.is_some() && !is_of_class(file))
        || !files.iter().any(is_of_class);
    let (mut students, mut stray) = if is_own {
        let path = folder.canonicalize().unwrap_or_default();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let (files, deeper) = files.into_iter().partition(|file| file.path.len() == 1);
        (vec![Student { unique_name: name.clone(), name, files }], deeper)
    } else {
        group_by_student(files)
    };
    add_names(&mut students, names);
    let reports = check_students(&students, required, is_own);
    let is_near = |file: &FoundFile| file.picture.is_some() && file.path.len() == 2;
    stray.retain(|file| if is_own { is_near(file) } else { !file.is_no_picture() });
    report(reports, stray.iter().map(FoundFile::describe).collect(), format, is_own)
}

/// The answer made of reports on students, and of files that are nobody's.
fn report(mut reports: Vec<Report>, stray: Vec<String>, format: Format, is_own: bool) -> Answer {
    reports.iter_mut().for_each(tell_common_causes);
    let text = match format {
        Format::Json => format_json(&reports, &stray),
        Format::Csv => format_csv(&reports),
        Format::Table if is_own => format_table(&reports[0], &stray),
        Format::Table => format_class(&reports, &stray),
    };
    Answer::new(whole_verdict(&reports), text)
}

/// The verdict on all pictures that count.
fn whole_verdict(reports: &[Report]) -> Verdict {
    let entries = || reports.iter().flat_map(|report| &report.pictures);
    let has_required = entries().any(|entry| entry.is_required);
    let is_there = |entry: &&Entry| entry.answer.verdict != Verdict::Missing;
    let mut counted =
        entries().filter(|entry| entry.is_required || !has_required && is_there(entry));
    match counted.all(|entry| entry.answer.verdict == Verdict::Right) {
        _ if !entries().any(|entry| is_there(&entry)) => Verdict::Missing,
        true => Verdict::Right,
        false => Verdict::NotRight,
    }
}
