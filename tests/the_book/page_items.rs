//! What a reader who types along finds on a page.

use builder::Page;
use std::collections::BTreeMap;

/// The texts of the files that were typed so far, by path.
pub type TypedFiles<'a> = BTreeMap<&'a str, String>;

/// Types all listings of these pages, as a reader does.
pub fn typed_files<'a>(pages: impl IntoIterator<Item = &'a Page>) -> TypedFiles<'a> {
    let mut typed = TypedFiles::new();
    for item in pages.into_iter().flat_map(page_items) {
        if let PageItem::Listing(path, code) = item {
            *typed.entry(path).or_default() += &code;
        }
    }
    typed
}

/// A part of a page that a reader who types along acts on.
pub enum PageItem<'a> {
    Heading,
    /// The path of a file, and the lines to add at its end.
    Listing(&'a str, String),
    /// A command to run in the reader's folder.
    Command(PageCommand),
}

/// A command on a page, with its output as the page shows it.
pub struct PageCommand {
    /// The page, and the position on it.
    pub location: String,
    /// The command, for a shell.
    pub line: String,
    /// The exit code that the page promises, or 0 if it promises none.
    pub exit_code: i32,
    /// The output, in which `…` stands for any text.
    pub output: String,
}

/// The headings, listings and commands of a page, from top to bottom, except the commands for our
/// own folder.
pub fn page_items(page: &Page) -> Vec<PageItem<'_>> {
    let mut items = vec![];
    for element in &page.elements {
        let exit_code = match element.attr("data-folder") {
            Some("ours") => continue,
            // Invalid arguments, and a test that fails.
            Some("yours refused") => 2,
            Some("yours fails") => 101,
            _ => 0,
        };
        let code =
            || page.descendants(element).iter().find(|inner| inner.tag == "code").expect("code");
        match (&*element.tag, element.attr("class")) {
            (_, Some("listing")) => {
                let path = element.attr("data-path").expect("the path of a listing");
                let code = code();
                // mdBook ends the last line of code in any language except Rust.
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
