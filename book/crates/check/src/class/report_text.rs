use crate::class::{Entry, Report};
use crate::{Verdict, escape_for_terminal};
use course::{NAMED_SCENE_EXAMPLE, Step, json, locked_names};

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
    /// A line on what there is in place of pictures; None where nothing is.
    fn in_place(&self) -> Option<String> {
        let mut names = format_names(&self.unchecked);
        match self.other_files.len() {
            count if MOST_NAMES < count => {
                names.push(format!("{count} files that are no pictures"))
            }
            _ => names.extend(format_names(&self.other_files)),
        }
        let is_empty = self.pictures.iter().all(|entry| entry.answer.verdict == Verdict::Missing);
        match names.is_empty() {
            false => Some(format!("not looked at: {}", names.join(", "))),
            true => is_empty.then(|| "nothing was handed in".into()),
        }
    }
}

/// The first of some names, and how many more there are.
fn format_names(names: &[String]) -> Vec<String> {
    let first = names.iter().take(MOST_NAMES).map(|name| escape_for_terminal(name));
    let more = names.len().saturating_sub(MOST_NAMES);
    first.chain((0 < more).then(|| format!("{more} more"))).collect()
}

/// How many pictures are right: of those required, if any are, or else all.
fn format_count(report: &Report) -> String {
    match (report.count_right(true), report.count_right(false)) {
        ((_, 0), (right, _)) => right.to_string(),
        ((right, all), _) => format!("{right} of {all}"),
    }
}

/// One line for each picture, and how many are right.
pub(crate) fn format_table(report: &Report, stray: &[String]) -> String {
    let width = report.pictures.iter().map(|entry| entry.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for entry in &report.pictures {
        let verdict = entry.answer.verdict.words();
        let words = match entry.feedback() {
            feedback if feedback.is_empty() => verdict.to_owned(),
            feedback => format!("{verdict}: {feedback}"),
        };
        text += &format!("{:width$}  {words}\n", entry.name);
    }
    let right = report.count_right(true).0 + report.count_right(false).0;
    text += &format!("{right} of {} are right.", report.pictures.len());
    text += &format_stray("Here", &report.unchecked);
    text + &format_stray("Deeper", stray)
}

/// One line for each student: how many pictures are right, the verdict on each that was
/// required, else on each step and the scene where anybody has it, and how many of the others
/// are right. Below are the sentences on each student.
pub(crate) fn format_class(reports: &[Report], stray: &[String]) -> String {
    let entries = || reports.iter().flat_map(|report| &report.pictures);
    let has_required = entries().any(|entry| entry.is_required);
    let has_column = |entry: &Entry| match has_required {
        true => entry.is_required,
        false => Step::from_name(entry.name).is_some() || entry.name == NAMED_SCENE_EXAMPLE,
    };
    let mut names = locked_names();
    names.push(NAMED_SCENE_EXAMPLE);
    names.retain(|name| entries().any(|entry| entry.name == *name && has_column(entry)));
    let has_others = entries().any(|entry| !has_column(entry));
    let others = Some("others").filter(|_| has_others);
    let head = ["", "right"].into_iter().chain(names.iter().copied()).chain(others);
    let mut rows = vec![head.map(str::to_owned).collect()];
    for report in reports {
        let mut row = vec![escape_for_terminal(&report.student), format_count(report)];
        row.extend(names.iter().map(|name| {
            let entry = report.pictures.iter().find(|entry| entry.name == *name);
            entry.map_or(Verdict::Missing, |entry| entry.answer.verdict).words().to_owned()
        }));
        if has_others {
            let others = report.pictures.iter().filter(|entry| !has_column(entry));
            let right = others.clone().filter(|entry| entry.answer.verdict == Verdict::Right);
            row.push(format!("{} of {}", right.count(), others.count()));
        }
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
    text.trim_end().to_owned() + &format_stray("Nobody's", stray)
}

/// A line with the names of files that aren't a student's.
fn format_stray(title: &str, stray: &[String]) -> String {
    match format_names(stray).join(", ") {
        names if names.is_empty() => names,
        names => format!("\n{title}, not looked at: {names}"),
    }
}

/// Rows of words in columns, each as wide as its longest word.
fn align(rows: &[Vec<String>]) -> String {
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<_> = (0..rows[0].len()).map(width).collect();
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
        let (student, count) = (&*report.student, format_count(report));
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
    let report = |report: &Report| {
        let [(required_right, required), (other_right, _)] =
            [true, false].map(|are| report.count_right(are));
        let right = if required == 0 { other_right } else { required_right };
        let fields = [
            ("student", json::quote(&report.student)),
            ("right", right.to_string()),
            ("required", required.to_string()),
            ("not_looked_at", json::list(report.unchecked.iter().map(|one| json::quote(one)))),
            ("other_files", json::list(report.other_files.iter().map(|one| json::quote(one)))),
            ("pictures", json::list(report.pictures.iter().map(entry))),
        ];
        format!("\n  {}", json::object(fields))
    };
    let fields = [
        ("students", json::list(reports.iter().map(report))),
        ("nobodys", json::list(stray.iter().map(|one| json::quote(one)))),
    ];
    json::object(fields) + "\n"
}
