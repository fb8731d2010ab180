use super::listing::Listing;
use builder::{Page, inner_text, select_all};

/// The exit code of a program that rejects its arguments.
pub const INVALID_ARGUMENT_EXIT_CODE: i32 = 2;

/// The exit code of `cargo test` when a test fails.
pub const FAILED_TEST_EXIT_CODE: i32 = 101;

/// Something on a page that matters to a reader who types along.
#[derive(Debug)]
pub enum PageItem<'a> {
    Heading,
    Listing(Listing<'a>),
    /// A command, to run in the reader's folder.
    Command(PageCommand),
}

/// A command on a page, with its output as the page shows it.
#[derive(Debug)]
pub struct PageCommand {
    /// The page, and the place on it.
    pub location: String,
    /// The environment variables that are set for it, as `A=b` in front of it.
    pub environment: Vec<(String, String)>,
    /// The words of the command, with `cargo` as the first.
    pub arguments: Vec<String>,
    /// The exit code that the page promises, 0 where it promises none.
    pub exit_code: i32,
    /// The lines of output on the page, in which `…` stands for any text.
    pub expected_output: Vec<String>,
}

/// The headings, listings and commands of a page, from top to bottom, but for the commands
/// for a folder of the course itself.
pub fn page_items(page: &Page) -> Vec<PageItem<'_>> {
    let mut items = vec![];
    for element in page.select_all("h1, h2, h3, .listing, .console") {
        match (element.attr("class"), element.attr("data-folder")) {
            (Some("listing"), _) => {
                items.push(PageItem::Listing(Listing::from_figure(page, element)));
            }
            (Some("console"), Some("ours")) => {}
            (Some("console"), folder) => {
                let code: String =
                    select_all(element, "code").into_iter().map(inner_text).collect();
                let exit_code = match folder {
                    Some("yours refused") => INVALID_ARGUMENT_EXIT_CODE,
                    Some("yours fails") => FAILED_TEST_EXIT_CODE,
                    _ => 0,
                };
                let commands = parse_commands(&page.address_for_fault(element), &code, exit_code);
                items.extend(commands.into_iter().map(PageItem::Command));
            }
            _ => items.push(PageItem::Heading),
        }
    }
    items
}

/// Parses the text of a console: commands, each after `$ `, and the output below them.
fn parse_commands(location: &str, console: &str, exit_code: i32) -> Vec<PageCommand> {
    let mut commands: Vec<PageCommand> = vec![];
    for line in console.lines() {
        if let Some(command) = line.strip_prefix("$ ") {
            let (environment, arguments) = command.split_at(command.find("cargo").unwrap_or(0));
            let variables = environment.split_whitespace();
            let variables = variables.filter_map(|word| word.split_once('='));
            let variables = variables.map(|(name, value)| (name.to_owned(), value.to_owned()));
            let arguments = arguments.split_whitespace().map(str::to_owned);
            commands.push(PageCommand {
                location: location.to_owned(),
                environment: variables.collect(),
                arguments: arguments.collect(),
                exit_code,
                expected_output: vec![],
            });
        } else if let Some(command) = commands.last_mut() {
            command.expected_output.push(line.to_owned());
        }
    }
    commands
}

impl PageCommand {
    /// The argument after an option such as `--example`.
    pub fn option_value(&self, option: &str) -> Option<&str> {
        let index = self.arguments.iter().position(|word| word == option)?;
        Some(self.arguments.get(index + 1)?)
    }

    /// The first line of the expected output that `output` does not have after the lines
    /// before it.
    pub fn first_missing_line(&self, output: &str) -> Option<&str> {
        let mut lines = output.lines();
        let is_missing = |pattern: &&String| !lines.any(|line| matches_pattern(line, pattern));
        self.expected_output.iter().find(is_missing).map(String::as_str)
    }
}

/// Whether a line is equal to a pattern, in which `…` stands for any text.
fn matches_pattern(line: &str, pattern: &str) -> bool {
    match pattern.split_once('…') {
        None => line == pattern,
        Some((start, "")) => line.starts_with(start),
        Some((start, end)) => line
            .strip_prefix(start)
            .is_some_and(|line| line.char_indices().any(|(i, _)| matches_pattern(&line[i..], end))),
    }
}
