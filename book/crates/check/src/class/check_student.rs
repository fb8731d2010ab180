use crate::class::found_file::{has_extension, picture_names, unchecked_clause};
use crate::class::report::{Entry, Report};
use crate::class::student::Student;
use crate::{Answer, LockedPictures, Verdict, check_png, check_scene_png};
use course::NAMED_SCENE_EXAMPLE;
use std::cmp::Reverse;

/// Looks at the pictures of a student; `names` are those of all.
pub(crate) fn check_student(
    student: Student,
    required: &[&'static str],
    names: &[String],
    locked: &LockedPictures,
) -> Report {
    let mut files = student.files;
    // First those that end as PNG files do, that lie highest, that have just the name of a
    // picture, that were handed in last.
    files.sort_by_key(|file| {
        let is_exact = file.picture.is_some_and(|name| file.name() == format!("{name}.png"));
        let is_png = has_extension(file.name(), &["png"]);
        (!is_png, file.depth(), !is_exact, Reverse(file.version()))
    });
    let mut pictures = vec![];
    for name in picture_names() {
        let is_required = required.contains(&name);
        let position = files.iter().position(|file| file.picture == Some(name));
        let file = position.map(|k| files.remove(k));
        let answer = match file.as_ref().map(|file| (file.name(), file.read())) {
            None if is_required => Answer::new(Verdict::Missing, ""),
            None => continue,
            Some((_, Err(why))) => Answer::error(why),
            Some((file_name, Ok(png))) if name == NAMED_SCENE_EXAMPLE => {
                check_scene_png(&png, file_name, &student.name, names, locked)
            }
            Some((file_name, Ok(png))) => check_png(&png, file_name, Some(name), locked),
        };
        let path = file.map(|file| file.path).unwrap_or_default();
        pictures.push(Entry::new(name, is_required || required.is_empty(), path, answer));
    }
    files.retain(|file| file.is_unreadable() || !file.name().is_empty());
    let is_empty = pictures.iter().all(Entry::is_missing);
    let in_place =
        unchecked_clause(files).or_else(|| is_empty.then(|| "nothing was handed in".to_owned()));
    let mut report = Report { student: student.key, pictures, in_place };
    report.tell_common_causes();
    report
}
