//! What a page gives its reader to do, from top to bottom.

use super::listing::Listing;
use book::{Page, all, text};

/// What a program of the course exits with where it refuses an option.
pub const REFUSED: i32 = 2;

/// What `cargo test` exits with where a test fails.
pub const FAILED: i32 = 101;

/// One thing on a page.
#[derive(Debug)]
pub enum Event<'a> {
    /// A heading.
    Section,
    /// A listing, to be typed.
    Types(Listing<'a>),
    /// A command for the reader's own folder.
    Runs(Asked),
}

/// A command and what the page says it prints.
#[derive(Debug)]
pub struct Asked {
    /// Where on which page it stands.
    pub at: String,
    /// What is set for it alone, such as `A=b`, by name.
    pub settings: Vec<(String, String)>,
    /// Its words, the first of which is `cargo`.
    pub words: Vec<String>,
    /// What it ends with: 0 where it does what it should.
    pub code: i32,
    /// The lines that the page shows below it; `…` stands for anything.
    pub says: Vec<String>,
}

/// Everything on a page that a reader does, in order.
pub fn events(page: &Page) -> Vec<Event<'_>> {
    let mut events = vec![];
    for part in page.all("h1, h2, h3, .listing, .console") {
        match (part.attr("class"), part.attr("data-folder")) {
            (Some("listing"), _) => {
                events.push(Event::Types(Listing::of(page, part)));
            }
            (Some("console"), Some("ours")) => {}
            (Some("console"), whose) => {
                let code: String =
                    all(part, "code").into_iter().map(text).collect();
                let ends = match whose {
                    Some("yours refused") => REFUSED,
                    Some("yours fails") => FAILED,
                    _ => 0,
                };
                let commands = Asked::all(&page.at(part), &code, ends);
                events.extend(commands.into_iter().map(Event::Runs));
            }
            _ => events.push(Event::Section),
        }
    }
    events
}

impl Asked {
    fn all(at: &str, text: &str, code: i32) -> Vec<Self> {
        let mut commands: Vec<Self> = vec![];
        for line in text.lines() {
            match (line.strip_prefix("$ "), commands.last_mut()) {
                (Some(command), _) => {
                    let from = command.find("cargo").unwrap_or(0);
                    let (settings, words) = command.split_at(from);
                    let settings = settings.split_whitespace();
                    let settings = settings.filter_map(|one| one.split_once('='));
                    commands.push(Self {
                        at: at.to_owned(),
                        settings: settings
                            .map(|(name, value)| {
                                (name.to_owned(), value.to_owned())
                            })
                            .collect(),
                        words: words
                            .split_whitespace()
                            .map(str::to_owned)
                            .collect(),
                        code,
                        says: vec![],
                    });
                }
                (None, Some(last)) => last.says.push(line.to_owned()),
                (None, None) => {}
            }
        }
        commands
    }

    /// What follows an option such as `--example`.
    pub fn option(&self, name: &str) -> Option<&str> {
        let at = self.words.iter().position(|word| word == name)?;
        Some(self.words.get(at + 1)?)
    }

    /// The first line that it is said to print, and that is not in `text`, in order.
    pub fn unsaid(&self, text: &str) -> Option<&str> {
        let mut printed = text.lines();
        let is_said = |says: &&String| !printed.any(|line| fits(says, line));
        self.says.iter().find(is_said).map(String::as_str)
    }
}

/// Whether a line is what the page shows of it.
fn fits(says: &str, line: &str) -> bool {
    match says.split_once('…') {
        None => says == line,
        Some((begin, "")) => line.starts_with(begin),
        Some((begin, rest)) => line.strip_prefix(begin).is_some_and(|line| {
            line.char_indices().any(|(at, _)| fits(rest, &line[at..]))
        }),
    }
}
