//! Problems to solve on paper, and the sheet that repeats the problems from all chapters.

use crate::fault::{ChapterError, ChapterResult};
use crate::folded_box::{self, BoxKind};
use crate::markdown::html_block;
use crate::values::Values;

/// The maximum number of words in a problem's text.
pub const MAX_WORDS: usize = 80;

/// The number and the answer of a problem, from its first line, such as `{{#problem 7 0.622}}`.
/// After the first line come the text of the problem, `{{#answer}}`, the solution, and `{{#end}}`.
#[derive(Clone, Debug, PartialEq)]
pub struct NumberAndAnswer {
    /// The number of the problem, such as 7.
    pub number: String,
    /// The answer as the author wrote it, such as 1,543,680.
    pub answer: String,
}

impl NumberAndAnswer {
    /// Parses the words in `{{#problem …}}`.
    pub fn parse(words: &str) -> ChapterResult<Self> {
        let (number, answer) = words.split_once(' ').ok_or(ChapterError::ProblemForm)?;
        let number_and_answer = Self { number: number.to_owned(), answer: answer.to_owned() };
        let is_number = number_and_answer.answer_without_commas().parse::<f64>().is_ok();
        if is_number { Ok(number_and_answer) } else { Err(ChapterError::ProblemForm) }
    }

    /// The answer without thousands separators, so that the answer can be parsed.
    fn answer_without_commas(&self) -> String {
        self.answer.replace(',', "")
    }

    /// Returns the HTML that begins the problem. In the browser, book/theme/book.js compares the
    /// reader's number with the answer. If the answer is a whole number, the reader's number has to
    /// be equal to the answer. Otherwise the reader's number may differ from the answer by 1 %.
    pub fn opening_html(&self) -> String {
        let (number, answer) = (&self.number, self.answer_without_commas());
        let tolerance = if answer.contains('.') { 0.01 } else { 0.0 };
        format!(
            "<section class=\"problem\" id=\"problem-{number}\" data-answer=\"{answer}\" \
             data-tolerance=\"{tolerance}\">\
             <b class=\"number\">{number}</b>\n"
        )
    }

    /// Returns the HTML of the form in which the reader enters a number. The form goes below the
    /// problem's text. If scripts are disabled, the form stays hidden, since it wouldn't work.
    pub fn form_html(&self) -> String {
        format!(
            "<form hidden><input required placeholder=\"your number\" autocomplete=\"off\" \
             aria-label=\"Your number for problem {}\"><button>Check</button>\
             <output></output></form>\n",
            self.number
        )
    }
}

/// A problem in a chapter.
#[derive(Clone, Debug)]
pub struct Problem {
    pub number_and_answer: NumberAndAnswer,
    /// The expanded text of the problem.
    pub text: String,
    /// The first passage in bold in the expanded answer, including the asterisks.
    pub result: String,
}

/// A position in the text of a chapter, and the corresponding position in the expanded text.
#[derive(Clone, Copy, Debug)]
pub struct PositionPair {
    pub in_text: usize,
    pub in_expanded: usize,
}

/// A problem whose answer hasn't begun yet.
#[derive(Debug)]
pub struct OpenProblem {
    /// The problem's number and answer, or None if the first line contains an error.
    pub number_and_answer: Option<NumberAndAnswer>,
    /// The start of the problem's first line.
    pub start: usize,
    /// The end of the problem's first line, where the text of the problem begins.
    pub text_start: PositionPair,
}

impl OpenProblem {
    pub fn begin_answer(self, start: PositionPair) -> OpenAnswer {
        OpenAnswer { problem: self, start, bold_start: None, bold_end: None }
    }
}

/// The answer to a problem, before the `{{#end}}` of the problem is reached.
#[derive(Debug)]
pub struct OpenAnswer {
    pub problem: OpenProblem,
    /// The start of the line `{{#answer}}`.
    start: PositionPair,
    /// The start of the answer's first passage in bold.
    bold_start: Option<PositionPair>,
    /// The end of the answer's first passage in bold.
    bold_end: Option<PositionPair>,
}

