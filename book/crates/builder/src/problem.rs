//! Problems to be solved on paper, and the sheet that has those of all chapters once more.

use crate::fault::{ChapterError, ChapterResult};
use crate::folded_box;
use crate::values::Values;

/// The words that a problem's text may have.
pub const MAX_WORDS: usize = 80;

/// The line `{{#problem 7 0.622}}` that begins a problem. The problem's text follows,
/// `{{#answer}}`, the way to the answer, and `{{#end}}`.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// The number of the problem, such as 7.
    pub number: String,
    /// The number that solves it, as its author wrote it, such as 1,543,680.
    pub answer: String,
}

impl Heading {
    /// Reads the words of the directive.
    pub fn parse(words: &str) -> ChapterResult<Self> {
        let (number, answer) = words.split_once(' ').ok_or(ChapterError::ProblemForm)?;
        let heading = Self { number: number.to_owned(), answer: answer.to_owned() };
        let is_number = heading.answer_digits().parse::<f64>().is_ok();
        if is_number { Ok(heading) } else { Err(ChapterError::ProblemForm) }
    }

    /// The answer as programs read it.
    fn answer_digits(&self) -> String {
        self.answer.replace(',', "")
    }

    /// The HTML that begins the problem. What a reader types in is compared by
    /// book/theme/book.js: a whole number exactly, any other within 1 %.
    pub fn html(&self) -> String {
        let (number, answer) = (&self.number, self.answer_digits());
        let tolerance = if answer.contains('.') { 0.01 } else { 0.0 };
        format!(
            "<section class=\"problem\" id=\"problem-{number}\" data-answer=\"{answer}\" \
             data-tolerance=\"{tolerance}\">\
             <b class=\"number\">{number}</b>\n"
        )
    }
}

/// A problem of a chapter.
#[derive(Clone, Debug)]
pub struct Problem {
    pub heading: Heading,
    /// Its text, expanded.
    pub text: String,
    /// The first bold words of its answer, expanded, with their asterisks.
    pub result: String,
}

/// A position in the text of a chapter, and in what the text is expanded to.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    pub in_text: usize,
    pub in_expanded: usize,
}

/// A problem that has begun and hasn't ended yet.
#[derive(Debug)]
pub struct OpenProblem {
    /// None if the first line is faulty.
    heading: Option<Heading>,
    /// The beginning of the first line.
    pub start: usize,
    /// The end of the first line.
    text_start: Position,
    /// The beginning of the answer.
    text_end: Option<Position>,
    /// The first bold words of the answer.
    bold_start: Option<Position>,
    bold_end: Option<Position>,
}

impl OpenProblem {
    pub fn new(heading: Option<Heading>, start: usize, text_start: Position) -> Self {
        Self { heading, start, text_start, text_end: None, bold_start: None, bold_end: None }
    }

    pub fn begin_answer(&mut self, position: Position) {
        self.text_end = Some(position);
    }

    /// Notes where bold words begin, if they are the first of the answer.
    pub fn begin_bold_words(&mut self, position: Position) {
        if self.text_end.is_some() {
            self.bold_start.get_or_insert(position);
        }
    }

    /// Notes where bold words end, if they are the first of the answer.
    pub fn end_bold_words(&mut self, position: Position) {
        if self.bold_start.is_some() {
            self.bold_end.get_or_insert(position);
        }
    }

    /// The problem, once its answer has ended. None if there is no answer or the first line is
    /// faulty, which has been reported before.
    pub fn finish(self, text: &str, expanded: &str) -> Option<ChapterResult<Problem>> {
        let (start, end) = (self.text_start, self.text_end?);
        let heading = self.heading?;
        let words = text[start.in_text..end.in_text].split_whitespace();
        if words.count() > MAX_WORDS {
            return Some(Err(ChapterError::LongProblem(MAX_WORDS)));
        }
        let bold_words = self.bold_start.zip(self.bold_end);
        let result =
            bold_words.map_or("", |(start, end)| &expanded[start.in_expanded..end.in_expanded]);
        Some(Ok(Problem {
            heading,
            text: expanded[start.in_expanded..end.in_expanded].trim().to_owned(),
            result: result.to_owned(),
        }))
    }
}

/// The Markdown for `{{#problem-sheet}}`: the problems of all chapters, each of which is a title
/// and problems, and then their answers without the way, which are what is bold in the chapter.
pub fn sheet_markdown(
    chapters: &[(String, Vec<Problem>)],
    values: &Values,
) -> ChapterResult<String> {
    let (mut problems, mut answers) = (String::new(), String::new());
    for (title, chapter) in chapters.iter().filter(|(_, problems)| !problems.is_empty()) {
        problems += &format!("## {}\n\n", title.trim_end_matches(": practice"));
        for Problem { heading, text, result, .. } in chapter {
            problems += &format!("{}\n{text}\n\n</section>\n\n", heading.html());
            let number = &heading.number;
            let link = format!("<a href=\"#problem-{number}\">{number}</a>");
            answers += &format!("<div class=\"answer\">{link}\n\n{result}\n\n</div>\n\n");
        }
    }
    let answer_box = folded_box::opening_html("answer", "to each problem", values).transpose()?;
    let answer_box = answer_box.unwrap_or_default();
    Ok(format!("{problems}## Answers {{#answers}}\n\n{answer_box}\n{answers}</details>\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heading_is_two_numbers() {
        let heading = Heading::parse("8 1,234").expect("a heading");
        assert_eq!(heading, Heading { number: "8".to_owned(), answer: "1,234".to_owned() });
        for words in ["", "7", "7 lens", "7 0.5 m"] {
            assert!(matches!(Heading::parse(words), Err(ChapterError::ProblemForm)), "{words}");
        }
    }

    #[test]
    fn whole_number_has_no_tolerance() {
        let html = |words| Heading::parse(words).expect("a heading").html();
        assert!(html("8 1,234").contains("data-answer=\"1234\" data-tolerance=\"0\""));
        assert!(html("7 0.5").contains("data-answer=\"0.5\" data-tolerance=\"0.01\""));
    }
}
