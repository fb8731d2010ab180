//! What a folder has of the course's pictures: one's own, or those of a class, as a learning
//! platform gives them; and the sheets that a class gets.

mod found_file;
mod report;
mod scene_sheet;
mod search;
mod student;

pub use scene_sheet::{format_sheet, read_names, write_sheets};
pub use student::normalize_name;

use crate::class::found_file::{FoundFile, has_extension, picture_names, unchecked_clause};
use crate::class::report::{Row, count_right, report_answer};
use crate::class::search::{MOST_FOLDERS, find_files};
use crate::class::student::{Student, add_names, group_by_student, split_key};
use crate::{Answer, Verdict, check_png, check_scene_png};
use course::{NAMED_SCENE_EXAMPLE, read_locked_picture};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::path::Path;

/// Says of each picture in a folder or an archive whether it is right. It is one's own if it is a
/// workspace of Cargo or has most pictures of the course itself, else that of a class, some names
/// of which may be known.
pub fn report_on_folder(
    folder: &Path,
    names: &[String],
    required: &[&'static str],
    is_csv: bool,
) -> Result<Answer, String> {
    let is_workspace = folder.join("Cargo.toml").exists();
    let mut files = find_files(folder, if is_workspace { 0 } else { MOST_FOLDERS })?;
    let is_stray = |file: &FoundFile| split_key(&file.path).is_none();
    let pictures = || files.iter().filter(|file| file.picture.is_some());
    let stray_count = pictures().filter(|file| is_stray(file)).count();
    let is_own = is_workspace || pictures().count() < 2 * stray_count || files.iter().all(is_stray);
    let (mut students, stray) = if is_own {
        files.retain(|file| file.depth() == 0 && file.may_be_picture());
        // Whose scene it is isn't known, but where that is asked for.
        let is_known = |name: &&str| *name != NAMED_SCENE_EXAMPLE || required.contains(name);
        files.iter_mut().for_each(|file| file.picture = file.picture.filter(is_known));
        let path = folder.canonicalize().unwrap_or_default();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        (vec![Student { name: name.clone(), key: name, files }], vec![])
    } else {
        group_by_student(files)
    };
    add_names(&mut students, names);
    let names: Vec<_> = students.iter().map(|student| student.name.clone()).collect();
    let check = |student| check_student(student, required, &names);
    let mut rows: Vec<_> = students.into_par_iter().flat_map(check).collect();
    rows.extend(unchecked_clause(stray).map(|clause| Row::in_place("(nobody's)", clause)));
    Ok(report_answer(&rows, is_csv))
}

/// The rows about the pictures of a student; `names` are those of all.
fn check_student(student: Student, required: &[&'static str], names: &[String]) -> Vec<Row> {
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
