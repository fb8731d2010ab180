//! What a page gives its reader to do, from top to bottom.

use super::listing::Listing;
use book::{Element, Page};

/// One thing on a page.
#[derive(Debug)]
pub enum Event<'a> {
    /// A heading.
    Section,
    /// A listing, to be typed.
    Types(Listing<'a>),
    /// A command for the reader's own folder.
    Runs(Asked<'a>),
}

/// A command and what the page says it prints.
#[derive(Debug)]
pub struct Asked<'a> {
    /// The page it stands on, and the line of its block there.
    pub at: String,
    /// Its words, the first of which is `cargo`.
    pub words: Vec<&'a str>,
    /// Whether it is to be refused.
    pub is_refused: bool,
    /// The lines that the page shows below it; `…` stands for anything.
    pub says: Vec<&'a str>,
}

/// Everything on a page that a reader does, in order.
pub fn events(page: &Page) -> Vec<Event<'_>> {
    let mut events = vec![];
    for element in &page.elements {
        match element.tag.as_str() {
            "h1" | "h2" | "h3" => events.push(Event::Section),
            "code" => match console(page, element) {
                Some(whose @ ("yours" | "yours refused")) => {
                    let commands = Asked::all(page, element, whose != "yours");
                    events.extend(commands.into_iter().map(Event::Runs));
                }
                Some(_) => {}
                None => events.extend(Listing::of(page, element).map(Event::Types)),
            },
            _ => {}
        }
    }
    events
}

/// In whose folder the commands of a block are meant; none if it is no such block.
fn console<'a>(page: &'a Page, code: &Element) -> Option<&'a str> {
    let mut around = page.around(code);
    around.find(|e| e.is("figure", "console"))?.get("data-folder")
}

impl<'a> Asked<'a> {
    fn all(page: &Page, block: &'a Element, is_refused: bool) -> Vec<Self> {
        let mut commands: Vec<Self> = vec![];
        for line in block.text.lines() {
            let Some(command) = line.strip_prefix("$ ") else {
                if let Some(last) = commands.last_mut() {
                    last.says.push(line);
                }
                continue;
            };
            commands.push(Self {
                at: page.at(block),
                words: command.split_whitespace().collect(),
                is_refused,
                says: vec![],
            });
        }
        commands
    }

    /// What follows an option such as `--example`.
    pub fn option(&self, name: &str) -> Option<&'a str> {
        let at = self.words.iter().position(|word| *word == name)?;
        self.words.get(at + 1).copied()
    }

    /// The first line that it is said to print, and that is not in `text`, in order.
    pub fn unsaid(&self, text: &str) -> Option<&'a str> {
        let mut printed = text.lines();
        let is_said = |says: &&&str| !printed.any(|line| fits(says, line));
        self.says.iter().find(is_said).copied()
    }
}

/// Whether a line is what the page shows of it.
fn fits(says: &str, line: &str) -> bool {
    let mut rest = Some(line);
    for (k, part) in says.split('…').enumerate() {
        rest = rest.and_then(|rest| match k {
            0 => rest.strip_prefix(part),
            _ => rest.split_once(part).map(|(_, after)| after),
        });
    }
    rest.is_some_and(|rest| rest.is_empty() || says.ends_with('…'))
}

#[test]
fn an_ellipsis_stands_for_anything() {
    for (says, line) in [("a b", "a b"), ("a … d", "a b c d"), ("a …", "a b c")]
    {
        assert!(fits(says, line), "{says}");
    }
    for (says, line) in
        [("a b", "a b c"), ("b", "a b"), ("a … d", "a b c"), ("… b", "a")]
    {
        assert!(!fits(says, line), "{says}");
    }
}
