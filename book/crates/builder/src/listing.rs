//! Listings: code from a file, with a caption. New lines are marked, and so are the places that a
//! reader may edit.

use crate::Sources;
use crate::fault::{ChapterError, ChapterResult};
use crate::files::{CHAPTERS, resolve_path};
use crate::markdown::{html_block, with_break_hints};
use course::{Place, Step, escape_html};
use figures::find_figure;
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::sync::LazyLock;

static PLACES: LazyLock<Vec<Place>> = LazyLock::new(course::all_listed_places);

/// A listing as Markdown.
#[derive(Debug)]
pub struct ExpandedListing {
    pub markdown: String,
    /// Whether the listing has places that a reader may edit.
    pub has_places: bool,
}

/// Returns the listing for `{{#include path}}`. After the path, the directive may name a part of
/// the file, as in `{{#include ../../steps/step02_sphere/src/sphere.rs:..impl Sphere}}`. The
/// caption names the file. If the listing shows a part, the caption also says which part: the
/// beginning of the file, or code to add below the code that has been typed so far.
///
/// The path is relative to the chapters. A file in `book/reader` or `book/typed` is for the
/// reader's own folder, so its caption leaves out `book/reader/` or `book/typed/`. On each page,
/// the first listing of a file gets an id for links, such as `listing-step01_rays-src-ray.rs`. This
/// id is added to `ids`.
///
/// In a fence `rust,own_scene`, `scene` is `own_scene`, the name of an editable scene. Once the
/// reader changes that scene, the page shows the scene's program in place of the file. In a fence
/// `rust`, `scene` is empty.
pub fn expand_listing(
    language: &str,
    scene: &str,
    include: &str,
    sources: &Sources,
    ids: &mut Vec<String>,
) -> ChapterResult<ExpandedListing> {
    let (target, part) = include.split_once(':').unwrap_or((include, ".."));
    let path = resolve_path(CHAPTERS, target.trim());
    let text = fs::read_to_string(sources.workspace.join(&path))
        .map_err(|source| ChapterError::UnreadableFile { path: target.to_owned(), source })?;
    let folders = ["book/reader/", "book/typed/"];
    let path = folders.iter().find_map(|folder| path.strip_prefix(folder)).unwrap_or(&path);
    let lines: Vec<&str> = text.lines().collect();
    let range = part_lines(part, &lines)?;
    let extent = Extent::new(&range, lines.len());
    let is_below_blank = range.start > 0 && lines[range.start - 1].is_empty();
    let code = lines[range].join("\n");
    let scene = Some(scene).filter(|scene| !scene.is_empty());
    if let Some(name) = scene
        && find_figure(name).is_none_or(|figure| figure.editable_scene.is_none())
    {
        return Err(ChapterError::UnknownEditableScene(name.to_owned()));
    }
    let new_lines = read_file_of_nearest_earlier_step(path, &sources.workspace)
        .map_or(vec![], |old| new_lines(&code, &old));
    let places = places_list(path, &code);
    let listing =
        Listing { path, language, code: &code, extent, is_below_blank, new_lines, places, scene };
    Ok(ExpandedListing { markdown: listing.markdown(ids), has_places: listing.places.is_some() })
}

/// A listing on a page.
struct Listing<'a> {
    path: &'a str,
    language: &'a str,
    code: &'a str,
    extent: Extent,
    /// Whether the line above the code, in the file, is blank.
    is_below_blank: bool,
    /// The indices of the new lines: the lines that don't occur in the file of the same name in an
    /// earlier step.
    new_lines: Vec<usize>,
    /// The places in the code that a reader may edit, as `places_list` lists them.
    places: Option<String>,
    /// The name of an editable scene. Once a reader changes this scene, the page shows the scene's
    /// program in place of the code.
    scene: Option<&'a str>,
}

/// Which part of its file a listing shows.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Extent {
    WholeFile,
    Beginning,
    LaterPart,
}

impl Extent {
    fn new(lines: &Range<usize>, line_count: usize) -> Self {
        match lines.start {
            0 if lines.end == line_count => Self::WholeFile,
            0 => Self::Beginning,
            _ => Self::LaterPart,
        }
    }

    /// What the caption says about this part.
    fn caption(self) -> Option<&'static str> {
        match self {
            Self::WholeFile => None,
            Self::Beginning => Some("its beginning"),
            Self::LaterPart => Some("add below"),
        }
    }
}

/// On paper, a listing with at most this number of lines isn't split between two pages.
const MAX_UNSPLIT_LINES: usize = 25;

