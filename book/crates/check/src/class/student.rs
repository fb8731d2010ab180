use crate::class::found_file::{FoundFile, picture_in_name};
use std::collections::{BTreeMap, BTreeSet};
use unicode_normalization::UnicodeNormalization;

/// A student, and the files that were handed in.
pub(crate) struct Student {
    /// The name to which the student's scene belongs.
    pub name: String,
    /// What the platform calls the student, which tells two of one name apart.
    pub key: String,
    /// Their paths begin below what belongs to the student.
    pub files: Vec<FoundFile>,
}

/// The students of a class, by their names, and the files that are nobody's. A student's are in
/// a folder or an archive, as Moodle and GitHub have it, or beside those of others with the
/// student in their names, as Canvas has it, and Moodle, too, if it is asked for no folders.
pub(crate) fn group_by_student(mut files: Vec<FoundFile>) -> (Vec<Student>, Vec<FoundFile>) {
    while is_one_folder_too_deep(&files) {
        for file in &mut files {
            file.path = file.path.split_once('/').map_or("", |(_, rest)| rest).to_owned();
        }
    }
    let mut groups: BTreeMap<String, BTreeMap<String, Vec<FoundFile>>> = BTreeMap::new();
    let mut stray = vec![];
    for mut file in files {
        let Some(((name, id), path)) = split_key(&file.path) else {
            stray.push(file);
            continue;
        };
        // The student may be called as a picture is.
        file.picture = picture_in_name(&path);
        file.path = path;
        groups.entry(name).or_default().entry(id).or_default().push(file);
    }
    let names: Vec<_> = groups.keys().cloned().collect();
    let prefix = common_prefix(&names);
    let students = groups.into_iter().flat_map(|(name, ids)| {
        let name = normalize_name(&name[prefix..]);
        let is_shared = 1 < ids.len();
        ids.into_iter().map(move |(id, files)| {
            let key = if is_shared { format!("{name}_{id}") } else { name.clone() };
            Student { name: without_number(&name).to_owned(), key, files }
        })
    });
    (students.collect(), stray)
}

/// A name with each letter as one character: a Mac writes "ü" as two in the names of files. In a
/// browser, the page does that.
pub fn normalize_name(name: &str) -> String {
    name.nfc().collect()
}

/// Gives students the names in a list that have the same letters in any order, as Canvas joins
/// them; adds those of the list who have handed in nothing.
pub(crate) fn add_names(students: &mut Vec<Student>, names: &[String]) {
    let letters = |name: &str| {
        let letters = name.chars().flat_map(char::to_lowercase).filter(|c| c.is_alphanumeric());
        let mut letters: Vec<_> = letters.collect();
        letters.sort_unstable();
        letters
    };
    for name in names {
        let sorted = letters(name);
        let same = students.iter_mut().filter(|student| letters(&student.name) == sorted);
        let count = same.map(|student| student.name.clone_from(name)).count();
        if count == 0 {
            students.push(Student { name: name.clone(), key: name.clone(), files: vec![] });
        }
    }
}

/// Whether all files are in one folder, and there are those of several students.
fn is_one_folder_too_deep(files: &[FoundFile]) -> bool {
    let split = files.iter().map(|file| file.path.split_once('/'));
    let Some(split) = split.collect::<Option<Vec<_>>>() else { return false };
    let keys = split.iter().map(|(_, rest)| Some(split_key(rest)?.0));
    let keys = keys.collect::<Option<BTreeSet<_>>>();
    split.iter().all(|(folder, _)| *folder == split[0].0) && keys.is_some_and(|one| 1 < one.len())
}

/// Splits a path into what tells the student, a name and Canvas's user id, and the rest; None
/// where nothing does.
pub(crate) fn split_key(path: &str) -> Option<((String, String), String)> {
    if let Some(split) = split_canvas_name(path) {
        return Some(split);
    }
    // Moodle makes a folder each for files and for what was typed, or puts all files into one.
    let (folder, rest) = path.split_once('/').or_else(|| {
        let (student, rest) = path.split_once("_assignsubmission_")?;
        Some((student, rest.split_once('_')?.1))
    })?;
    let student = folder.split_once("_assignsubmission_").map(|(student, _)| student);
    let student = student.or(folder.strip_suffix(".zip")).unwrap_or(folder);
    Some(((student.to_owned(), String::new()), rest.to_owned()))
}

/// Parts such as `lovelaceada`, `4711` and `my.png` of `lovelaceada_LATE_4711_99_my.png`.
fn split_canvas_name(name: &str) -> Option<((String, String), String)> {
    let (student, numbers_and_name) = name.split_once('_')?;
    let numbers_and_name = numbers_and_name.strip_prefix("LATE_").unwrap_or(numbers_and_name);
    let [user, file, name] = numbers_and_name.splitn(3, '_').collect::<Vec<_>>().try_into().ok()?;
    let is_number = |text: &str| 1 < text.len() && text.bytes().all(|byte| byte.is_ascii_digit());
    let is_split = !student.contains('/') && is_number(user) && is_number(file);
    is_split.then(|| ((student.to_owned(), user.to_owned()), name.to_owned()))
}

/// How many bytes the names have in common up to a `-`, as the repositories of one assignment do.
fn common_prefix(names: &[String]) -> usize {
    let [first, _, ..] = names else { return 0 };
    let mut ends = first.rmatch_indices('-').map(|(k, _)| k + 1);
    ends.find(|end| names.iter().all(|name| name.starts_with(&first[..*end]))).unwrap_or(0)
}

/// The student's name: what a platform calls the student, without Moodle's number.
fn without_number(key: &str) -> &str {
    let is_number = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    key.rsplit_once('_').filter(|(_, number)| is_number(number)).map_or(key, |(name, _)| name)
}
