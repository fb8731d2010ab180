use crate::fault::{ChapterError, ChapterResult, Fault};
use crate::markdown::{self, parse_directive};
use crate::{
    Sources, check_form, console, figure, folded_box, formula, listing, mistake_gallery, numbers,
    picture, pixel_panel, problem,
};
use figures::Figure;
use mdbook_markdown::pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TextMergeWithOffset};
use std::ops::Range;

/// Lists, quotations and emphases in one another: mdBook overflows where there are thousands.
const MAX_NESTING: usize = 20;

/// Puts listings, formulas, figures, numbers, pictures and boxes into the `text` of a
/// chapter: gives Markdown as mdBook renders it, and what is wrong on which line. The
/// problems of all chapters are there already, in Markdown.
pub fn expand_directives(
    text: &str,
    sources: &Sources,
    problem_sheet: &str,
) -> (String, Vec<Fault>) {
    let mut chapter = Chapter {
        text,
        sources,
        problem_sheet,
        expanded: String::new(),
        expanded_end: 0,
        faults: vec![],
        listings: vec![],
        open_box: None,
        open_problem: None,
        missing_panel: None,
    };
    chapter.expand_blocks();
    chapter.faults.sort_by_key(|fault| fault.line);
    let markdown = chapter.expanded + &text[chapter.expanded_end..];
    // The first picture does not wait until it is near.
    (markdown.replacen(picture::LAZY, " fetchpriority=\"high\"", 1), chapter.faults)
}

/// A chapter as it is read once, from top to bottom.
struct Chapter<'a> {
    /// The text as its author wrote it.
    text: &'a str,
    sources: &'a Sources,
    problem_sheet: &'a str,
    /// What the text becomes, up to `expanded_end` in it.
    expanded: String,
    expanded_end: usize,
    faults: Vec<Fault>,
    /// The ids of the listings so far.
    listings: Vec<String>,
    /// Places where the open box and the open problem begin.
    open_box: Option<usize>,
    open_problem: Option<usize>,
    /// The place and the name of a picture whose pixels can be chosen, until its panel begins.
    missing_panel: Option<(usize, &'static str)>,
}

type Events<'a> = [(Event<'a>, Range<usize>)];

impl<'a> Chapter<'a> {
    fn add_fault(&mut self, position: usize, error: ChapterError) {
        let line = 1 + self.text[..position].matches('\n').count();
        self.faults.push(Fault { line, error });
    }

    /// Puts `part` in place of a range of the text. An error is a fault of it.
    fn replace(&mut self, range: Range<usize>, part: ChapterResult<String>) {
        self.expanded += &self.text[self.expanded_end..range.start];
        self.expanded_end = range.end;
        // A comma stays on the line of the formula before it.
        let mark = self.text[range.end..].chars().next();
        match (part, mark.filter(|mark| ",.;:?)".contains(*mark))) {
            (Err(error), _) => self.add_fault(range.start, error),
            (Ok(formula), Some(mark)) if formula.ends_with("</math>") => {
                self.expanded += &format!("<span class=\"tight\">{formula}{mark}</span>");
                self.expanded_end += mark.len_utf8();
            }
            (Ok(part), _) => self.expanded += &part,
        }
    }

    fn expand_blocks(&mut self) {
        let mut nesting = 0;
        let parser = Parser::new_ext(self.text, markdown::markdown_options());
        let events: Vec<_> = TextMergeWithOffset::new(parser.into_offset_iter()).collect();
        for (index, (event, range)) in events.iter().enumerate() {
            match event {
                Event::Start(_) => nesting += 1,
                Event::End(_) => nesting -= 1,
                _ => {}
            }
            if MAX_NESTING < nesting {
                self.add_fault(range.start, ChapterError::DeepNesting);
                return;
            }
            if self.expanded_end < range.end
                && let Some(part) = self.expand_event(event, &events[index..], range)
            {
                self.replace(range.clone(), part);
            }
        }
        if let Some(position) = self.open_problem.or(self.open_box) {
            self.add_fault(position, ChapterError::MissingEndOfBox);
        }
        if let Some((position, picture)) = self.missing_panel {
            self.add_fault(position, ChapterError::MissingPanel(picture));
        }
    }

