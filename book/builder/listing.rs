use crate::caption::escape;
use crate::page::House;
use std::fs;

/// All of a file, or the part of it that a chapter shows.
#[derive(Debug)]
pub struct Listing {
    /// The file, as seen from the root of the workspace.
    path: String,
    language: String,
    /// The lines it shows.
    lines: Vec<String>,
    /// The number of the first of them, from 1.
    first: usize,
    /// How many lines the file has, those with an anchor left out.
    total: usize,
}

/// Says whether a fence holds an include.
pub fn is_include(content: &str) -> bool {
    content.trim_start().starts_with("{{#include")
}

/// Reads what the include in a fence of `language` asks for; a path is relative to
/// the chapters.
pub fn read(
    language: &str,
    content: &str,
    house: &House,
) -> Result<Listing, String> {
    let target = content
        .trim()
        .strip_prefix("{{#include ")
        .and_then(|rest| rest.strip_suffix("}}"))
        .filter(|rest| !rest.contains(['\n', '{', '}']))
        .ok_or("a listing is one {{#include path}} and nothing else")?;
    let (path, part) = match target.trim().split_once(':') {
        Some((path, part)) => (path, part),
        None => (target.trim(), ""),
    };
    let file = fs::canonicalize(house.chapters.join(path))
        .map_err(|_| format!("there is no file {path}"))?;
    let text =
        fs::read_to_string(&file).map_err(|error| format!("{path}: {error}"))?;
    let lines: Vec<&str> =
        text.lines().filter(|line| anchor(line).is_none()).collect();
    let (first, last) = match part {
        "" => (1, lines.len()),
        part if part.starts_with(|c: char| c.is_ascii_digit() || c == ':') => {
            range(part, &lines)?
        }
        name => {
            between(name, &text).ok_or(format!("{path} has no anchor {name}"))?
        }
    };
    if last < first || lines.len() < last {
        return Err(format!("{path} has {} lines, not {part}", lines.len()));
    }
    Ok(Listing {
        path: house.name(&file),
        language: language.to_string(),
        lines: lines[first - 1..last].iter().map(|line| line.to_string()).collect(),
        first,
        total: lines.len(),
    })
}

/// The first and the last line of `2:10`, `2:`, `:10` or `2`.
fn range(part: &str, lines: &[&str]) -> Result<(usize, usize), String> {
    let number = |text: &str, otherwise| match text {
        "" => Ok(otherwise),
        text => text
            .parse()
            .ok()
            .filter(|&n| 0 < n)
            .ok_or(format!("{text} is no line number")),
    };
    match part.split_once(':') {
        Some((first, last)) => Ok((number(first, 1)?, number(last, lines.len())?)),
        None => number(part, 1).map(|line| (line, line)),
    }
}

/// The first and the last line between `ANCHOR: name` and `ANCHOR_END: name`,
/// anchors not counted.
fn between(name: &str, text: &str) -> Option<(usize, usize)> {
    let mut count = 0;
    let mut first = None;
    for line in text.lines() {
        match anchor(line) {
            Some(("ANCHOR", found)) if found == name => first = Some(count + 1),
            Some(("ANCHOR_END", found)) if found == name => {
                return Some((first?, count));
            }
            Some(_) => {}
            None => count += 1,
        }
    }
    None
}

/// The kind and the name of the anchor on a line, if there is one.
fn anchor(line: &str) -> Option<(&'static str, &str)> {
    let comment = line.trim().trim_start_matches(['/', '#']).trim();
    let kinds = [("ANCHOR:", "ANCHOR"), ("ANCHOR_END:", "ANCHOR_END")];
    kinds
        .iter()
        .find_map(|(mark, kind)| Some((*kind, comment.strip_prefix(mark)?.trim())))
}

impl Listing {
    /// An id for links to it, such as `listing-step01_rays-src-ray.rs`.
    pub fn id(&self) -> String {
        format!("listing-{}", self.shown_path().replace('/', "-"))
    }

    /// The listing under a caption that says which file it is, and which lines of
    /// it.
    pub fn html(&self, id: Option<&str>) -> String {
        let (path, shown, total) = (&self.path, self.shown_path(), self.total);
        let (first, last) = (self.first, self.first + self.lines.len() - 1);
        let id = id.map_or(String::new(), |id| format!(r#" id="{id}""#));
        let (folder, file) = shown.rsplit_once('/').unwrap_or(("", shown));
        let slash = if folder.is_empty() { "" } else { "/" };
        let part = match (self.lines.len() == total, first == last) {
            (true, _) => String::new(),
            (_, true) => {
                format!(r#" <span class="part">line {first} of {total}</span>"#)
            }
            _ => format!(
                r#" <span class="part">lines {first}–{last} of {total}</span>"#
            ),
        };
        let code = self.lines.join("\n");
        let ticks = code.split(|c| c != '`').map(str::len).max().unwrap_or(0);
        let fence = "`".repeat(3.max(ticks + 1));
        format!(
            "<figure class=\"listing\"{id} data-path=\"{}\" data-lines=\"{first}-{last}\">\
             <figcaption><span class=\"path\">{}{slash}<b>{}</b></span>{part}</figcaption>\n\n\
             {fence}{}\n{code}\n{fence}\n\n</figure>\n",
            escape(path),
            escape(folder),
            escape(file),
            self.language,
        )
    }

    /// The path without the folder of all steps.
    fn shown_path(&self) -> &str {
        self.path.strip_prefix("steps/").unwrap_or(&self.path)
    }
}