impl Listing<'_> {
    /// Returns a figure that consists of a caption and the code in a fence. If the listing's id
    /// isn't in `ids`, adds the id to `ids`.
    fn markdown(&self, ids: &mut Vec<String>) -> String {
        let Self { path, language, code, .. } = self;
        let short_path = path.strip_prefix("steps/").unwrap_or(path);
        let name_start = short_path.rfind('/').map_or(0, |slash| slash + 1);
        let (folder, file) = short_path.split_at(name_start);
        let [folder, file] = [folder, file].map(|name| with_break_hints(&escape_html(name)));
        let part = self.extent.caption();
        let part =
            part.map_or(String::new(), |part| format!(r#" <span class="part">{part}</span>"#));
        let caption = format!(
            "<figure class=\"listing\"{} style=\"{}\">\
             <figcaption><span class=\"path\">{folder}<b>{file}</b></span>{part}</figcaption>",
            self.attributes(ids),
            self.style(),
        );
        let fence = format!("```{language}\n{code}\n```\n");
        html_block(&caption) + &fence + &html_block("</figure>")
    }

    /// Returns the HTML attributes of the figure. If the listing's id isn't in `ids`, adds the id
    /// to `ids` and to the attributes.
    fn attributes(&self, ids: &mut Vec<String>) -> String {
        let short_path = self.path.strip_prefix("steps/").unwrap_or(self.path);
        let mut attributes = vec![];
        let id = format!("listing-{}", short_path.replace('/', "-"));
        if !ids.contains(&id) {
            attributes.push(("id", id.clone()));
            ids.push(id);
        }
        attributes.push(("data-path", escape_html(self.path)));
        // The stylesheet for paper doesn't split a listing that has this attribute.
        if self.code.lines().count() <= MAX_UNSPLIT_LINES {
            attributes.push(("data-short", String::new()));
        }
        // If the listing has this attribute, the copy button puts a blank line above the copied
        // code.
        if self.is_below_blank {
            attributes.push(("data-below-blank", String::new()));
        }
        attributes.extend(self.places.iter().map(|places| ("data-places", places.clone())));
        attributes.extend(self.scene.map(|scene| ("data-code", scene.to_owned())));
        let attributes = attributes.iter().map(|(name, value)| format!(" {name}=\"{value}\""));
        attributes.collect()
    }

    /// The CSS variables of the listing: `--lines` is the number of lines, and `--changed` is a
    /// background that draws a bar beside each new line. If more than half of the lines are new, no
    /// bars are drawn.
    fn style(&self) -> String {
        let mut style = format!("--lines: {}", self.code.split('\n').count());
        let are_few = 2 * self.new_lines.len() <= self.code.lines().count();
        if are_few && !self.new_lines.is_empty() {
            let bars = self.new_lines.iter().map(|k| {
                format!(
                    "linear-gradient(var(--accent), var(--accent)) 0 calc({k} * 1lh) / 3px 1lh \
                     no-repeat"
                )
            });
            style += &format!("; --changed: {}", bars.collect::<Vec<_>>().join(", "));
        }
        style
    }
}

/// Reads the file of the same name in the nearest earlier step that has such a file.
fn read_file_of_nearest_earlier_step(path: &str, workspace: &Path) -> Option<String> {
    let (step, file) = path.strip_prefix("steps/")?.split_once('/')?;
    let mut earlier_names = Step::NAMES.into_iter().rev().skip_while(|name| *name != step).skip(1);
    earlier_names
        .find_map(|name| fs::read_to_string(workspace.join("steps").join(name).join(file)).ok())
}

/// The indices of the lines of `code` that don't occur in `old`.
fn new_lines(code: &str, old: &str) -> Vec<usize> {
    let is_new = |line: &str| !old.lines().any(|old_line| old_line == line);
    let lines = code.lines().enumerate().filter(|(_, line)| is_new(line));
    lines.map(|(k, _)| k).collect()
}

/// Lists the places in the code that a reader may edit, for book/theme/line_editor.js. An entry
/// consists of the name, the start and the length of a place. The start and the length are counted
/// in UTF-16 code units, as in JavaScript. Returns None if the code has no places.
fn places_list(path: &str, code: &str) -> Option<String> {
    let code_units = |text: &str| text.encode_utf16().count();
    let file = path.strip_prefix("steps/")?;
    let entries = PLACES.iter().filter(|place| place.file == file).filter_map(|place| {
        let range = place.find_range(code).ok()?;
        let (start, length) = (code_units(&code[..range.start]), code_units(&code[range]));
        Some(format!("{}:{start}:{length}", place.name))
    });
    let entries: Vec<_> = entries.collect();
    (!entries.is_empty()).then(|| entries.join(" "))
}

/// Returns the range of lines of a part such as `use..impl Ray`. The part begins at the first line
/// that begins with `use`, and ends before the next line that begins with `impl Ray`. Comments and
/// attributes directly above either of these lines belong to that line. If there are no words
/// before `..`, the part begins at the top of the file. If there are no words after `..`, the part
/// ends at the bottom of the file.
fn part_lines(part: &str, lines: &[&str]) -> ChapterResult<Range<usize>> {
    let (begin_words, end_words) =
        part.split_once("..").ok_or_else(|| ChapterError::PartForm(part.to_owned()))?;
    let start = find_item_start(begin_words, lines, 0)?;
    let end = match end_words {
        "" => lines.len(),
        words => find_item_start(words, lines, start + 1)?,
    };
    Ok(start..end)
}

/// Finds the first line, from `start` on, that begins with these words. Returns the index of this
/// line. If there are comments or attributes directly above this line, returns the index of the
/// first of them.
fn find_item_start(words: &str, lines: &[&str], start: usize) -> ChapterResult<usize> {
    let has_words = |k: &usize| lines[*k].trim_start().starts_with(words);
    let index = (start..lines.len())
        .find(has_words)
        .ok_or_else(|| ChapterError::UnknownLine(words.to_owned()))?;
    let lines_above = lines[start..index].iter().rev();
    let is_comment_or_attribute = |line: &&&str| line.trim_start().starts_with(['#', '/']);
    Ok(index - lines_above.take_while(is_comment_or_attribute).count())
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINES: [&str; 6] = ["use a;", "", "/// A b.", "struct B {", "}", "impl B {}"];

    #[test]
    fn part_begins_and_ends_before_the_comments_above_a_line() {
        for (part, lines) in
            [("..", 0..6), ("..struct", 0..2), ("struct..", 2..6), ("struct..impl", 2..5)]
        {
            assert_eq!(part_lines(part, &LINES).expect(part), lines, "{part}");
        }
    }

    #[test]
    fn missing_part_of_a_file_is_an_error() {
        assert!(matches!(part_lines("1:2", &LINES), Err(ChapterError::PartForm(_))));
        for part in ["..enum", "impl..struct"] {
            assert!(
                matches!(part_lines(part, &LINES), Err(ChapterError::UnknownLine(_))),
                "{part}"
            );
        }
    }

    fn listing(code: &str, new_lines: Vec<usize>) -> Listing<'_> {
        let path = "steps/step02_sphere/src/sphere.rs";
        let extent = Extent::Beginning;
        Listing {
            path,
            language: "rust",
            code,
            extent,
            is_below_blank: false,
            new_lines,
            places: None,
            scene: None,
        }
    }

    #[test]
    fn new_lines_are_those_missing_from_the_old_code() {
        assert_eq!(new_lines("a\nb\nc", "c\na"), [1]);
    }

    #[test]
    fn new_lines_are_marked_unless_they_are_more_than_half() {
        let style = listing("a\nb", vec![1]).style();
        assert!(style.starts_with("--lines: 2; --changed: ") && style.contains("calc(1 * 1lh)"));
        assert_eq!(listing("a\nb", vec![0, 1]).style(), "--lines: 2");
        assert_eq!(listing("a\nb", vec![]).style(), "--lines: 2");
    }

    #[test]
    fn caption_says_which_part_of_the_file_is_shown() {
        for (lines, words) in
            [(0..6, None), (0..2, Some("its beginning")), (2..6, Some("add below"))]
        {
            assert_eq!(Extent::new(&lines, 6).caption(), words, "{lines:?}");
        }
    }

    #[test]
    fn only_code_with_a_place_has_a_list_of_places() {
        let place = &PLACES[0];
        let path = format!("steps/{}", place.file);
        let list = places_list(&path, &format!("let π = {};", place.code));
        let length = place.code.encode_utf16().count();
        assert_eq!(list, Some(format!("{}:8:{length}", place.name)));
        assert_eq!(places_list(&path, "let x = 1;"), None);
        assert_eq!(places_list("Cargo.toml", place.code), None);
    }

    #[test]
    fn only_the_first_listing_of_a_file_has_an_id() {
        let mut ids = vec![];
        let listing = listing("a", vec![]);
        assert!(listing.markdown(&mut ids).contains(" id=\"listing-step02_sphere-src-sphere.rs\""));
        assert!(!listing.markdown(&mut ids).contains(" id="));
    }
}
