//! The expansion of a chapter: every directive, formula and listing becomes HTML.

use crate::directive::{Directive, replace_directives};
use crate::fault::{ChapterError, ChapterResult, Fault};
use crate::markdown;
use crate::picture::{self, Loading};
use crate::problem::{Heading, OpenProblem, Position, Problem};
use crate::{
    Sources, algorithm, check_form, console, figure, folded_box, formula, listing, mistake_gallery,
    note, numbers, pixel_panel,
};
use figures::Figure;
use mdbook_markdown::pulldown_cmark::{
    CodeBlockKind, Event, Parser, Tag, TagEnd, TextMergeWithOffset,
};
use std::ops::Range;

/// The most lists, quotations and emphases inside one another. mdBook overflows its stack if there
/// are thousands.
const MAX_NESTING: usize = 20;

/// A chapter as Markdown for mdBook to render, with the faults and problems that were found in it.
#[derive(Debug)]
pub struct ExpandedChapter {
    markdown: String,
    /// Its faults, from top to bottom.
    pub faults: Vec<Fault>,
    /// Its problems, which readers solve on paper.
    pub problems: Vec<Problem>,
    /// The position of `{{#problem-sheet}}` in the Markdown.
    sheet_position: Option<usize>,
}

impl ExpandedChapter {
    /// The Markdown, with `sheet` (the problems of all chapters) inserted if the chapter has a
    /// `{{#problem-sheet}}`.
    pub fn markdown_with_sheet(&self, sheet: &str) -> String {
        let mut markdown = self.markdown.clone();
        if let Some(position) = self.sheet_position {
            markdown.insert_str(position, sheet);
        }
        markdown
    }
}

/// Expands the listings, formulas, figures, numbers, pictures and boxes in the `text` of a chapter.
/// `our_folder` is Markdown that says where the source of the book is.
pub fn expand_chapter(text: &str, sources: &Sources, our_folder: &str) -> ExpandedChapter {
    let mut chapter = Chapter {
        text,
        sources,
        our_folder,
        expanded: String::new(),
        expanded_end: 0,
        faults: vec![],
        listings: vec![],
        loading: Loading::AtOnce,
        noted_blocks: vec![],
        open_box: None,
        open_problem: None,
        problems: vec![],
        sheet_position: None,
        missing_panel: None,
    };
    chapter.expand_blocks();
    chapter.copy_until(text.len());
    chapter.faults.sort_by_key(|fault| fault.line);
    ExpandedChapter {
        markdown: chapter.expanded,
        faults: chapter.faults,
        problems: chapter.problems,
        sheet_position: chapter.sheet_position,
    }
}

/// A chapter while it is being expanded, in one pass from top to bottom.
struct Chapter<'a> {
    /// The text as its author wrote it.
    text: &'a str,
    sources: &'a Sources,
    our_folder: &'a str,
    /// The result for the text up to the position `expanded_end`.
    expanded: String,
    expanded_end: usize,
    faults: Vec<Fault>,
    /// The ids of the listings so far.
    listings: Vec<String>,
    /// How the next picture is loaded.
    loading: Loading,
    /// The ranges of the text that are a block and the notes beside it.
    noted_blocks: Vec<Range<usize>>,
    /// The position where the open box begins.
    open_box: Option<usize>,
    open_problem: Option<OpenProblem>,
    problems: Vec<Problem>,
    /// The position of the problem sheet in `expanded`.
    sheet_position: Option<usize>,
    /// The position and name of an interactive picture with a probe, until its panel begins.
    missing_panel: Option<(usize, &'static str)>,
}

type Events<'a> = [(Event<'a>, Range<usize>)];

impl<'a> Chapter<'a> {
    fn add_fault(&mut self, position: usize, error: ChapterError) {
        let line = 1 + self.text[..position].matches('\n').count();
        self.faults.push(Fault { line, error });
    }

    /// Copies the text unchanged, from where the expansion has got to, up to this position.
    fn copy_until(&mut self, position: usize) {
        self.expanded += &self.text[self.expanded_end..position];
        self.expanded_end = position;
    }

    /// Pairs a position in the text with the matching one in the expanded text.
    fn position(&mut self, in_text: usize) -> Position {
        self.copy_until(in_text);
        Position { in_text, in_expanded: self.expanded.len() }
    }

    /// Replaces a range of the text with `part`, or adds a fault if `part` is an error.
    fn replace(&mut self, range: Range<usize>, part: ChapterResult<String>) {
        self.copy_until(range.start);
        self.expanded_end = range.end;
        match part {
            Ok(part) => self.expanded += &part,
            Err(error) => self.add_fault(range.start, error),
        }
    }

