//! Expands a chapter: turns every directive, formula and listing into HTML.
//!
//! The result is Markdown that contains this HTML, because a preprocessor has to return Markdown.
//! The paragraphs, headings and links stay as their author wrote them, and mdBook renders them
//! afterwards.

use crate::directive::{Directive, DirectiveKind, replace_directives};
use crate::fault::{ChapterError, ChapterResult, Fault};
use crate::listing::ExpandedListing;
use crate::markdown::{self, html_block};
use crate::open_box::Boxes;
use crate::picture::{self, Interaction, LoadingTime};
use crate::problem::{NumberAndAnswer, PositionPair, Problem};
use crate::{
    Sources, algorithm, check_form, console, figure, folded_box, formula, listing, mistake_gallery,
    note, numbers, pixel_panel,
};
use mdbook_markdown::pulldown_cmark::{
    CodeBlockKind, Event, Parser, Tag, TagEnd, TextMergeWithOffset,
};
use std::ops::Range;

/// The maximum nesting depth of lists, quotations, emphasis and so on. At a depth of thousands,
/// mdBook would overflow its stack.
const MAX_NESTING: usize = 20;

/// The result of expanding a chapter: Markdown for mdBook to render, and the chapter's faults and
/// problems.
#[derive(Debug, Default)]
pub struct ExpandedChapter {
    markdown: String,
    /// The faults, from top to bottom.
    pub faults: Vec<Fault>,
    /// The problems that readers solve on paper.
    pub problems: Vec<Problem>,
    /// The position in `markdown` where the problem sheet goes, if the chapter has
    /// `{{#problem-sheet}}`.
    sheet_position: Option<usize>,
}

impl ExpandedChapter {
    /// Returns the Markdown. If the chapter has `{{#problem-sheet}}`, that directive is replaced
    /// with `sheet`, the problems from all chapters.
    pub fn markdown_with_sheet(&self, sheet: &str) -> String {
        let mut markdown = self.markdown.clone();
        if let Some(position) = self.sheet_position {
            markdown.insert_str(position, sheet);
        }
        markdown
    }
}

/// Expands the directives, formulas, listings and pictures in the text of a chapter.
/// `source_location_markdown` says where the book's source is, and replaces `{{#our-folder}}`.
pub fn expand_chapter(
    text: &str,
    sources: &Sources,
    source_location_markdown: &str,
) -> ExpandedChapter {
    let mut chapter = Chapter {
        text,
        sources,
        source_location_markdown,
        expanded: ExpandedChapter::default(),
        expanded_end: 0,
        listings: vec![],
        loading: LoadingTime::AtOnce,
        noted_blocks: vec![],
        boxes: Boxes::default(),
    };
    chapter.expand_events();
    chapter.copy_until(text.len());
    chapter.expanded.faults.sort_by_key(|fault| fault.line);
    chapter.expanded
}

/// A chapter while it is being expanded, in one pass from top to bottom.
struct Chapter<'a> {
    /// The text as its author wrote it.
    text: &'a str,
    sources: &'a Sources,
    source_location_markdown: &'a str,
    /// The result so far: the expansion of the text up to the position `expanded_end`.
    expanded: ExpandedChapter,
    expanded_end: usize,
    /// The ids of the listings so far.
    listings: Vec<String>,
    /// When a browser loads the next picture of the chapter.
    loading: LoadingTime,
    /// The blocks that have notes. Each range covers a block and its notes.
    noted_blocks: Vec<Range<usize>>,
    boxes: Boxes,
}

type Events<'a> = [(Event<'a>, Range<usize>)];

/// What to do with the part of a chapter that an event is about.
enum Expansion {
    /// Copy the part. The events inside the part may still expand smaller parts.
    Keep,
    /// Replace the part with this Markdown.
    Replace(String),
    /// Do nothing, because the part has already been replaced.
    Done,
}

