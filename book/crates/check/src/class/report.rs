//! Formats the report on a class, and the report on a reader's own pictures, as a table or as JSON.
//! Also formats the report on a class as CSV, for a spreadsheet.

use crate::Verdict;
use crate::class::feedback::FileVerdict;
use crate::class::skipped_paths::SkippedPaths;
use crate::class::student::{FileReport, Note, PictureReport, StudentReport};
use crate::class::table::align_columns;
use course::json;

/// The verdict on a picture that has no file.
const MISSING: &str = "missing";

/// The report on a class.
#[derive(Debug)]
pub struct ClassReport {
    pub(crate) students: Vec<StudentReport>,
    /// Everything in the class's folder that isn't a student's folder.
    pub(crate) skipped_paths: SkippedPaths,
}

/// The report on a reader's own pictures.
#[derive(Debug)]
pub struct OwnPicturesReport {
    pub(crate) report: StudentReport,
}

impl ClassReport {
    /// The program's exit code is the first of these that applies:
    ///
    /// - 2 if something is missing, unreadable or skipped, or if there is a note on a student
    /// - 1 if a picture that counts towards the points hasn't earned its point
    /// - 0 otherwise
    pub fn exit_code(&self) -> u8 {
        if !self.skipped_paths.is_empty() || self.students.iter().any(needs_a_look) {
            2
        } else {
            self.students.iter().any(|student| student.points() < student.max_points()).into()
        }
    }

    /// Formats the report for a terminal: a row for each student, followed by rows for the
    /// student's files and missing pictures.
    pub fn to_table(&self) -> String {
        let head = ["student", "points", "picture", "verdict", "feedback"];
        let mut rows = vec![head.map(str::to_owned).to_vec()];
        for student in &self.students {
            let points = format!("{} of {}", student.points(), student.max_points());
            let feedback = notes_and_skipped_clause(student);
            rows.push(vec![student.name.clone(), points, String::new(), String::new(), feedback]);
            rows.extend(file_rows_of_student(student).into_iter().map(|row| {
                let feedback = row.feedback_with_path_if_needed();
                vec![String::new(), String::new(), row.picture, row.verdict, feedback]
            }));
        }
        let skipped = self.skipped_paths.clause();
        let sentence = skipped.map(|clause| format!("\nBeside the students' folders, {clause}\n"));
        align_columns(&rows) + &sentence.unwrap_or_default()
    }

    /// Formats the report for a spreadsheet. The byte order mark at the start tells the spreadsheet
    /// that the text is UTF-8. The column `points` has numbers only in the rows of students, and
    /// the column `point` only in the rows of pictures, so that each column can be summed.
    pub fn to_csv(&self) -> String {
        let mut rows = vec![];
        for student in &self.students {
            rows.push(CsvRow {
                student: student.name.clone(),
                points: Some(student.points()),
                max_points: Some(student.max_points()),
                feedback: notes_and_skipped_clause(student),
                ..CsvRow::default()
            });
            rows.extend(file_rows_of_student(student).into_iter().map(|row| CsvRow {
                student: student.name.clone(),
                picture: row.picture,
                point: row.point,
                verdict: row.verdict,
                feedback: row.feedback,
                file: row.file.unwrap_or_default(),
                ..CsvRow::default()
            }));
        }
        rows.extend(self.skipped_paths.clause().map(|clause| CsvRow {
            feedback: format!("beside the students' folders, {clause}"),
            ..CsvRow::default()
        }));
        let head = "student,points,of,picture,point,verdict,feedback,file\n";
        format!("\u{feff}{head}{}", rows.iter().map(CsvRow::to_line).collect::<String>())
    }

    /// Formats the report as JSON.
    pub fn to_json(&self) -> String {
        let students = self.students.iter().map(|student| {
            format!(
                "\n  {}",
                json::object([
                    ("student", json::quote(&student.name)),
                    ("points", student.points().to_string()),
                    ("of", student.max_points().to_string()),
                    (
                        "notes",
                        json::list(student.notes.iter().map(|note| json::quote(&note.clause())))
                    ),
                    ("not_looked_at", skipped_paths_json(&student.skipped_paths)),
                    ("pictures", pictures_json(student)),
                ])
            )
        });
        json::object([
            ("students", json::list(students)),
            ("not_looked_at", skipped_paths_json(&self.skipped_paths)),
        ])
    }
}