    /// Replaces an inline formula with MathML. A comma or full stop after it is kept on the same
    /// line.
    fn replace_inline_formula(&mut self, latex: &str, range: &Range<usize>) {
        let formula = formula::formula_html(latex, false, &self.sources.values);
        let mark = self.text[range.end..].chars().next();
        match mark.filter(|mark| ",.;:?)".contains(*mark)) {
            Some(mark) => {
                let tight =
                    formula.map(|html| format!("<span class=\"tight\">{html}{mark}</span>"));
                self.replace(range.start..range.end + mark.len_utf8(), tight);
            }
            None => self.replace(range.clone(), formula),
        }
    }

    fn expand_blocks(&mut self) {
        let mut nesting = 0;
        let parser = Parser::new_ext(self.text, markdown::markdown_options());
        let events: Vec<_> = TextMergeWithOffset::new(parser.into_offset_iter()).collect();
        self.noted_blocks = note::find_noted_blocks(self.text, &events);
        for (index, (event, range)) in events.iter().enumerate() {
            match event {
                Event::Start(_) => {
                    nesting += 1;
                    if nesting == 1 {
                        self.begin_noted_block(range.start);
                    }
                }
                Event::End(_) => nesting -= 1,
                _ => {}
            }
            if nesting > MAX_NESTING {
                self.add_fault(range.start, ChapterError::DeepNesting);
                return;
            }
            if self.expanded_end < range.end
                && let Some(part) = self.expand_event(event, &events[index..], range)
            {
                self.replace(range.clone(), part);
            }
        }
        let problem_position = self.open_problem.as_ref().map(|problem| problem.start);
        if let Some(position) = problem_position.or(self.open_box) {
            self.add_fault(position, ChapterError::MissingEndOfBox);
        }
        if let Some((position, picture)) = self.missing_panel {
            self.add_fault(position, ChapterError::MissingPanel(picture));
        }
    }

    /// Opens the frame around a block and its notes, if the block at this position has any.
    fn begin_noted_block(&mut self, start: usize) {
        if self.noted_blocks.iter().any(|block| block.start == start) {
            self.copy_until(start);
            self.expanded += note::OPENING_HTML;
        }
    }

    /// A note, and the end of the frame around its block if it is the last one there.
    fn expand_note(
        &self,
        html: ChapterResult<String>,
        range: &Range<usize>,
    ) -> ChapterResult<String> {
        let is_inside = |block: &&Range<usize>| block.contains(&range.start);
        let block = self.noted_blocks.iter().find(is_inside);
        let block = block.ok_or(ChapterError::NoteWithoutBlock)?;
        let closing = if block.end == range.end { note::CLOSING_HTML } else { "" };
        html.map(|html| html + closing)
    }

    /// The replacement for a part of the chapter, or None if the text stays as it is.
    fn expand_event(
        &mut self,
        event: &Event,
        events: &Events,
        range: &Range<usize>,
    ) -> Option<ChapterResult<String>> {
        let source = &self.text[range.clone()];
        let values = &self.sources.values;
        Some(match event {
            Event::Start(Tag::CodeBlock(kind)) => self.expand_code_block(kind, source),
            Event::Start(Tag::Paragraph) => {
                let html = self.expand_paragraph(events, range)?;
                html.map(|html| format!("\n{html}\n"))
            }
            Event::Start(Tag::TableRow) => match Directive::parse(source) {
                Some(Directive { kind: "rows", words }) => {
                    pixel_panel::rows_markdown(words, values)
                }
                _ => return None,
            },
            Event::Start(Tag::Strong) => {
                let position = self.position(range.start);
                self.open_problem.as_mut()?.begin_bold_words(position);
                return None;
            }
            Event::End(TagEnd::Strong) => {
                let position = self.position(range.end);
                self.open_problem.as_mut()?.end_bold_words(position);
                return None;
            }
            Event::Start(Tag::Image { dest_url, .. }) => {
                picture::markdown_html(source, dest_url, self.sources, &mut self.loading)
            }
            Event::InlineMath(latex) => {
                self.replace_inline_formula(latex, range);
                return None;
            }
            Event::DisplayMath(latex) => formula::formula_html(latex, true, values),
            Event::Code(code) if is_breakable_name(code) => {
                Ok(markdown::code_with_break_hints(code))
            }
            Event::Code(_) => numbers::fill_in_code(source, values),
            Event::Text(_) | Event::Html(_) | Event::InlineHtml(_) => {
                self.find_lone_dollar(source, range.start);
                let first = source.find("{{#")?;
                let our_folder = self.our_folder;
                let text = replace_directives(&source[first..], |directive| match directive.kind {
                    "our-folder" => Ok(our_folder.to_owned()),
                    _ => numbers::number_html(directive, values),
                });
                self.replace(range.start + first..range.end, text);
                return None;
            }
            _ => return None,
        })
    }

