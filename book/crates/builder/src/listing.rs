//! Listings: code from a file, with a caption, marks for new lines, and the places that a reader
//! may edit.

use crate::Sources;
use crate::fault::{ChapterError, ChapterResult};
use crate::files::{CHAPTERS, resolve_path};
use course::{Place, Step};
use figures::{escape, find};
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::sync::LazyLock;

/// The attribute of a listing in which a reader may edit something.
pub const PLACES_ATTRIBUTE: &str = "data-places";

static PLACES: LazyLock<Vec<Place>> = LazyLock::new(course::all_listed_places);

/// The listing for `{{#include path}}`, or for a part of a file, such as
/// `{{#include ../../steps/step02_sphere/src/sphere.rs:..impl Sphere}}`. The caption names the file
/// and says whether a part is its beginning or is added below.
///
/// The path is relative to the chapters. Files in `book/reader` and `book/typed` are captioned as
/// files of the reader's own folder. The first listing of a file on a page gets an id for links,
/// such as `listing-step01_rays-src-ray.rs`; `ids` collects them.
///
/// In a fence `rust,own_scene`, `live` is `own_scene`, and the page replaces the code with the
/// number `rust` of that figure whenever the figure changes. In a fence `rust`, `live` is empty.
pub fn html(
    language: &str,
    live: &str,
    include: &str,
    sources: &Sources,
    ids: &mut Vec<String>,
) -> ChapterResult<String> {
    let (target, part) = include.split_once(':').unwrap_or((include, ".."));
    let path = resolve_path(CHAPTERS, target.trim());
    let text = fs::read_to_string(sources.workspace.join(&path))
        .map_err(|source| ChapterError::UnreadableFile { path: target.to_owned(), source })?;
    let folders = ["book/reader/", "book/typed/"];
    let path = folders.iter().find_map(|folder| path.strip_prefix(folder)).unwrap_or(&path);
    let lines: Vec<&str> = text.lines().collect();
    let range = part_lines(part, &lines)?;
    let part = match (range.start, range.len() == lines.len()) {
        (_, true) => "",
        (0, _) => r#" <span class="part">its beginning</span>"#,
        _ => r#" <span class="part">add below</span>"#,
    };
    let code = lines[range].join("\n");
    let old = file_of_step_before(path, &sources.workspace);
    let changed = old.and_then(|old| changed_lines_style(&code, &old)).unwrap_or_default();
    let mut attributes = places_attribute(path, &code);
    if !live.is_empty() {
        let scene = find(live).and_then(|figure| figure.editable_scene.as_ref());
        scene.ok_or_else(|| ChapterError::UnknownProgram(live.to_owned()))?;
        attributes += &format!(" data-code=\"{live}\"");
    }
    Ok(figure_markdown(path, &attributes, part, &changed, (language, &code), ids))
}

/// The text of the file of the same name in the nearest earlier step that has one.
fn file_of_step_before(path: &str, workspace: &Path) -> Option<String> {
    let (step, file) = path.strip_prefix("steps/")?.split_once('/')?;
    let mut earlier_names = Step::NAMES.into_iter().rev().skip_while(|name| *name != step).skip(1);
    earlier_names
        .find_map(|name| fs::read_to_string(workspace.join("steps").join(name).join(file)).ok())
}

/// The style that paints a bar beside each line of the code that isn't in the `old` text. Returns
/// None if more than half of the lines are new.
fn changed_lines_style(code: &str, old: &str) -> Option<String> {
    let is_new = |line: &str| !old.lines().any(|known| known == line);
    let new: Vec<_> = code.lines().enumerate().filter(|(_, line)| is_new(line)).collect();
    let bars = new.iter().map(|(k, _)| {
        format!(
            "linear-gradient(var(--accent), var(--accent)) 0 calc({k} * 1lh) / 3px 1lh no-repeat"
        )
    });
    let bars = bars.collect::<Vec<_>>().join(", ");
    (2 * new.len() <= code.lines().count()).then(|| format!("; --changed: {bars}"))
}

