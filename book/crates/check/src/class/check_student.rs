use crate::class::found_file::{FoundFile, has_extension, picture_names};
use crate::class::student::Student;
use crate::class::{Entry, Report};
use crate::{Answer, LockedPictures, Verdict, check_png, check_scene_png};
use course::NAMED_SCENE_EXAMPLE;
use std::cmp::Reverse;

/// Looks at the pictures of a student; `names` are those of all.
pub(crate) fn check_student(
    student: &Student,
    required: &[&'static str],
    names: &[String],
    locked: &LockedPictures,
) -> Report {
    let mut files: Vec<_> = student.files.iter().collect();
    let mut pictures = vec![];
    for name in picture_names() {
        let is_required = required.contains(&name);
        // One that ends as PNG files do, the one that lies highest, that has just this name, the
        // last that was handed in.
        let of_name = files.iter().copied().filter(|file| file.picture == Some(name));
        let file = of_name.min_by_key(|file| {
            let is_exact = file.name() == format!("{name}.png");
            let is_png = has_extension(file.name(), &["png"]);
            (!is_png, file.depth(), !is_exact, Reverse(file.version()))
        });
        files.retain(|other| file.is_none_or(|file| !std::ptr::eq(*other, file)));
        let answer = match file.map(|file| (file.name(), file.read())) {
            None if is_required => Answer::new(Verdict::Missing, ""),
            None => continue,
            Some((_, Err(why))) => Answer::error(why),
            Some((file_name, Ok(png))) if name == NAMED_SCENE_EXAMPLE => {
                check_scene_png(&png, file_name, &student.name, names, locked)
            }
            Some((file_name, Ok(png))) => check_png(&png, file_name, Some(name), locked),
        };
        let file = file.map(|file| file.path.clone());
        pictures.push(Entry::new(name, is_required, file, answer));
    }
    files.retain(|file| file.is_unreadable() || !file.name().is_empty());
    // What can't be read comes first, as a line tells only some names.
    files.sort_by_key(|file| !file.is_unreadable());
    let unchecked = files.into_iter().map(FoundFile::describe).collect();
    Report { student: student.unique_name.clone(), pictures, unchecked }
}

/// Tells of each wrong picture which earlier one is wrong by the same cause, the only one that
/// we know for one of the two.
pub(crate) fn tell_common_causes(report: &mut Report) {
    for k in 1..report.pictures.len() {
        let (earlier, later) = report.pictures.split_at_mut(k);
        let causes = &later[0].answer.causes;
        later[0].follows = earlier.iter().find_map(|one| {
            let cause = one.answer.causes.iter().find(|cause| causes.contains(cause))?;
            let is_sure = one.answer.causes.len() == 1 || causes.len() == 1;
            is_sure.then(|| (one.name, cause.words_and_file()))
        });
    }
}