    /// Adds a fault if there is a $ in `source`, a piece of text or HTML that begins at `start`.
    fn find_lone_dollar(&mut self, source: &str, start: usize) {
        let mut positions = source.match_indices('$').map(|(index, _)| start + index);
        if let Some(position) = positions.find(|k| !self.text[..*k].ends_with('\\')) {
            self.add_fault(position, ChapterError::LoneDollar);
        }
    }

    /// Expands a code block: an include becomes a listing, and commands get a caption. Rust typed
    /// into the chapter itself is a fault, since nothing would compile it.
    fn expand_code_block(&mut self, kind: &CodeBlockKind, source: &str) -> ChapterResult<String> {
        let CodeBlockKind::Fenced(info) = kind else {
            return numbers::fill_in_code(source, &self.sources.values);
        };
        let (language, word) = info.split_once(',').unwrap_or((info, ""));
        let lines: Vec<&str> = source.trim_end().lines().skip(1).collect();
        let content = lines[..lines.len().saturating_sub(1)].join("\n");
        let include = Directive::parse(&content).filter(|directive| directive.kind == "include");
        let html = if let Some(Directive { words, .. }) = include {
            listing::html(language, word, words, self.sources, &mut self.listings)?
        } else if language == "console" {
            console::figure_markdown(word, &content)?
        } else if language == "algorithm" {
            algorithm::html(&content)
        } else if ["", "rust", "toml"].contains(&language) {
            return Err(ChapterError::TypedCode);
        } else {
            return numbers::fill_in_code(source, &self.sources.values);
        };
        Ok(format!("\n{html}\n"))
    }

    /// Expands a paragraph that consists of one directive, or only of pictures.
    fn expand_paragraph(
        &mut self,
        events: &Events,
        range: &Range<usize>,
    ) -> Option<ChapterResult<String>> {
        let directive = Directive::parse(&self.text[range.clone()]);
        let Some(Directive { kind, words }) = directive else {
            return self.expand_pictures_alone(events, range);
        };
        let values = &self.sources.values;
        if let Some(html) = note::html(Directive { kind, words }, values) {
            return Some(self.expand_note(html, range));
        }
        Some(match (kind, words) {
            ("figure", name) => figure::html(name, values),
            ("check", name) => check_form::html(name, self.sources),
            ("mistakes", step) => mistake_gallery::html(step, self.sources, &mut self.loading),
            ("problem", _) if self.open_problem.is_some() || self.open_box.is_some() => {
                Err(ChapterError::ProblemInBox)
            }
            ("problem", words) => {
                self.begin_problem(words, range);
                return None;
            }
            ("problem-sheet", _) => {
                self.replace(range.clone(), Ok("\n\n".to_owned()));
                // The sheet goes between the two newlines.
                self.sheet_position = Some(self.expanded.len() - 1);
                return None;
            }
            ("end", _) => self.end_box(),
            ("pixel-panel", picture) => {
                let html = self.pixel_panel_html(picture);
                self.begin_box(kind, range.start, html)
            }
            (kind, words) => match folded_box::opening_html(kind, words, values) {
                Some(html) => self.begin_box(kind, range.start, html),
                None => return None,
            },
        })
    }

    /// Opens a box. It counts as open even if its first line is an error, so that its `{{#end}}`
    /// isn't reported as well. Boxes don't nest.
    fn begin_box(
        &mut self,
        kind: &str,
        start: usize,
        html: ChapterResult<String>,
    ) -> ChapterResult<String> {
        if self.open_box.is_some() {
            return Err(ChapterError::BoxInBox);
        }
        self.open_box = Some(start);
        let text_end = self.position(start);
        match &mut self.open_problem {
            Some(_) if kind != "answer" => return Err(ChapterError::MissingAnswer),
            Some(problem) => problem.begin_answer(text_end),
            None => {}
        }
        html
    }