    /// What stands in place of a part of the chapter; None for text that stays as it is.
    fn expand_event(
        &mut self,
        event: &Event,
        events: &Events,
        range: &Range<usize>,
    ) -> Option<ChapterResult<String>> {
        let source = &self.text[range.clone()];
        Some(match event {
            Event::Start(Tag::CodeBlock(kind)) => self.expand_code_block(kind, source),
            Event::Start(Tag::Paragraph) => {
                let html = self.expand_paragraph(events, range)?;
                html.map(|html| format!("\n{html}\n"))
            }
            Event::Start(Tag::TableRow) => match parse_directive(source.trim()) {
                Some(("rows", words)) => pixel_panel::rows_markdown(words),
                _ => return None,
            },
            Event::Start(Tag::Image { dest_url, .. }) => {
                picture::markdown_html(source, dest_url, self.sources)
            }
            Event::InlineMath(latex) => formula::formula_html(latex, false),
            Event::DisplayMath(latex) => formula::formula_html(latex, true),
            Event::Code(code) if is_name_with_break(code) => {
                Ok(markdown::code_with_break_hints(code))
            }
            Event::Code(_) => numbers::fill_in_text(source).map(|code| code.replace('−', "-")),
            Event::Text(_) | Event::Html(_) | Event::InlineHtml(_) => {
                self.find_lone_dollar(source, range.start);
                let first = source.find("{{#")?;
                let text = numbers::fill_in_text(&source[first..]);
                self.replace(range.start + first..range.end, text);
                return None;
            }
            _ => return None,
        })
    }

    /// Finds a $ in the `source` at this position, which is text or HTML.
    fn find_lone_dollar(&mut self, source: &str, start: usize) {
        let mut positions = source.match_indices('$').map(|(index, _)| start + index);
        if let Some(position) = positions.find(|k| !self.text[..*k].ends_with('\\')) {
            self.add_fault(position, ChapterError::LoneDollar);
        }
    }

    /// A fence: an include becomes a listing, commands get a caption. Rust is from a file, which
    /// compiles.
    fn expand_code_block(&mut self, kind: &CodeBlockKind, source: &str) -> ChapterResult<String> {
        let CodeBlockKind::Fenced(info) = kind else { return numbers::fill_in_text(source) };
        let (language, word) = info.split_once(',').unwrap_or((info, ""));
        let lines: Vec<&str> = source.trim_end().lines().skip(1).collect();
        let content = lines[..lines.len().saturating_sub(1)].join("\n");
        let html = if content.trim_start().starts_with("{{#include") {
            listing::html(language, word, &content, self.sources, &mut self.listings)?
        } else if language == "console" {
            console::figure_markdown(word, &content)?
        } else if ["", "rust", "toml"].contains(&language) {
            return Err(ChapterError::TypedCode);
        } else {
            return numbers::fill_in_text(source);
        };
        Ok(format!("\n{html}\n"))
    }

