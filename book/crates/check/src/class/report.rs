use crate::{Answer, Verdict, escape_for_terminal};
use course::json;
use std::iter;

/// What there is of one picture of a student, or in place of pictures.
pub(crate) struct Row {
    pub student: String,
    /// Such as `1 of 2`: how many of the student's pictures that count are right.
    pub right: String,
    /// The picture's name, empty where there is something else.
    pub picture: &'static str,
    /// Whether the picture was asked for; all are if none was.
    pub counts: bool,
    /// The path of the file that was looked at, if there is one.
    pub found: String,
    /// A sentence on what is wrong or to be noted; empty where nothing is.
    pub feedback: String,
    pub answer: Answer,
}

impl Row {
    /// A row about a picture that counts, below those of the student's earlier pictures.
    pub fn new(student: &str, picture: &'static str, answer: Answer, earlier: &[Row]) -> Self {
        // The pictures that an answer compares aren't kept.
        let answer = Answer { compared: None, ..answer };
        let feedback = escape_for_terminal(&feedback(&answer, earlier));
        Self { picture, counts: true, answer, ..Self::in_place(student, feedback) }
    }

    /// A row about what there is in place of pictures.
    pub fn in_place(student: &str, feedback: String) -> Self {
        let (student, answer) = (student.to_owned(), Answer::new(Verdict::Missing, ""));
        let (right, found) = (String::new(), String::new());
        Self { student, right, picture: "", counts: false, found, feedback, answer }
    }

    pub fn is_missing(&self) -> bool {
        self.answer.verdict == Verdict::Missing
    }

    fn is_right(&self) -> bool {
        self.answer.verdict == Verdict::Right
    }

    fn cells(&self) -> [&str; COLUMNS.len()] {
        let verdict = if self.picture.is_empty() { "" } else { self.answer.verdict.words() };
        let counts = if self.counts { "yes" } else { "" };
        [&self.student, &self.right, self.picture, verdict, &self.feedback, &self.found, counts]
    }
}

/// What an answer says in a sentence, or which earlier picture is wrong by the same cause, the
/// only one that we know for one of the two.
fn feedback(answer: &Answer, earlier: &[Row]) -> String {
    let follows = earlier.iter().find_map(|row| {
        let cause = row.answer.causes.iter().find(|cause| answer.causes.contains(cause))?;
        let is_sure = row.answer.causes.len() == 1 || answer.causes.len() == 1;
        is_sure.then(|| format!("Follows from {}: {}.", row.picture, cause.words_and_file()))
    });
    let mut lines = answer.text.lines();
    let first = lines.next().unwrap_or_default();
    let starts = ["Not right. ", "As with other options: ", "error: "];
    let start = starts.iter().find_map(|start| first.strip_prefix(start));
    follows.unwrap_or_else(|| match answer.verdict {
        Verdict::Right => lines.collect::<Vec<_>>().join(" "),
        _ => start.unwrap_or(first).to_owned(),
    })
}

/// The rows of a student, each with how many pictures are right.
pub(crate) fn count_right(mut rows: Vec<Row>) -> Vec<Row> {
    let counted = rows.iter().filter(|row| row.counts);
    let right_count = counted.clone().filter(|row| row.is_right()).count();
    let text = format!("{right_count} of {}", counted.count());
    rows.iter_mut().for_each(|row| row.right.clone_from(&text));
    rows
}

/// The answer made of the rows about all students: a table, or, for a spreadsheet, CSV; and JSON.
///
/// The verdict is right if all pictures are that count.
pub(crate) fn report_answer(rows: &[Row], is_csv: bool) -> Answer {
    let verdict = match rows.iter().filter(|row| row.counts).all(Row::is_right) {
        _ if rows.iter().all(Row::is_missing) => Verdict::Missing,
        true => Verdict::Right,
        false => Verdict::NotRight,
    };
    let text = if is_csv { format_csv(rows) } else { format_table(rows) };
    Answer { report: Some(format_json(rows)), ..Answer::new(verdict, text) }
}

const COLUMNS: [&str; 7] =
    ["student", "right", "picture", "verdict", "feedback", "found", "counts"];

/// The first five columns of the rows, with each student's name once.
fn format_table(rows: &[Row]) -> String {
    let mut last = "";
    let cells = rows.iter().map(|row| {
        let [student, right, cells @ .., _, _] = row.cells();
        let is_new = last != student;
        last = student;
        let start = if is_new { [student, right] } else { [""; 2] };
        let cells = start.into_iter().chain(cells);
        cells.map(escape_for_terminal).collect::<Vec<_>>()
    });
    let head = COLUMNS[..5].iter().map(|&name| name.to_owned()).collect();
    align(&iter::once(head).chain(cells).collect::<Vec<_>>())
}

/// Rows of words in columns, each as wide as its longest word.
pub(crate) fn align(rows: &[Vec<String>]) -> String {
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<_> = (0..rows.first().map_or(0, Vec::len)).map(width).collect();
    let line = |row: &Vec<String>| {
        let words = row.iter().zip(&widths).map(|(word, width)| format!("{word:width$}"));
        words.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}

/// The rows below their head, after a mark by which a spreadsheet knows UTF-8.
fn format_csv(rows: &[Row]) -> String {
    let lines = rows.iter().map(|row| row.cells().map(csv_cell).join(","));
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
    let object = |row: &Row| {
        let cells = iter::zip(COLUMNS, row.cells()).filter(|(_, cell)| !cell.is_empty());
        let cells = cells.map(|(name, cell)| (name, json::quote(cell)));
        let fields = row.answer.json_fields().into_iter().skip(1);
        format!("\n  {}", json::object(cells.chain(fields.filter(|_| !row.picture.is_empty()))))
    };
    json::list(rows.iter().map(object))
}
