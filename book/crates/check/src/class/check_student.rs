use crate::class::found_file::{has_extension, picture_names, unchecked_clause};
use crate::class::report::{Row, count_right};
use crate::class::student::Student;
use crate::{Answer, Verdict, check_png, check_scene_png, read_locked_picture};
use course::NAMED_SCENE_EXAMPLE;
use std::cmp::Reverse;

/// The rows about the pictures of a student; `names` are those of all.
pub(crate) fn check_student(
    student: Student,
    required: &[&'static str],
    names: &[String],
) -> Vec<Row> {
    let mut files = student.files;
    // First those that end as PNG files do, that lie highest, that were handed in last, that have
    // just the name of a picture.
    files.sort_by_key(|file| {
        let is_exact = file.picture.is_some_and(|name| file.name() == format!("{name}.png"));
        let is_png = has_extension(file.name(), &["png"]);
        (!is_png, file.depth(), Reverse(file.version()), !is_exact)
    });
    let mut rows: Vec<Row> = vec![];
    for name in picture_names() {
        let is_required = required.contains(&name);
        let position = files.iter().position(|file| file.picture == Some(name));
        let file = position.map(|k| files.remove(k));
        let answer = match file.as_ref().map(|file| (file.name(), file.read())) {
            None if is_required => Answer::new(Verdict::Missing, ""),
            None => continue,
            Some((_, Err(why))) => Answer::error(why),
            Some((file_name, Ok(png))) if name == NAMED_SCENE_EXAMPLE => {
                check_scene_png(&png, file_name, &student.name, names)
            }
            Some((file_name, Ok(png))) => {
                check_png(&png, file_name, Some(name), read_locked_picture)
            }
        };
        let row = Row::new(&student.key, name, answer, &rows);
        let found = file.map(|file| file.path).unwrap_or_default();
        rows.push(Row { counts: is_required || required.is_empty(), found, ..row });
    }
    files.retain(|file| file.is_unreadable() || !file.name().is_empty());
    let is_empty = rows.iter().all(Row::is_missing);
    let in_place =
        unchecked_clause(files).or_else(|| is_empty.then(|| "nothing was handed in".to_owned()));
    rows.extend(in_place.map(|clause| Row::in_place(&student.key, clause)));
    count_right(rows)
}