    /// Opens a problem. It counts as open even if its first line is an error, so that its
    /// `{{#end}}` isn't reported as well.
    fn begin_problem(&mut self, words: &str, range: &Range<usize>) {
        let (heading, html) = match Heading::parse(words) {
            Ok(heading) => {
                let html = format!("\n{}\n", heading.html());
                (Some(heading), Ok(html))
            }
            Err(error) => (None, Err(error)),
        };
        self.replace(range.clone(), html);
        let text_start = self.position(range.end);
        self.open_problem = Some(OpenProblem::new(heading, range.start, text_start));
    }

    /// The HTML that begins the panel of the interactive picture above it, which has to be this
    /// one.
    fn pixel_panel_html(&mut self, name: &str) -> ChapterResult<String> {
        match self.missing_panel.take_if(|(_, picture)| *picture == name) {
            Some((_, picture)) => Ok(pixel_panel::opening_html(picture)),
            None => Err(ChapterError::PanelWithoutPicture(name.to_owned())),
        }
    }

    /// Closes the open box and, if the box is the answer of a problem, that problem.
    fn end_box(&mut self) -> ChapterResult<String> {
        match (self.open_box.take(), self.open_problem.take()) {
            (Some(_), None) => Ok("</details>\n".to_owned()),
            (Some(_), Some(problem)) => {
                let start = problem.start;
                match problem.finish(self.text, &self.expanded) {
                    Some(Ok(problem)) => self.problems.push(problem),
                    Some(Err(error)) => self.add_fault(start, error),
                    None => {}
                }
                Ok("</details>\n</section>\n".to_owned())
            }
            (None, Some(_)) => Err(ChapterError::MissingAnswer),
            (None, None) => Err(ChapterError::EndWithoutBox),
        }
    }

    /// Expands a paragraph that consists only of pictures. A directive such as `{{#live
    /// own_scene}}` after them makes them interactive.
    fn expand_pictures_alone(
        &mut self,
        events: &Events,
        range: &Range<usize>,
    ) -> Option<ChapterResult<String>> {
        let (mut pictures, mut remaining) = (vec![], self.text[range.clone()].to_owned());
        for (event, inner) in events {
            if let Event::Start(Tag::Image { dest_url, title, .. }) = event
                && inner.start < range.end
            {
                let markdown = &self.text[inner.clone()];
                remaining = remaining.replacen(markdown, "", 1);
                pictures.push([markdown, &**dest_url, &**title]);
            }
        }
        let live = Directive::parse(&remaining).filter(|directive| directive.kind == "live");
        let is_whole = live.is_some() || remaining.trim().is_empty();
        if !is_whole || pictures.is_empty() {
            return None;
        }
        let live = match live.map(|directive| find_live(directive.words)).transpose() {
            Ok(live) => live,
            Err(error) => return Some(Err(error)),
        };
        if let Some(picture) = live.filter(|live| live.probe().is_some()) {
            self.missing_panel = Some((range.start, picture.name));
        }
        Some(self.figures_html(&pictures, live))
    }

    /// The figures for some pictures, given as `[markdown, file, caption]`. Several stand side by
    /// side.
    fn figures_html(
        &mut self,
        pictures: &[[&str; 3]],
        live: Option<&Figure>,
    ) -> ChapterResult<String> {
        let mut figures = String::new();
        for [markdown, file, caption] in pictures {
            let image = picture::markdown_html(markdown, file, self.sources, &mut self.loading)?;
            figures += &picture::figure_html(&image, caption, live, &self.sources.values)?;
        }
        if pictures.len() > 1 {
            // A browser's reader view would drop a `div` of pictures as decoration.
            figures = format!("<section class=\"pictures\">\n{figures}</section>\n");
        }
        Ok(figures)
    }
}

fn find_live(name: &str) -> ChapterResult<&'static Figure> {
    figures::find(name).ok_or_else(|| ChapterError::UnknownLive(name.to_owned()))
}

/// Whether code is a name or a path, such as `Ray::at` or `src/ray.rs`, in which a line may break.
fn is_breakable_name(code: &str) -> bool {
    let in_name = |c: char| c.is_ascii_alphanumeric() || "_:/.-".contains(c);
    code.chars().all(in_name) && code.contains(['_', ':', '/'])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_name_of_several_words_is_breakable() {
        for code in ["Ray::at", "to_radians", "src/ray.rs"] {
            assert!(is_breakable_name(code), "{code}");
        }
        for code in ["Ray", "a + b_c", "v.dot(v)"] {
            assert!(!is_breakable_name(code), "{code}");
        }
    }
}
