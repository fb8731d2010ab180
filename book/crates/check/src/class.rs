//! What a folder has of the course's pictures: one's own, or those of a class, as a learning
//! platform gives them.

mod found_file;
mod report_text;
mod student;
mod trial;

pub use trial::report_on_workspaces;

use crate::class::found_file::{Content, FoundFile, find_files, has_extension};
use crate::class::report_text::{format_class, format_csv, format_json, format_table};
use crate::class::student::{Student, add_names, group_by_student, split_canvas_name};
use crate::{Answer, LockedPictures, Verdict, check_png, check_scene_png, escape_for_terminal};
use course::{NAMED_SCENE_EXAMPLE, locked_names};
use std::cmp::Reverse;
use std::io::ErrorKind;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, iter, thread};

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
    /// Those that were asked for or are there, in the order of the course.
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
    /// Where it was found.
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

/// Says of each picture in a folder whether it is right. The folder is one's own if it has
/// pictures of the course or a workspace of Cargo, else it is that of a class, some names of
/// which may be known.
///
/// The verdict is right if all pictures are that were required, or else all that are there.
pub fn report_on_folder(
    folder: &Path,
    names: &[String],
    required: &[&'static str],
    format: Format,
) -> Answer {
    if let Err(error) = fs::read_dir(folder) {
        let path = escape_for_terminal(&folder.display().to_string());
        return Answer::error(match error.kind() {
            ErrorKind::PermissionDenied => format!("{path} may not be read by you"),
            _ => format!("{path} is not a folder"),
        });
    }
    let is_workspace = folder.join("Cargo.toml").exists();
    let files = find_files(folder, if is_workspace { 1 } else { MOST_FOLDERS });
    let is_own = is_workspace || files.iter().any(FoundFile::is_of_own_folder);
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

impl FoundFile {
    /// Whether it lies beside the programs that draw it, and not, as Canvas has it, beside
    /// those of others.
    fn is_of_own_folder(&self) -> bool {
        let is_canvas_name = split_canvas_name(self.name()).is_some();
        self.path.len() == 1 && self.picture.is_some() && !is_canvas_name
    }

    /// The number at the end of the name of a file that was handed in again: `-2`, `(1)`.
    fn version(&self) -> u32 {
        let stem = self.name().rsplit_once('.').map_or("", |(stem, _)| stem);
        let number = stem.rsplit(['-', '(']).next().unwrap_or_default();
        number.trim_end_matches(')').parse().unwrap_or(0)
    }
}

/// Looks at the pictures of all students, on all processors.
fn check_students(students: &[Student], required: &[&'static str], is_own: bool) -> Vec<Report> {
    let names: Vec<_> = students.iter().map(|student| student.name.clone()).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let locked = LockedPictures::in_workspace();
        let numbers = iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
        let taken = numbers.map_while(|k| Some((k, students.get(k)?)));
        let check = |(k, student)| (k, check_student(student, required, is_own, &names, &locked));
        taken.map(check).collect::<Vec<_>>()
    };
    let count = thread::available_parallelism().map_or(1, usize::from).min(students.len());
    let mut reports: Vec<_> = thread::scope(|scope| {
        let workers: Vec<_> = (0..count).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap_or_default()).collect()
    });
    reports.sort_by_key(|(k, _)| *k);
    reports.into_iter().map(|(_, report)| report).collect()
}

/// Looks at the pictures of a student: of each the one that lies highest, and of these the last
/// that was handed in.
fn check_student(
    student: &Student,
    required: &[&'static str],
    is_own: bool,
    names: &[String],
    locked: &LockedPictures,
) -> Report {
    let mut rest: Vec<_> = student.files.iter().collect();
    let mut pictures = vec![];
    let lists_all = is_own && required.is_empty();
    let scene = Some(NAMED_SCENE_EXAMPLE).filter(|scene| !is_own || required.contains(scene));
    for name in locked_names().into_iter().chain(scene) {
        let is_required = required.contains(&name);
        let found = rest.iter().filter(|file| file.picture == Some(name));
        let found = found.min_by_key(|file| {
            (!has_extension(file.name(), &["png"]), file.path.len(), Reverse(file.version()))
        });
        let found = found.copied();
        rest.retain(|file| found.is_none_or(|found| !std::ptr::eq(*file, found)));
        let answer = match found.map(|file| (file.name(), file.read())) {
            None if is_required || lists_all => Answer::new(Verdict::Missing, ""),
            None => continue,
            Some((_, Err(why))) => Answer::error(why),
            Some((file, Ok(png))) if name == NAMED_SCENE_EXAMPLE => {
                check_scene_png(&png, file, &student.name, names, locked)
            }
            Some((file, Ok(png))) => check_png(&png, file, Some(name), locked),
        };
        let file = found.map(|file| file.path.join("/"));
        let answer = Answer { difference: None, ..answer };
        pictures.push(Entry { name, is_required, file, answer, follows: None });
    }
    // What can't be read comes first, as a line tells only some names.
    rest.sort_by_key(|file| !matches!(file.content, Content::Unreadable(_)));
    rest.retain(|file| !file.is_no_picture() || !is_own && !file.name().is_empty());
    let (other_files, unchecked) =
        rest.into_iter().partition::<Vec<_>, _>(|file| file.is_no_picture());
    let [other_files, unchecked] =
        [other_files, unchecked].map(|files| files.into_iter().map(FoundFile::describe).collect());
    Report { student: student.unique_name.clone(), pictures, unchecked, other_files }
}

/// Tells of each wrong picture which earlier one is wrong by the same cause.
fn tell_common_causes(report: &mut Report) {
    for k in 1..report.pictures.len() {
        let (earlier, later) = report.pictures.split_at_mut(k);
        let causes = &later[0].answer.cause.all;
        later[0].follows = earlier.iter().find_map(|one| {
            let cause = one.answer.cause.all.iter().find(|cause| causes.contains(cause))?;
            Some((one.name, cause.clone()))
        });
    }
}
