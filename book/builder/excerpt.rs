use crate::files::{CHAPTERS, joined};
use crate::markdown::escape;
use std::fs;
use std::path::Path;

/// All of a file, or the part of it that a chapter shows.
#[derive(Debug)]
pub struct Excerpt {
    /// The file, as seen from the root of the workspace.
    path: String,
    language: String,
    /// The lines it shows.
    lines: Vec<String>,
    /// The number of the first of them, from 1.
    first: usize,
    /// How many lines the file has.
    total: usize,
}

/// Reads what the include in a fence of `language` asks for, such as
/// `{{#include ../../steps/step02_sphere/src/sphere.rs:..impl Sphere}}`.
///
/// A path is relative to the chapters. A part begins and ends before the items whose
/// first lines begin so.
pub fn read(
    language: &str,
    content: &str,
    workspace: &Path,
) -> Result<Excerpt, String> {
    let target = content
        .trim()
        .strip_prefix("{{#include ")
        .and_then(|rest| rest.strip_suffix("}}"))
        .filter(|rest| !rest.contains(['\n', '{', '}']))
        .ok_or("a listing is one {{#include path}} and nothing else")?;
    let (target, part) = target.split_once(':').unwrap_or((target, ".."));
    let path = joined(CHAPTERS, target.trim());
    let text = fs::read_to_string(workspace.join(&path))
        .map_err(|_| format!("there is no file {target}"))?;
    let lines: Vec<&str> = text.lines().collect();
    let (from, to) = part.split_once("..").ok_or(format!(
        "a part is ..how its end begins, or how it begins.., not {part}"
    ))?;
    let first = if from.is_empty() { 0 } else { find(from, &lines, 0)? };
    let end =
        if to.is_empty() { lines.len() } else { find(to, &lines, first + 1)? };
    Ok(Excerpt {
        path,
        language: language.to_string(),
        lines: lines[first..end].iter().map(|line| line.to_string()).collect(),
        first: first + 1,
        total: lines.len(),
    })
}

/// The place of the first line, not before `from`, that begins with these words, or
/// that of the comments and attributes above it.
fn find(words: &str, lines: &[&str], from: usize) -> Result<usize, String> {
    let mut lines_from = lines.iter().skip(from);
    let mut at = from
        + lines_from
            .position(|line| line.trim_start().starts_with(words))
            .ok_or(format!("no line there begins with {words:?}"))?;
    while from < at && lines[at - 1].trim_start().starts_with(['#', '/']) {
        at -= 1;
    }
    Ok(at)
}

impl Excerpt {
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
        let lines = match (self.lines.len(), first == last) {
            (all, _) if all == total => String::new(),
            (_, true) => format!("line {first} of {total}"),
            _ => format!("lines {first}–{last} of {total}"),
        };
        let part = match &*lines {
            "" => String::new(),
            lines => format!(r#" <span class="part">{lines}</span>"#),
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
