//! Algorithms in words, from code fences marked `algorithm`. A line may end with the name of a
//! step, such as `step 1`. That step implements the line.

use course::escape_html;

/// Returns the HTML of an algorithm. If a line ends with the name of a step, after at least two
/// spaces, this name gets its own element. On a narrow screen, the stylesheet puts that element on
/// the next line.
pub fn algorithm_html(text: &str) -> String {
    let lines = text.split_inclusive('\n').map(|line| match split_before_step_name(line) {
        Some((words, step)) => format!("{}<span>{}</span>", escape_html(words), escape_html(step)),
        None => escape_html(line),
    });
    format!("<pre class=\"algorithm\"><code>{}</code></pre>\n", lines.collect::<String>())
}

/// Splits a line that ends with the name of a step. The second part consists of that name and the
/// spaces before the name. Returns None for any other line.
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
