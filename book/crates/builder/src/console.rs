//! Consoles: commands for the reader to type. Commands for our folder get a caption that says so.

use crate::fault::{ChapterError, ChapterResult};
use crate::markdown::html_block;
use course::escape_html;

/// The kinds of consoles. Kinds differ in the folder that the commands are for, and in whether the
/// commands succeed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConsoleKind {
    /// The commands are for our folder.
    Ours,
    /// The commands are for the reader's folder, and succeed.
    Yours,
    /// The commands are for the reader's folder, and the program refuses its arguments.
    Refused,
    /// The commands are for the reader's folder, and a test fails.
    Fails,
}

impl ConsoleKind {
    const ALL: [Self; 4] = [Self::Ours, Self::Yours, Self::Refused, Self::Fails];

    /// The words after `console,` in a fence of this kind.
    fn words_after_console(self) -> &'static str {
        match self {
            Self::Ours => "ours",
            Self::Yours => "yours",
            Self::Refused => "yours,refused",
            Self::Fails => "yours,fails",
        }
    }

    /// The value of the attribute `data-folder` on a page.
    fn data_folder(self) -> String {
        self.words_after_console().replace(',', " ")
    }

    /// Finds the kind with this value of `data-folder`.
    pub fn from_data_folder(data_folder: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.data_folder() == data_folder)
    }
}

/// Returns the Markdown of a console. `words_after_console`, from the code fence, say which kind of console
/// it is. Only commands for our folder get a caption. All other commands are for the reader's
/// folder, and it is enough that step 1 says so.
pub fn console_markdown(words_after_console: &str, commands: &str) -> ChapterResult<String> {
    let kind = ConsoleKind::ALL
        .into_iter()
        .find(|kind| kind.words_after_console() == words_after_console)
        .ok_or(ChapterError::ConsoleForm)?;
    let caption = match kind {
        ConsoleKind::Ours => {
            "<figcaption>in <a href=\"how.html#two-folders\">our folder</a></figcaption>"
        }
        ConsoleKind::Yours | ConsoleKind::Refused | ConsoleKind::Fails => "",
    };
    let folder = kind.data_folder();
    // The prompt gets its own element, so that the stylesheet can keep the prompt from being
    // copied.
    let commands = format!("\n{}", escape_html(commands)).replace("\n$ ", "\n<span>$ </span>");
    let opening = format!(
        "<figure class=\"console\" aria-label=\"Commands\" data-folder=\"{folder}\">{caption}"
    );
    // In Markdown, a block of HTML may contain blank lines if it begins with `<pre>`.
    let block = format!("<pre><code>{}</code></pre>", commands.trim_start());
    Ok([&opening, &block, "</figure>"].map(html_block).concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_prompt_has_its_own_element() {
        let html = console_markdown("yours", "$ a > b\n$ c").expect("the fence words are valid");
        assert!(html.contains("<code><span>$ </span>a &gt; b\n<span>$ </span>c</code>"), "{html}");
    }

    #[test]
    fn only_commands_for_our_folder_have_a_caption() {
        for (words, has_caption) in [("ours", true), ("yours", false), ("yours,fails", false)] {
            let html = console_markdown(words, "$ a").expect("the fence words are valid");
            assert_eq!(html.contains("our folder</a></figcaption>"), has_caption, "{html}");
            assert_eq!(html.contains("figcaption"), has_caption, "{html}");
        }
    }

    #[test]
    fn console_kind_is_kept_in_data_folder_and_unknown_words_are_an_error() {
        let html = console_markdown("yours,fails", "$ a").expect("the fence words are valid");
        assert!(html.contains("data-folder=\"yours fails\""), "{html}");
        assert_eq!(ConsoleKind::from_data_folder("yours fails"), Some(ConsoleKind::Fails));
        assert!(matches!(console_markdown("theirs", "$ a"), Err(ChapterError::ConsoleForm)));
    }
}