impl OwnPicturesReport {
    /// The program's exit code is the first of these that applies:
    ///
    /// - 2 if there are no pictures, or if a picture is missing or unreadable
    /// - 1 if a picture that counts isn't right
    /// - 0 otherwise
    pub fn exit_code(&self) -> u8 {
        if self.report.pictures.is_empty() || has_missing_or_unreadable(&self.report) {
            2
        } else {
            (self.right_count() < self.report.max_points()).into()
        }
    }

    /// Formats the report for a terminal: a row for each file and each missing picture.
    pub fn to_table(&self) -> String {
        let Self { report } = self;
        let skipped = report.skipped_paths.clause().map(|clause| clause + "\n").unwrap_or_default();
        if report.pictures.is_empty() {
            return format!("There are no pictures of the course here.\n{skipped}");
        }
        let head = ["picture", "verdict", "feedback"].map(str::to_owned);
        let mut rows = vec![head.to_vec()];
        rows.extend(file_rows_of_student(report).into_iter().map(|row| {
            let feedback = row.feedback_with_path_if_needed();
            vec![row.picture, row.verdict, feedback]
        }));
        let count = format!("{} of {} are right.\n", self.right_count(), report.max_points());
        align_columns(&rows) + "\n" + &count + &skipped
    }

    /// Formats the report as JSON.
    pub fn to_json(&self) -> String {
        json::object([
            ("pictures", pictures_json(&self.report)),
            ("not_looked_at", skipped_paths_json(&self.report.skipped_paths)),
        ])
    }

    /// The number of counted pictures that are right. A picture is right if it has at least one
    /// file, and every one of its files is right.
    fn right_count(&self) -> usize {
        let is_right =
            |file: &FileReport| file.feedback.verdict == FileVerdict::Compared(Verdict::Right);
        self.report
            .counted_pictures()
            .filter(|picture| !picture.files.is_empty() && picture.files.iter().all(is_right))
            .count()
    }
}

/// A row about a file or about a missing picture.
struct FileRow {
    picture: String,
    /// The point for the picture: 1 or 0. None if the picture doesn't count, or if an earlier row
    /// already has the picture's point.
    point: Option<u8>,
    verdict: String,
    feedback: String,
    file: Option<String>,
    /// Whether the picture has several files.
    is_one_of_several: bool,
}

impl FileRow {
    /// The feedback. If the picture has several files, or if the file is in a subfolder, the path
    /// of the file precedes the feedback. From the paths, a teacher may notice that a student's
    /// folder holds the work of several students, with a subfolder for each.
    fn feedback_with_path_if_needed(&self) -> String {
        let needs_path = |path: &&str| self.is_one_of_several || path.contains('/');
        let path = self.file.as_deref().filter(needs_path).unwrap_or_default();
        let parts = [path, &self.feedback].into_iter().filter(|part| !part.is_empty());
        parts.collect::<Vec<_>>().join(": ")
    }
}

/// Returns a row for each of a student's files, and a row for each missing picture.
fn file_rows_of_student(student: &StudentReport) -> Vec<FileRow> {
    student.pictures.iter().flat_map(file_rows_of_picture).collect()
}

/// Returns a row for each file of a picture. If there are no files, returns one row, which says
/// that the picture is missing.
fn file_rows_of_picture(picture: &PictureReport) -> Vec<FileRow> {
    let point = picture.is_counted.then(|| picture.earns_point().into());
    let name = picture.picture.to_owned();
    if picture.files.is_empty() {
        return vec![FileRow {
            picture: name,
            point,
            verdict: MISSING.to_owned(),
            feedback: String::new(),
            file: None,
            is_one_of_several: false,
        }];
    }
    let row = |(k, file): (usize, &FileReport)| FileRow {
        picture: name.clone(),
        point: point.filter(|_| k == 0),
        verdict: file.feedback.verdict.label().to_owned(),
        feedback: file.feedback.sentence.clone(),
        file: Some(file.printable_path.clone()),
        is_one_of_several: picture.files.len() > 1,
    };
    picture.files.iter().enumerate().map(row).collect()
}

