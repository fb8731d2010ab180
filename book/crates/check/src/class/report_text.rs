use crate::answer::join_first;
use crate::class::found_file::picture_names;
use crate::class::{Entry, Report};
use crate::{Verdict, escape_for_terminal};
use course::json;

/// The most names of files that a line tells.
const MOST_NAMES: usize = 8;

impl Entry {
    /// A sentence on what is wrong or to be noted; empty where nothing is.
    fn feedback(&self) -> String {
        if let Some((step, cause)) = &self.follows {
            return format!("Follows from {step}: {cause}.");
        }
        let mut lines = self.answer.text.lines();
        let first = lines.next().unwrap_or_default();
        let starts = ["Not right. ", "Right, but with other options: ", "error: "];
        let start = starts.iter().find_map(|start| first.strip_prefix(start));
        escape_for_terminal(&match self.answer.verdict {
            Verdict::Right => lines.collect::<Vec<_>>().join(" "),
            _ => start.unwrap_or(first).to_owned(),
        })
    }
}

impl Report {
    /// How many pictures are right: of those required, if any are, or else all.
    fn count_text(&self) -> String {
        match (self.right_count(), self.required_count()) {
            (right, 0) => right.to_string(),
            (right, required) => format!("{right} of {required}"),
        }
    }

    /// What there is in place of pictures; None where nothing is.
    fn in_place(&self) -> Option<String> {
        let is_empty = self.pictures.iter().all(Entry::is_missing);
        unchecked_clause(&self.unchecked)
            .or_else(|| is_empty.then(|| "nothing was handed in".to_owned()))
    }
}

/// A clause with the first of some names, and how many more there are; None where none are.
fn unchecked_clause(names: &[String]) -> Option<String> {
    let told = names.iter().map(|name| escape_for_terminal(name)).collect();
    (!names.is_empty()).then(|| format!("not looked at: {}", join_first(told, MOST_NAMES, ", ")))
}

/// One line for each picture, and how many are right.
pub(crate) fn format_own(report: &Report) -> String {
    let row = |entry: &Entry| {
        vec![entry.name.to_owned(), entry.answer.verdict.words().to_owned(), entry.feedback()]
    };
    let rows: Vec<_> = report.pictures.iter().map(row).collect();
    let unchecked = unchecked_clause(&report.unchecked).unwrap_or_default();
    format!("{}Right: {}.\n{unchecked}", align(&rows), report.count_text())
}

/// One line for each student: how many pictures are right, and the verdict on each that was
/// required, or else on each that anybody has. Below are the sentences on each student.
pub(crate) fn format_class(reports: &[Report], stray: &[String]) -> String {
    let has_column = |name: &&str| {
        let mut counted = reports.iter().flat_map(Report::counted);
        counted.any(|entry| entry.name == *name)
    };
    let names: Vec<_> = picture_names().filter(has_column).collect();
    let head = ["", "right"].into_iter().chain(names.iter().copied());
    let mut rows = vec![head.map(str::to_owned).collect()];
    for report in reports {
        let mut row = vec![escape_for_terminal(&report.student), report.count_text()];
        row.extend(names.iter().map(|name| {
            let entry = report.pictures.iter().find(|entry| entry.name == *name);
            entry.map_or(Verdict::Missing, |entry| entry.answer.verdict).words().to_owned()
        }));
        rows.push(row);
    }
    let mut text = align(&rows);
    for report in reports {
        let student = escape_for_terminal(&report.student);
        for entry in &report.pictures {
            let feedback = Some(entry.feedback()).filter(|text| !text.is_empty());
            text.extend(feedback.map(|text| format!("{student}, {}: {text}\n", entry.name)));
        }
        text.extend(report.in_place().map(|found| format!("{student}, {found}\n")));
    }
    text.extend(unchecked_clause(stray).map(|clause| format!("Nobody's, {clause}\n")));
    text
}

/// Rows of words in columns, each as wide as its longest word.
fn align(rows: &[Vec<String>]) -> String {
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<_> = (0..rows.first().map_or(0, Vec::len)).map(width).collect();
    let line = |row: &Vec<String>| {
        let words = row.iter().zip(&widths).map(|(word, width)| format!("{word:width$}"));
        words.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}

/// A row for each student and picture, after a mark by which a spreadsheet knows UTF-8.
pub(crate) fn format_csv(reports: &[Report]) -> String {
    let mut text = String::from("\u{feff}student,right,picture,verdict,file,feedback\r\n");
    for report in reports {
        let (student, count) = (&*report.student, report.count_text());
        let mut add = |cells: [&str; 4]| {
            let cells = [student, &count].into_iter().chain(cells).map(csv_cell);
            text += &(cells.collect::<Vec<_>>().join(",") + "\r\n");
        };
        for entry in &report.pictures {
            let file = entry.file.as_deref().unwrap_or_default();
            add([entry.name, entry.answer.verdict.words(), file, &entry.feedback()]);
        }
        report.in_place().iter().for_each(|found| add(["", "", "", found]));
    }
    text
}

/// A cell in quotes, with a `'` before what a spreadsheet would compute.
fn csv_cell(text: &str) -> String {
    let mark = if text.starts_with(['=', '+', '-', '@']) { "'" } else { "" };
    format!("\"{mark}{}\"", text.replace('"', "\"\""))
}

/// A list of students, each with the answer about each picture.
pub(crate) fn format_json(reports: &[Report], stray: &[String]) -> String {
    let entry = |entry: &Entry| {
        let mut fields = vec![("picture", json::quote(entry.name))];
        fields.push(("required", entry.is_required.to_string()));
        fields.extend(entry.file.iter().map(|file| ("found", json::quote(file))));
        fields.extend(entry.follows.iter().map(|(step, _)| ("follows", json::quote(step))));
        fields.extend(entry.answer.json_fields());
        format!("\n   {}", json::object(fields))
    };
    let names = |names: &[String]| json::list(names.iter().map(|one| json::quote(one)));
    let report = |report: &Report| {
        let fields = [
            ("student", json::quote(&report.student)),
            ("right", report.right_count().to_string()),
            ("required", report.required_count().to_string()),
            ("not_looked_at", names(&report.unchecked)),
            ("pictures", json::list(report.pictures.iter().map(entry))),
        ];
        format!("\n  {}", json::object(fields))
    };
    let students = json::list(reports.iter().map(report));
    json::object([("students", students), ("nobodys", names(stray))])
}