/// The attribute that says where a reader may edit the code. For each place, it has the name, and
/// the start and length in UTF-16 code units, as JavaScript counts. See book/theme/line_editor.js.
fn places_attribute(path: &str, code: &str) -> String {
    let letters = |text: &str| text.encode_utf16().count();
    let file = path.strip_prefix("steps/");
    let places = PLACES.iter().filter(|place| file == Some(place.file));
    let entries = places.filter_map(|place| {
        let range = place.find_range(code).ok()?;
        let (start, length) = (letters(&code[..range.start]), letters(&code[range]));
        Some(format!("{}:{start}:{length}", place.name))
    });
    match entries.collect::<Vec<_>>().join(" ") {
        none if none.is_empty() => none,
        places => format!(" {PLACES_ATTRIBUTE}=\"{places}\""),
    }
}

/// The Markdown of a listing. `part` is the HTML that says which part of the file at `path` it
/// shows, and `changed` is the style that marks the new lines.
fn figure_markdown(
    path: &str,
    attributes: &str,
    part: &str,
    changed: &str,
    (language, code): (&str, &str),
    ids: &mut Vec<String>,
) -> String {
    let short_path = path.strip_prefix("steps/").unwrap_or(path);
    let name_start = short_path.rfind('/').map_or(0, |name_start| name_start + 1);
    let (folder, file) = (escape(&short_path[..name_start]), escape(&short_path[name_start..]));
    let new = Some(format!("listing-{}", short_path.replace('/', "-")));
    let new = new.filter(|id| !ids.contains(id));
    ids.extend(new.clone());
    let id = new.map_or(String::new(), |id| format!(r#" id="{id}""#));
    format!(
        "<figure class=\"listing\"{id} data-path=\"{}\"{attributes} style=\"--lines: {}{changed}\">\
         <figcaption><span class=\"path\">{folder}<b>{file}</b></span>{part}</figcaption>\n\n\
         ```{language}\n{code}\n```\n\n</figure>\n",
        escape(path),
        code.split('\n').count(),
    )
}

/// The lines of a part such as `use..impl Ray`: from the item that begins with the first words up
/// to, but not including, the item that begins with the last. Either may be empty.
fn part_lines(part: &str, lines: &[&str]) -> ChapterResult<Range<usize>> {
    let (begin_words, end_words) =
        part.split_once("..").ok_or_else(|| ChapterError::PartForm(part.to_owned()))?;
    let start = find_line_or_attributes(begin_words, lines, 0)?;
    let end = match end_words {
        "" => lines.len(),
        words => find_line_or_attributes(words, lines, start + 1)?,
    };
    Ok(start..end)
}

/// The index of the first line from `start` on that begins with these words. If there are comments
/// and attributes directly above it, the index of the first of those.
fn find_line_or_attributes(words: &str, lines: &[&str], start: usize) -> ChapterResult<usize> {
    let has_words = |k: &usize| lines[*k].trim_start().starts_with(words);
    let index = (start..lines.len()).find(has_words);
    let index = index.ok_or_else(|| ChapterError::UnknownLine(words.to_owned()))?;
    let lines_above = lines[start..index].iter().rev();
    let is_about_it = |line: &&&str| line.trim_start().starts_with(['#', '/']);
    Ok(index - lines_above.take_while(is_about_it).count())
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINES: [&str; 6] = ["use a;", "", "/// A b.", "struct B {", "}", "impl B {}"];

    #[test]
    fn part_begins_and_ends_before_the_comments_of_a_line() {
        for (part, lines) in
            [("..", 0..6), ("..struct", 0..2), ("struct..", 2..6), ("struct..impl", 2..5)]
        {
            assert_eq!(part_lines(part, &LINES).expect(part), lines, "{part}");
        }
    }

    #[test]
    fn part_that_is_not_there_is_an_error() {
        assert!(matches!(part_lines("1:2", &LINES), Err(ChapterError::PartForm(_))));
        for part in ["..enum", "impl..struct"] {
            assert!(
                matches!(part_lines(part, &LINES), Err(ChapterError::UnknownLine(_))),
                "{part}"
            );
        }
    }

    #[test]
    fn new_lines_are_marked_unless_they_are_more_than_half() {
        let style = changed_lines_style("a\nb", "b\nc").expect("a style");
        assert!(style.contains("calc(0 * 1lh)") && !style.contains("calc(1 * 1lh)"), "{style}");
        assert_eq!(changed_lines_style("a\nb", "c"), None);
    }
}