fn pictures_json(student: &StudentReport) -> String {
    let pictures = student.pictures.iter().map(|picture| {
        let mut fields = vec![("picture", json::quote(picture.picture))];
        if picture.is_counted {
            fields.push(("point", u8::from(picture.earns_point()).to_string()));
        }
        fields.push(("files", json::list(picture.files.iter().map(file_json))));
        format!("\n    {}", json::object(fields))
    });
    json::list(pictures)
}

fn file_json(file: &FileReport) -> String {
    let mut fields = vec![
        ("found", json::quote(&file.printable_path)),
        ("verdict", json::quote(file.feedback.verdict.label())),
        ("feedback", json::quote(&file.feedback.sentence)),
    ];
    fields.extend(file.result.iter().map(|answer| ("answer", answer.to_json())));
    format!("\n      {}", json::object(fields))
}

fn skipped_paths_json(skipped_paths: &SkippedPaths) -> String {
    let first_paths = skipped_paths.first.iter().map(|path| json::quote(&path.to_string()));
    json::object([("count", skipped_paths.count.to_string()), ("first", json::list(first_paths))])
}

/// Returns the notes on a student and a clause about what was skipped, joined by semicolons.
fn notes_and_skipped_clause(student: &StudentReport) -> String {
    let notes = student.notes.iter().map(|note: &Note| note.clause());
    let clauses = notes.chain(student.skipped_paths.clause());
    clauses.collect::<Vec<_>>().join("; ")
}

/// Whether a person should look at a student's folder, because something is missing, unreadable or
/// skipped, or because there is a note on the student.
fn needs_a_look(student: &StudentReport) -> bool {
    !student.notes.is_empty()
        || !student.skipped_paths.is_empty()
        || has_missing_or_unreadable(student)
}

fn has_missing_or_unreadable(student: &StudentReport) -> bool {
    let is_unreadable = |file: &FileReport| file.feedback.verdict == FileVerdict::Unreadable;
    student
        .pictures
        .iter()
        .any(|picture| picture.files.is_empty() || picture.files.iter().any(is_unreadable))
}

/// A row of the CSV.
#[derive(Default)]
struct CsvRow {
    student: String,
    /// A student's points.
    points: Option<usize>,
    /// The maximum of a student's points.
    max_points: Option<usize>,
    picture: String,
    /// The point for a picture: 1 or 0.
    point: Option<u8>,
    verdict: String,
    feedback: String,
    file: String,
}

impl CsvRow {
    fn to_line(&self) -> String {
        let number_cell =
            |number: Option<usize>| number.map(|number| number.to_string()).unwrap_or_default();
        let cells = [
            csv_text_cell(&self.student),
            number_cell(self.points),
            number_cell(self.max_points),
            csv_text_cell(&self.picture),
            number_cell(self.point.map(usize::from)),
            csv_text_cell(&self.verdict),
            csv_text_cell(&self.feedback),
            csv_text_cell(&self.file),
        ];
        cells.join(",") + "\n"
    }
}

/// Formats a cell that contains a text. The text is in quotes, and begins with an added `'` if a
/// spreadsheet could take the text for a formula.
fn csv_text_cell(text: &str) -> String {
    let is_invisible = |c: char| {
        c.is_whitespace() || c.is_control() || matches!(c, '\u{200b}'..='\u{200f}' | '\u{feff}')
    };
    let first_character = text.chars().find(|c| !is_invisible(*c));
    let is_formula = first_character.is_some_and(|c| "=+-@＝＋－＠".contains(c))
        || text.starts_with(['\t', '\r', '\n']);
    let mark = if is_formula { "'" } else { "" };
    format!("\"{mark}{}\"", text.replace('"', "\"\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_that_may_be_formulas_are_marked() {
        for text in ["=1", "+1", "-1", "@A", "\t=1", "\r\n=1", "\ttext", " =1", "＝1", "＠A"] {
            assert_eq!(csv_text_cell(text), format!("\"'{text}\""), "{text:?}");
        }
        for text in ["", "a=1", "−1", "1", "(+1)"] {
            assert_eq!(csv_text_cell(text), format!("\"{text}\""), "{text:?}");
        }
        assert_eq!(csv_text_cell("say \"hi\""), "\"say \"\"hi\"\"\"");
    }
}
