//! An algorithm in words: the content of a fence `algorithm`. Some of its lines end with the step
//! that implements them, such as `step 1`.

use course::escape_html;

/// The HTML of an algorithm. The name of a step, which is set off by at least two spaces, gets an
/// element of its own, so that the style can put it below its line on a narrow screen.
pub fn algorithm_html(text: &str) -> String {
    let lines = text.split_inclusive('\n').map(|line| match split_before_step_name(line) {
        Some((words, step)) => format!("{}<span>{}</span>", escape_html(words), escape_html(step)),
        None => escape_html(line),
    });
    format!("<pre class=\"algorithm\"><code>{}</code></pre>\n", lines.collect::<String>())
}

/// Splits a line in front of the spaces that set off the name of a step. Returns None if the line
/// doesn't end with such a name.
fn split_before_step_name(line: &str) -> Option<(&str, &str)> {
    let (words, _) = line.rsplit_once("  ")?;
    let words = words.trim_end();
    words.contains(char::is_alphabetic).then(|| line.split_at(words.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn step_name_and_line_break_are_wrapped_in_a_span() {
        assert_eq!(
            algorithm_html("●  a & b    step 1\n       else\n"),
            "<pre class=\"algorithm\"><code>●  a &amp; b<span>    step 1\n</span>       else\n\
             </code></pre>\n"
        );
    }
}
