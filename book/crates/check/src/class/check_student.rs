use crate::class::found_file::{Content, FoundFile, has_extension};
use crate::class::student::Student;
use crate::class::{Entry, Report};
use crate::{Answer, LockedPictures, Verdict, check_png, check_scene_png};
use course::{NAMED_SCENE_EXAMPLE, locked_names};
use std::cmp::Reverse;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{iter, thread};

/// Looks at the pictures of all students, on all processors.
pub(crate) fn check_students(
    students: &[Student],
    required: &[&'static str],
    is_own: bool,
) -> Vec<Report> {
    let names: Vec<_> = students.iter().map(|student| student.name.clone()).collect();
    let next = AtomicUsize::new(0);
    let locked = LockedPictures::in_workspace();
    let work = || {
        let numbers = iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
        let numbered = numbers.map_while(|k| Some((k, students.get(k)?)));
        let check = |(k, student)| (k, check_student(student, required, is_own, &names, &locked));
        numbered.map(check).collect::<Vec<_>>()
    };
    let count = thread::available_parallelism().map_or(1, usize::from).min(students.len());
    let mut reports: Vec<_> = thread::scope(|scope| {
        let workers: Vec<_> = (0..count).map(|_| scope.spawn(work)).collect();
        workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap_or_else(|panic| resume_unwind(panic)))
            .collect()
    });
    reports.sort_by_key(|(k, _)| *k);
    reports.into_iter().map(|(_, report)| report).collect()
}

/// Looks at the pictures of a student.
fn check_student(
    student: &Student,
    required: &[&'static str],
    is_own: bool,
    names: &[String],
    locked: &LockedPictures,
) -> Report {
    let mut files: Vec<_> = student.files.iter().collect();
    let mut pictures = vec![];
    let lists_all = is_own && required.is_empty();
    let scene = Some(NAMED_SCENE_EXAMPLE).filter(|scene| !is_own || required.contains(scene));
    for name in locked_names().into_iter().chain(scene) {
        let is_required = required.contains(&name);
        let file = choose_file(&files, name);
        files.retain(|other| file.is_none_or(|file| !std::ptr::eq(*other, file)));
        let answer = match file.map(|file| (file.name(), file.read())) {
            None if is_required || lists_all => Answer::new(Verdict::Missing, ""),
            None => continue,
            Some((_, Err(why))) => Answer::error(why),
            Some((file_name, Ok(png))) if name == NAMED_SCENE_EXAMPLE => {
                check_scene_png(&png, file_name, &student.name, names, locked)
            }
            Some((file_name, Ok(png))) => check_png(&png, file_name, Some(name), locked),
        };
        let file = file.map(|file| file.path.join("/"));
        let answer = Answer { compared: None, ..answer };
        pictures.push(Entry { name, is_required, file, answer, follows: None });
    }
    // What can't be read comes first, as a line tells only some names.
    files.sort_by_key(|file| !matches!(file.content, Content::Unreadable(_)));
    files.retain(|file| !file.is_no_picture() || !is_own && !file.name().is_empty());
    let describe = |is_no_picture: bool| {
        let same = files.iter().filter(|file| file.is_no_picture() == is_no_picture);
        same.map(|file| file.describe()).collect()
    };
    let student = student.unique_name.clone();
    Report { student, pictures, unchecked: describe(false), other_files: describe(true) }
}

/// Of the files that may be a picture, one that ends as PNG files do, the one that lies highest,
/// and the last that was handed in.
fn choose_file<'a>(files: &[&'a FoundFile], name: &str) -> Option<&'a FoundFile> {
    let files = files.iter().filter(|file| file.picture == Some(name));
    let is_other = |file: &FoundFile| !has_extension(file.name(), &["png"]);
    let key = |file: &&&FoundFile| (is_other(file), file.path.len(), Reverse(file.version()));
    files.min_by_key(key).copied()
}

/// Tells of each wrong picture which earlier one is wrong by the same cause.
pub(crate) fn tell_common_causes(report: &mut Report) {
    for k in 1..report.pictures.len() {
        let (earlier, later) = report.pictures.split_at_mut(k);
        let causes = &later[0].answer.causes;
        later[0].follows = earlier.iter().find_map(|one| {
            let cause = one.answer.causes.iter().find(|cause| causes.contains(cause))?;
            Some((one.name, cause.words_and_file()))
        });
    }
}
