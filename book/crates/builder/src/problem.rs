use crate::fault::{ChapterError, ChapterResult};

/// The HTML for `{{#problem 7 0.622}}`, which begins the problem of this number and gives its
/// answer.
///
/// The problem's text follows, `{{#answer}}`, the way to the answer, and `{{#end}}`. What a
/// reader types in is compared by book/theme/book.js: a whole number exactly, any other
/// within 1 %.
pub fn opening_html(words: &str) -> ChapterResult<String> {
    let (number, answer) = words.split_once(' ').unwrap_or_default();
    let answer = answer.replace(',', "");
    if answer.parse::<f64>().is_err() {
        return Err(ChapterError::ProblemForm);
    }
    let tolerance = if answer.contains('.') { 0.01 } else { 0.0 };
    Ok(format!(
        "<section class=\"problem\" id=\"problem-{number}\" data-answer=\"{answer}\" \
         data-tolerance=\"{tolerance}\">\
         <b class=\"number\">{number}</b>\n"
    ))
}

/// The Markdown for `{{#problem-sheet}}`: the problems of all chapters, each a title and a
/// text, and then their answers without the way, which are what is bold in the chapter.
pub fn sheet_markdown<'a>(chapters: impl Iterator<Item = (&'a str, &'a str)>) -> String {
    let (mut problems, mut answers) = (String::new(), String::new());
    for (title, text) in chapters {
        let mut heading = Some(format!("## {}\n\n", title.trim_end_matches(": practice")));
        for part in text.split("\n{{#problem ").skip(1) {
            let Some((words, problem, answer)) = split(part) else {
                continue; // a fault of its chapter, and told there
            };
            let opening = opening_html(words).unwrap_or_default();
            problems += &heading.take().unwrap_or_default();
            problems += &format!("{opening}\n{}\n\n</section>\n\n", problem.trim());
            let number = words.split(' ').next().unwrap_or_default();
            let answer = answer.split("**").nth(1).unwrap_or_default();
            let link = format!("<a href=\"#problem-{number}\">{number}</a>");
            answers += &format!("<div class=\"answer\">{link}\n\n**{answer}**\n\n</div>\n\n");
        }
    }
    format!(
        "{problems}## Answers {{#answers}}\n\n\
         {{{{#answer to each problem}}}}\n\n{answers}{{{{#end}}}}\n"
    )
}

/// The words of a directive, the text of the problem, and the way to its answer.
pub fn split(part: &str) -> Option<(&str, &str, &str)> {
    let (words, box_text) = part.split_once("}}")?;
    let (problem, answer_text) = box_text.split_once("\n{{#answer}}")?;
    let (answer, _) = answer_text.split_once("\n{{#end}}")?;
    Some((words, problem, answer))
}