    /// A paragraph that is one directive, or nothing but pictures.
    fn expand_paragraph(
        &mut self,
        events: &Events,
        range: &Range<usize>,
    ) -> Option<ChapterResult<String>> {
        let source = self.text[range.clone()].trim();
        let (kind, words) = parse_directive(source).unwrap_or_default();
        Some(match (kind, words.trim()) {
            ("figure", name) => figure::html(name),
            ("check", name) => check_form::html(name, self.sources),
            ("mistakes", step) => mistake_gallery::html(step, self.sources),
            ("by-hand", test) => {
                let name = markdown::code_with_break_hints(test);
                Ok(format!("<p class=\"by-hand\">Test: {name}</p>\n"))
            }
            ("rust", words) => markdown::inline_html(words)
                .map(|words| format!("<p class=\"new-rust\"><b>New Rust here</b> {words}</p>\n")),
            ("problem", _) if self.open_problem.or(self.open_box).is_some() => {
                Err(ChapterError::ProblemInBox)
            }
            ("problem", words) => {
                self.open_problem = Some(range.start);
                problem::opening_html(words)
            }
            ("problem-sheet", _) => Ok(self.problem_sheet.to_owned()),
            ("end", _) => self.end_box(),
            ("pixel-panel", picture) => {
                let html = self.pixel_panel_html(picture);
                self.begin_box(range.start, html)
            }
            (kind, words) => match folded_box::opening_html(kind, words) {
                Some(html) => self.begin_box(range.start, html),
                None => return self.expand_pictures_alone(events, range),
            },
        })
    }

    /// Opens a box, even if there is an error in its first line: its `{{#end}}` is none. Boxes
    /// don't nest.
    fn begin_box(&mut self, position: usize, html: ChapterResult<String>) -> ChapterResult<String> {
        if self.open_box.is_some() {
            return Err(ChapterError::BoxInBox);
        }
        self.open_box = Some(position);
        html
    }

    /// The HTML that begins the panel of the last interactive picture.
    fn pixel_panel_html(&mut self, name: &str) -> ChapterResult<String> {
        match self.missing_panel.take_if(|(_, picture)| *picture == name) {
            Some((_, picture)) => Ok(pixel_panel::opening_html(picture)),
            None => Err(ChapterError::PanelWithoutPicture(name.to_owned())),
        }
    }

    /// The end of the open box, and of the problem whose answer it is.
    fn end_box(&mut self) -> ChapterResult<String> {
        match (self.open_box.take(), self.open_problem.take()) {
            (Some(_), None) => Ok("</details>\n".to_owned()),
            (Some(_), Some(_)) => Ok("</details>\n</section>\n".to_owned()),
            (None, Some(_)) => Err(ChapterError::MissingAnswer),
            (None, None) => Err(ChapterError::EndWithoutBox),
        }
    }

    /// A paragraph of nothing but pictures; it says behind them, by `{{#live own_scene}}`, what
    /// answers there.
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
        let live = parse_directive(remaining.trim()).filter(|(kind, _)| *kind == "live");
        let is_whole = live.is_some() || remaining.trim().is_empty();
        if !is_whole || pictures.is_empty() {
            return None;
        }
        let find = |name: &str| {
            figures::find(name).ok_or_else(|| ChapterError::UnknownLive(name.to_owned()))
        };
        let live = match live.map(|(_, name)| find(name)).transpose() {
            Ok(live) => live,
            Err(error) => return Some(Err(error)),
        };
        if let Some(picture) = live.filter(|live| live.has_probe()) {
            self.missing_panel = Some((range.start, picture.name));
        }
        Some(self.figures_html(&pictures, live))
    }

    /// Figures of pictures, each of its Markdown, its file and its caption, side by side if there
    /// are several.
    fn figures_html(&self, pictures: &[[&str; 3]], live: Option<&Figure>) -> ChapterResult<String> {
        let mut figures = String::new();
        for [markdown, file, caption] in pictures {
            let image = picture::markdown_html(markdown, file, self.sources)?;
            figures += &picture::figure_html(&image, caption, live)?;
        }
        if pictures.len() > 1 {
            // A reader view of a browser takes a `div` of pictures for decoration.
            figures = format!("<section class=\"pictures\">\n{figures}</section>\n");
        }
        Ok(figures)
    }
}

/// Whether code is a name such as `Ray::at`, which may be broken.
fn is_name_with_break(code: &str) -> bool {
    let in_name = |c: char| c.is_ascii_alphanumeric() || "_:".contains(c);
    code.chars().all(in_name) && code.contains(['_', ':'])
}