impl OpenAnswer {
    /// Records where a passage in bold begins, if no earlier passage in this answer is in bold.
    pub fn record_first_bold_start(&mut self, position: PositionPair) {
        self.bold_start.get_or_insert(position);
    }

    /// Records where a passage in bold ends, if no earlier passage in this answer is in bold.
    pub fn record_first_bold_end(&mut self, position: PositionPair) {
        self.bold_end.get_or_insert(position);
    }

    /// Completes the problem when its `{{#end}}` is reached. `text` is the text of the chapter, and
    /// `expanded` is the expanded text so far. Returns None if the problem's first line is an
    /// error, which has already been reported.
    pub fn finish(self, text: &str, expanded: &str) -> Option<ChapterResult<Problem>> {
        let (start, end) = (self.problem.text_start, self.start);
        let number_and_answer = self.problem.number_and_answer?;
        let words = text[start.in_text..end.in_text].split_whitespace();
        if words.count() > MAX_WORDS {
            return Some(Err(ChapterError::LongProblem(MAX_WORDS)));
        }
        let bold_words = self.bold_start.zip(self.bold_end);
        let result =
            bold_words.map_or("", |(start, end)| &expanded[start.in_expanded..end.in_expanded]);
        Some(Ok(Problem {
            number_and_answer,
            text: expanded[start.in_expanded..end.in_expanded].trim().to_owned(),
            result: result.to_owned(),
        }))
    }
}

/// Returns the Markdown for `{{#problem-sheet}}`: the problems from all chapters, then their
/// answers. For each answer, the sheet shows only the result (the first passage in bold), not the
/// solution. `chapters` contains the title and the problems of each chapter.
pub fn sheet_markdown(
    chapters: &[(String, Vec<Problem>)],
    values: &Values,
) -> ChapterResult<String> {
    let (mut problems, mut answers) = (String::new(), String::new());
    for (title, chapter) in chapters.iter().filter(|(_, problems)| !problems.is_empty()) {
        problems += &format!("## {}\n\n", title.trim_end_matches(": practice"));
        for Problem { number_and_answer, text, result, .. } in chapter {
            problems += &html_block(&number_and_answer.opening_html());
            let end = number_and_answer.form_html() + "</section>";
            problems += &format!("{text}\n{}", html_block(&end));
            let number = &number_and_answer.number;
            let link = format!("<a href=\"#problem-{number}\">{number}</a>");
            answers += &html_block(&format!("<div class=\"answer\">{link}"));
            answers += &format!("{result}\n{}", html_block("</div>"));
        }
    }
    let answer_box = folded_box::opening_html(BoxKind::Answer, "to each problem", values)?;
    let answers = [html_block(&answer_box), answers, html_block("</details>")].concat();
    Ok(format!("{problems}## Answers {{#answers}}\n{answers}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn problem_needs_a_number_and_a_numeric_answer() {
        let number_and_answer = NumberAndAnswer::parse("8 1,234").expect("the words are valid");
        assert_eq!(
            number_and_answer,
            NumberAndAnswer { number: "8".to_owned(), answer: "1,234".to_owned() }
        );
        for words in ["", "7", "7 lens", "7 0.5 m"] {
            assert!(
                matches!(NumberAndAnswer::parse(words), Err(ChapterError::ProblemForm)),
                "{words}"
            );
        }
    }

    #[test]
    fn whole_number_answer_has_no_tolerance() {
        let html =
            |words| NumberAndAnswer::parse(words).expect("the words are valid").opening_html();
        assert!(html("8 1,234").contains("data-answer=\"1234\" data-tolerance=\"0\""));
        assert!(html("7 0.5").contains("data-answer=\"0.5\" data-tolerance=\"0.01\""));
    }
}
