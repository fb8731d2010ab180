//! Commands for the reader to type, with a caption that says in which folder.

use crate::fault::{ChapterError, ChapterResult};
use crate::markdown::html_block;
use figures::escape;

/// Returns commands under a caption that says in which folder to type them, the reader's or ours.
pub fn console_markdown(folder: &str, commands: &str) -> ChapterResult<String> {
    let caption = match folder {
        "yours" | "yours,refused" | "yours,fails" => "in your folder",
        "ours" => "in <a href=\"how.html#two-folders\">our folder</a>",
        _ => return Err(ChapterError::ConsoleForm),
    };
    let folder = folder.replace(',', " ");
    // The prompt gets its own element, so that the stylesheet can keep it from being copied.
    let commands = format!("\n{}", escape(commands)).replace("\n$ ", "\n<span>$ </span>");
    let caption = format!(
        "<figure class=\"console\" data-folder=\"{folder}\"><figcaption>{caption}</figcaption>"
    );
    // As a block of its own, it may contain blank lines.
    let commands = format!("<pre><code>{}</code></pre>", commands.trim_start());
    Ok([&caption, &commands, "</figure>"].map(html_block).concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prompt_is_marked_in_each_line() {
        let html = console_markdown("yours", "$ a > b\n$ c").expect("a console");
        assert!(html.contains("<code><span>$ </span>a &gt; b\n<span>$ </span>c</code>"), "{html}");
        assert!(html.contains("in your folder"));
    }

    #[test]
    fn folder_is_ours_or_yours() {
        let html = console_markdown("yours,fails", "$ a").expect("a console");
        assert!(html.contains("data-folder=\"yours fails\""), "{html}");
        assert!(matches!(console_markdown("theirs", "$ a"), Err(ChapterError::ConsoleForm)));
    }
}