impl<'a> Chapter<'a> {
    fn add_fault(&mut self, position: usize, error: ChapterError) {
        let line = 1 + self.text[..position].matches('\n').count();
        self.expanded.faults.push(Fault { line, error });
    }

    /// Copies the text unchanged, from `expanded_end` up to this position.
    fn copy_until(&mut self, position: usize) {
        self.expanded.markdown += &self.text[self.expanded_end..position];
        self.expanded_end = position;
    }

    /// Copies the text up to the position `in_text`. Returns this position and the corresponding
    /// position in the expanded text.
    fn copy_until_position_pair(&mut self, in_text: usize) -> PositionPair {
        self.copy_until(in_text);
        PositionPair { in_text, in_expanded: self.expanded.markdown.len() }
    }

    /// Replaces a range of the text with `part`, or adds a fault if `part` is an error.
    fn replace(&mut self, range: Range<usize>, part: ChapterResult<String>) {
        self.copy_until(range.start);
        self.expanded_end = range.end;
        match part {
            Ok(part) => self.expanded.markdown += &part,
            Err(error) => self.add_fault(range.start, error),
        }
    }

    /// Replaces an inline formula with MathML. A punctuation mark right after the formula stays on
    /// the same line as the formula.
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

    /// Expands the whole chapter, from top to bottom. Adds a fault for each error. Then adds a
    /// fault for each panel or `{{#end}}` that is missing.
    fn expand_events(&mut self) {
        let mut nesting = 0;
        let parser = Parser::new_ext(self.text, markdown::markdown_options());
        let events: Vec<_> = TextMergeWithOffset::new(parser.into_offset_iter()).collect();
        self.noted_blocks = note::find_noted_blocks(self.text, &events);
        for (index, (event, range)) in events.iter().enumerate() {
            match event {
                Event::Start(_) => {
                    nesting += 1;
                    if nesting == 1 {
                        self.open_wrapper_if_block_has_notes(range.start);
                    }
                }
                Event::End(_) => nesting -= 1,
                _ => {}
            }
            if nesting > MAX_NESTING {
                self.add_fault(range.start, ChapterError::DeepNesting);
                return;
            }
            // Skip the events inside a part that has already been replaced.
            if self.expanded_end < range.end {
                match self.expand_event(event, &events[index..], range) {
                    Ok(Expansion::Keep) => {}
                    Ok(Expansion::Replace(part)) => self.replace(range.clone(), Ok(part)),
                    Ok(Expansion::Done) => debug_assert!(self.expanded_end >= range.end),
                    Err(error) => self.replace(range.clone(), Err(error)),
                }
            }
        }
        for (position, error) in self.boxes.find_missing_ends_and_panels() {
            self.add_fault(position, error);
        }
    }

    /// Whether the block that begins at this position has notes. `open_wrapper_if_block_has_notes`
    /// opens a wrapper around each such block.
    fn block_has_notes(&self, block_start: usize) -> bool {
        self.noted_blocks.iter().any(|block| block.start == block_start)
    }

    /// If a block with notes begins at this position, opens the wrapper around the block and its
    /// notes.
    fn open_wrapper_if_block_has_notes(&mut self, start: usize) {
        if self.block_has_notes(start) {
            self.copy_until(start);
            self.expanded.markdown += &note::wrapper_opening_html();
        }
    }

    /// Returns a block in a wrapper, so that a tool, such as the line editor, can open in the
    /// margin beside the block. A block with notes is returned unchanged, because such a block
    /// already has a wrapper.
    fn wrap_unless_block_has_notes(&self, block: String, block_start: usize) -> String {
        if self.block_has_notes(block_start) {
            block
        } else {
            [note::wrapper_opening_html(), block, note::wrapper_closing_html()].concat()
        }
    }

