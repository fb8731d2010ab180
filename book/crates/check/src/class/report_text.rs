use crate::class::found_file::picture_names;
use crate::class::report::{Entry, Report};
use crate::class::table::align;
use crate::{Answer, Verdict, escape_for_terminal};
use course::json;
use std::iter;

/// The answer made of reports on students, and of a clause about files that are nobody's, as text
/// and as JSON. The text is a table, or, for a spreadsheet, a row for each picture.
///
/// The verdict is right if all pictures are that were required, or else all that are there.
pub(crate) fn report_answer(
    reports: &[Report],
    stray: Option<&str>,
    is_csv: bool,
    is_own: bool,
) -> Answer {
    let rows = rows(reports, stray);
    let text = match (is_csv, is_own) {
        (true, _) => format_csv(&rows),
        (_, true) => format_own(&reports[0]),
        _ => format_class(reports, stray),
    };
    let pictures = || reports.iter().flat_map(|report| &report.pictures);
    let verdict = match reports.iter().flat_map(Report::counted).all(Entry::is_right) {
        _ if pictures().all(Entry::is_missing) => Verdict::Missing,
        true => Verdict::Right,
        false => Verdict::NotRight,
    };
    Answer { report: Some(format_json(&rows)), ..Answer::new(verdict, text) }
}

impl Entry {
    /// A sentence on what is wrong or to be noted; empty where nothing is.
    fn feedback(&self) -> String {
        if let Some((step, cause)) = &self.follows {
            return format!("Follows from {step}: {cause}.");
        }
        let mut lines = self.answer.text.lines();
        let first = lines.next().unwrap_or_default();
        let starts = ["Not right. ", "With other options: ", "error: "];
        let start = starts.iter().find_map(|start| first.strip_prefix(start));
        escape_for_terminal(&match self.answer.verdict {
            Verdict::Right => lines.collect::<Vec<_>>().join(" "),
            _ => start.unwrap_or(first).to_owned(),
        })
    }
}

/// One line for each picture, and how many are right.
fn format_own(report: &Report) -> String {
    let row = |entry: &Entry| {
        vec![entry.name.to_owned(), entry.answer.verdict.words().to_owned(), entry.feedback()]
    };
    let rows: Vec<_> = report.pictures.iter().map(row).collect();
    let in_place = report.in_place.as_deref().unwrap_or_default();
    format!("{}Right: {}.\n{in_place}", align(&rows), report.count_text())
}

/// One line for each student: how many pictures are right, and the verdict on each that was
/// required, or else on each that anybody has. Below are the sentences on each student.
fn format_class(reports: &[Report], stray: Option<&str>) -> String {
    let has_column = |name: &&str| {
        let mut counted = reports.iter().flat_map(Report::counted);
        counted.any(|entry| entry.name == *name)
    };
    let names: Vec<_> = picture_names().filter(has_column).collect();
    let head = ["", "right"].into_iter().chain(names.iter().copied());
    let mut rows = vec![head.map(str::to_owned).collect()];
    let mut sentences = String::new();
    for report in reports {
        let student = escape_for_terminal(&report.student);
        let verdict = |name: &&str| {
            let entry = report.pictures.iter().find(|entry| entry.name == *name);
            entry.map_or(Verdict::Missing, |entry| entry.answer.verdict).words().to_owned()
        };
        let row = [student.clone(), report.count_text()];
        rows.push(row.into_iter().chain(names.iter().map(verdict)).collect());
        for entry in &report.pictures {
            let feedback = Some(entry.feedback()).filter(|text| !text.is_empty());
            sentences.extend(feedback.map(|text| format!("{student}, {}: {text}\n", entry.name)));
        }
        sentences.extend(report.in_place.iter().map(|found| format!("{student}, {found}\n")));
    }
    sentences.extend(stray.map(|found| format!("Nobody's, {found}\n")));
    align(&rows) + &sentences
}

/// What there is of one picture of a student, or in place of pictures: a cell for each column.
type Row<'a> = ([String; 6], Option<&'a Answer>);

const COLUMNS: [&str; 6] = ["student", "right", "picture", "verdict", "found", "feedback"];

fn rows<'a>(reports: &'a [Report], stray: Option<&str>) -> Vec<Row<'a>> {
    let mut rows = vec![];
    for report in reports {
        let count = report.count_text();
        let mut add = |[name, verdict, file, feedback]: [&str; 4], answer| {
            let cells = [&report.student, &*count, name, verdict, file, feedback];
            rows.push((cells.map(str::to_owned), answer));
        };
        for entry in &report.pictures {
            let words = entry.answer.verdict.words();
            add([entry.name, words, &entry.file, &entry.feedback()], Some(&entry.answer));
        }
        report.in_place.iter().for_each(|found| add(["", "", "", found], None));
    }
    rows.extend(stray.map(|found| (["", "", "", "", "", found].map(str::to_owned), None)));
    rows
}

/// The rows below their head, after a mark by which a spreadsheet knows UTF-8.
fn format_csv(rows: &[Row]) -> String {
    let lines = rows.iter().map(|(cells, _)| cells.each_ref().map(|cell| csv_cell(cell)).join(","));
    let lines = iter::once(COLUMNS.join(",")).chain(lines);
    format!("\u{feff}{}", lines.map(|line| line + "\r\n").collect::<String>())
}

/// A cell in quotes, with a `'` before what a spreadsheet would compute.
fn csv_cell(text: &str) -> String {
    let mark = if text.starts_with(['=', '+', '-', '@']) { "'" } else { "" };
    format!("\"{mark}{}\"", text.replace('"', "\"\""))
}

/// The rows as a list of objects, with the fields of each answer.
fn format_json(rows: &[Row]) -> String {
    let object = |(cells, answer): &Row| {
        let cells = iter::zip(COLUMNS, cells);
        let cells = cells.filter(|(name, cell)| *name != "verdict" && !cell.is_empty());
        let cells = cells.map(|(name, cell)| (name, json::quote(cell)));
        let fields = answer.iter().flat_map(|answer| answer.json_fields());
        format!("\n  {}", json::object(cells.chain(fields)))
    };
    json::list(rows.iter().map(object))
}
