//! The items on a page that matter to a reader who types along: headings, listings and commands.

use builder::{ConsoleKind, Page};
use std::collections::BTreeMap;

/// The text of each file typed so far, keyed by path.
pub type TypedFiles<'a> = BTreeMap<&'a str, String>;

/// Joins all listings on these pages into files, as a reader does by typing them.
pub fn typed_files<'a>(pages: impl IntoIterator<Item = &'a Page>) -> TypedFiles<'a> {
    let mut typed = TypedFiles::new();
    for item in pages.into_iter().flat_map(headings_listings_and_commands) {
        if let PageItem::Listing(path, code) = item {
            *typed.entry(path).or_default() += &code;
        }
    }
    typed
}

/// An item on a page that matters to a reader who types along.
pub enum PageItem<'a> {
    Heading,
    /// A file's path, and the lines to append to the file.
    Listing(&'a str, String),
    /// A command to run in the reader's folder.
    Command(PageCommand),
}

/// A command on a page, with its output as the page shows it.
pub struct PageCommand {
    /// The page's name and an id, for messages. If the console with the command has no id, this is
    /// the nearest id above the console.
    pub location: String,
    /// The command line, for a shell.
    pub line: String,
    /// The exit code that the page promises, or 0 if the page mentions no exit code.
    pub exit_code: i32,
    /// The output, in which `…` stands for any text.
    pub output: String,
}

/// Returns the headings, listings and commands on a page, from top to bottom. Leaves out commands
/// that are meant for our own folder.
pub fn headings_listings_and_commands(page: &Page) -> Vec<PageItem<'_>> {
    let mut items = vec![];
    for element in &page.elements {
        let console = element.attr("data-folder").and_then(ConsoleKind::from_data_folder);
        let exit_code = match console {
            Some(ConsoleKind::Ours) => continue,
            // Invalid arguments make clap exit with 2. A failing test makes Cargo exit with 101.
            Some(ConsoleKind::Refused) => 2,
            Some(ConsoleKind::Fails) => 101,
            Some(ConsoleKind::Yours) | None => 0,
        };
        let code = || {
            page.descendants(element)
                .iter()
                .find(|descendant| descendant.tag == "code")
                .expect("the element contains a `code` element")
        };
        match (&*element.tag, element.attr("class")) {
            (_, Some("listing")) => {
                let path = element.attr("data-path").expect("a listing has a path");
                let code = code();
                // mdBook adds a final newline to code in any language except Rust.
                let is_rust = code.attr("class").is_some_and(|class| class.contains("rust"));
                let end = if is_rust { "\n" } else { "" };
                items.push(PageItem::Listing(path, page.text(code).to_owned() + end));
            }
            (_, Some("console")) => {
                let location = page.address_for_fault(element);
                for command in page.text(code()).split("$ ").skip(1) {
                    let (line, output) = command.split_once('\n').unwrap_or((command, ""));
                    items.push(PageItem::Command(PageCommand {
                        location: location.clone(),
                        line: line.to_owned(),
                        exit_code,
                        output: output.to_owned(),
                    }));
                }
            }
            ("h1" | "h2" | "h3", _) => items.push(PageItem::Heading),
            _ => {}
        }
    }
    items
}