    /// Returns `note_html`. If the note is the last note of its block, adds the HTML that closes
    /// the wrapper of the block. Returns an error if the note doesn't follow a block.
    fn close_wrapper_after_last_note(
        &self,
        note_html: ChapterResult<String>,
        note_range: &Range<usize>,
    ) -> ChapterResult<String> {
        let is_inside = |block: &&Range<usize>| block.contains(&note_range.start);
        let block =
            self.noted_blocks.iter().find(is_inside).ok_or(ChapterError::NoteWithoutBlock)?;
        let is_last = block.end == note_range.end;
        note_html.map(|html| if is_last { html + &note::wrapper_closing_html() } else { html })
    }

    /// Expands the part of the chapter that begins with this event.
    fn expand_event(
        &mut self,
        event: &Event,
        events: &Events,
        range: &Range<usize>,
    ) -> ChapterResult<Expansion> {
        let source = &self.text[range.clone()];
        let values = &self.sources.values;
        Ok(Expansion::Replace(match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                self.expand_code_block(kind, source, range.start)?
            }
            Event::Start(Tag::Paragraph) => {
                return Ok(match self.expand_directive_or_pictures(events, range)? {
                    Expansion::Replace(html) => Expansion::Replace(html_block(&html)),
                    other => other,
                });
            }
            Event::Start(Tag::TableRow) => match Directive::parse(source) {
                Some(Directive { kind: DirectiveKind::Rows, words }) => {
                    pixel_panel::rows_markdown(words, values)?
                }
                _ => return Ok(Expansion::Keep),
            },
            Event::Start(Tag::Strong) => {
                let position = self.copy_until_position_pair(range.start);
                if let Some(answer) = self.boxes.open_answer_mut() {
                    answer.record_first_bold_start(position);
                }
                return Ok(Expansion::Keep);
            }
            Event::End(TagEnd::Strong) => {
                let position = self.copy_until_position_pair(range.end);
                if let Some(answer) = self.boxes.open_answer_mut() {
                    answer.record_first_bold_end(position);
                }
                return Ok(Expansion::Keep);
            }
            Event::Start(Tag::Image { dest_url, .. }) => picture::image_html_from_markdown(
                source,
                dest_url,
                self.sources,
                &mut self.loading,
            )?,
            Event::InlineMath(latex) => {
                self.replace_inline_formula(latex, range);
                return Ok(Expansion::Done);
            }
            Event::DisplayMath(latex) => formula::formula_html(latex, true, values)?,
            Event::Code(code) if is_breakable_name(code) => markdown::code_with_break_hints(code),
            Event::Code(_) => numbers::fill_in_values_in_code(source, values)?,
            Event::Text(_) | Event::Html(_) | Event::InlineHtml(_) => {
                self.report_first_unescaped_dollar(source, range.start);
                let Some(first) = source.find("{{#") else { return Ok(Expansion::Keep) };
                let source_location_markdown = self.source_location_markdown;
                let text = replace_directives(&source[first..], |directive| match directive.kind {
                    DirectiveKind::OurFolder => Ok(source_location_markdown.to_owned()),
                    _ => numbers::number_html(directive, values),
                });
                self.replace(range.start + first..range.end, text);
                return Ok(Expansion::Done);
            }
            _ => return Ok(Expansion::Keep),
        }))
    }

    /// Finds the first unescaped $ in `source`, and adds a fault for that $. `source` is text or
    /// HTML from the chapter, and begins at the position `start`.
    fn report_first_unescaped_dollar(&mut self, source: &str, start: usize) {
        let mut positions = source.match_indices('$').map(|(index, _)| start + index);
        if let Some(position) = positions.find(|k| !self.text[..*k].ends_with('\\')) {
            self.add_fault(position, ChapterError::LoneDollar);
        }
    }

    /// Expands a code block. An `include` becomes a listing, and the fences `console` and
    /// `algorithm` become HTML. Rust or TOML that is typed directly into a chapter is a fault, and
    /// so is code in a fence without a language, since nothing would verify that such code works.
    fn expand_code_block(
        &mut self,
        kind: &CodeBlockKind,
        source: &str,
        start: usize,
    ) -> ChapterResult<String> {
        let CodeBlockKind::Fenced(info) = kind else {
            return numbers::fill_in_values_in_code(source, &self.sources.values);
        };
        let (language, words_after_console) = info.split_once(',').unwrap_or((info, ""));
        let lines: Vec<&str> = source.trim_end().lines().skip(1).collect();
        let content = lines[..lines.len().saturating_sub(1)].join("\n");
        let include =
            Directive::parse(&content).filter(|directive| directive.kind == DirectiveKind::Include);
        let html = if let Some(Directive { words, .. }) = include {
            let ExpandedListing { markdown, has_places } = listing::expand_listing(
                language,
                words_after_console,
                words,
                self.sources,
                &mut self.listings,
            )?;
            if has_places { self.wrap_unless_block_has_notes(markdown, start) } else { markdown }
        } else if language == "console" {
            console::console_markdown(words_after_console, &content)?
        } else if language == "algorithm" {
            algorithm::algorithm_html(&content)
        } else if ["", "rust", "toml"].contains(&language) {
            return Err(ChapterError::CodeNotIncluded);
        } else {
            return numbers::fill_in_values_in_code(source, &self.sources.values);
        };
        Ok(html_block(&html))
    }

    /// Expands a paragraph that consists of a single directive, or of nothing but pictures.
    fn expand_directive_or_pictures(
        &mut self,
        events: &Events,
        range: &Range<usize>,
    ) -> ChapterResult<Expansion> {
        let directive = Directive::parse(&self.text[range.clone()]);
        let Some(Directive { kind, words }) = directive else {
            return self.expand_pictures_alone(events, range);
        };
        let values = &self.sources.values;
        Ok(Expansion::Replace(match kind {
            DirectiveKind::Note(kind) => {
                self.close_wrapper_after_last_note(note::note_html(kind, words, values), range)?
            }
            DirectiveKind::Figure => figure::drawing_html(words, values)?,
            DirectiveKind::Check => check_form::check_form_html(words, self.sources)?,
            DirectiveKind::Mistakes => {
                mistake_gallery::gallery_markdown(words, self.sources, &mut self.loading)?
            }
            DirectiveKind::Problem => {
                self.boxes.ensure_problem_can_begin()?;
                self.begin_problem(words, range);
                return Ok(Expansion::Done);
            }
            DirectiveKind::ProblemSheet => {
                self.replace(range.clone(), Ok("\n\n".to_owned()));
                // The sheet goes between the two newlines.
                self.expanded.sheet_position = Some(self.expanded.markdown.len() - 1);
                return Ok(Expansion::Done);
            }
            DirectiveKind::End => self.expand_end()?,
            DirectiveKind::PixelPanel => self.boxes.begin_pixel_panel(words, range.start)?,
            DirectiveKind::Box(kind) => {
                let html = folded_box::opening_html(kind, words, values);
                let position = self.copy_until_position_pair(range.start);
                self.boxes.begin_folded_box(kind, position, html)?
            }
            // Leave these directives to the next event, which is the text of this paragraph. For
            // that event, `expand_event` fills in `value`, `number` and `our-folder`, which are
            // allowed in any text, and reports the other directives as misplaced.
            DirectiveKind::Value
            | DirectiveKind::Number
            | DirectiveKind::OurFolder
            | DirectiveKind::Include
            | DirectiveKind::Live
            | DirectiveKind::Preview
            | DirectiveKind::Rows => return Ok(Expansion::Keep),
        }))
    }

    /// Expands the first line of a problem. The problem becomes the open box.
    fn begin_problem(&mut self, words: &str, range: &Range<usize>) {
        let (number_and_answer, html) = match NumberAndAnswer::parse(words) {
            Ok(number_and_answer) => {
                let html = html_block(&number_and_answer.opening_html());
                (Some(number_and_answer), Ok(html))
            }
            Err(error) => (None, Err(error)),
        };
        self.replace(range.clone(), html);
        let text_start = self.copy_until_position_pair(range.end);
        self.boxes.begin_problem(number_and_answer, range.start, text_start);
    }

    /// Expands `{{#end}}`. If the directive ends a problem, adds that problem to the chapter's
    /// problems.
    fn expand_end(&mut self) -> ChapterResult<String> {
        let (html, answer) = self.boxes.end_box()?;
        if let Some(answer) = answer {
            let start = answer.problem.start;
            match answer.finish(self.text, &self.expanded.markdown) {
                Some(Ok(problem)) => self.expanded.problems.push(problem),
                Some(Err(error)) => self.add_fault(start, error),
                None => {}
            }
        }
        Ok(html)
    }

    /// Expands a paragraph of pictures. After the pictures, the paragraph may contain a directive
    /// that makes them interactive: `{{#live own_scene}}` or `{{#preview own_scene}}`, for example.
    /// A paragraph that contains anything else is kept.
    fn expand_pictures_alone(
        &mut self,
        events: &Events,
        range: &Range<usize>,
    ) -> ChapterResult<Expansion> {
        let (mut pictures, mut remaining) = (vec![], self.text[range.clone()].to_owned());
        for (event, event_range) in events {
            if let Event::Start(Tag::Image { dest_url, title, .. }) = event
                && event_range.start < range.end
            {
                let markdown = &self.text[event_range.clone()];
                remaining = remaining.replacen(markdown, "", 1);
                pictures.push(ChapterPicture { markdown, file: dest_url, caption: title });
            }
        }
        let directive = Directive::parse(&remaining).filter(|directive| {
            matches!(directive.kind, DirectiveKind::Live | DirectiveKind::Preview)
        });
        let has_only_pictures = directive.is_some() || remaining.trim().is_empty();
        if !has_only_pictures || pictures.is_empty() {
            return Ok(Expansion::Keep);
        }
        let interaction = directive.map(find_interaction).transpose()?;
        let html = self.figures_html(&pictures, interaction)?;
        Ok(Expansion::Replace(match interaction {
            Some(Interaction::Live(picture)) if picture.probe().is_some() => {
                let has_notes = self.block_has_notes(range.start);
                self.boxes.await_panel(picture.name, range.start, has_notes) + &html
            }
            Some(Interaction::Live(picture)) if picture.editable_scene.is_some() => {
                self.wrap_unless_block_has_notes(html, range.start)
            }
            _ => html,
        }))
    }

    /// Returns the HTML of these pictures. Several pictures are placed side by side.
    fn figures_html(
        &mut self,
        pictures: &[ChapterPicture],
        interaction: Option<Interaction>,
    ) -> ChapterResult<String> {
        let mut figures = String::new();
        for ChapterPicture { markdown, file, caption } in pictures {
            let image =
                picture::image_html_from_markdown(markdown, file, self.sources, &mut self.loading)?;
            figures += &picture::figure_html(&image, caption, interaction, &self.sources.values)?;
        }
        if pictures.len() > 1 {
            // This is a `section`, because a browser's reader view would drop a `div` of pictures
            // as decoration.
            figures = format!("<section class=\"pictures\">\n{figures}</section>\n");
        }
        Ok(figures)
    }
}

/// A picture in a chapter, such as `![alt text](generated/name.png "Caption")`.
struct ChapterPicture<'a> {
    markdown: &'a str,
    file: &'a str,
    caption: &'a str,
}

/// Returns the interaction that a `live` or `preview` directive gives to the pictures before the
/// directive.
fn find_interaction(directive: Directive) -> ChapterResult<Interaction<'static>> {
    let Directive { kind, words } = directive;
    let figure = figures::find_figure(words)
        .ok_or_else(|| ChapterError::UnknownInteractiveFigure(words.to_owned()))?;
    let make = if kind == DirectiveKind::Live { Interaction::Live } else { Interaction::Preview };
    Ok(make(figure))
}

/// Whether a piece of code is a name, such as `Ray::at`, that may be broken between two lines.
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
