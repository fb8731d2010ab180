use crate::markdown::{self, parse_directive};
use crate::{
    check_form, figure, folded_box, formula, listing, mistakes, numbers, picture, problem,
};
use mdbook_markdown::pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};
use std::ops::Range;
use std::path::Path;

/// A fault in a chapter: where it is, and a sentence about it.
type Fault = (usize, String);

/// Puts listings, formulas, figures, numbers, pictures and boxes into the `text` of a
/// chapter: gives Markdown as mdBook renders it, and what is wrong on which line.
pub fn expand_directives(text: &str, workspace: &Path) -> (String, Vec<Fault>) {
    let (edits, faults, code, listings) = Default::default();
    let (open_box, open_problem) = (None, None);
    let mut chapter =
        Chapter { text, workspace, edits, faults, code, listings, open_box, open_problem };
    chapter.expand_blocks();
    chapter.fill_placeholders();
    let (markdown, faults) = chapter.apply_edits();
    // The first picture does not wait until it is near.
    (markdown.replacen(picture::LAZY, " fetchpriority=\"high\"", 1), faults)
}

/// A chapter as it is read once, from top to bottom.
struct Chapter<'a> {
    text: &'a str,
    workspace: &'a Path,
    /// The parts to replace, and the text to put there.
    edits: Vec<(Range<usize>, String)>,
    faults: Vec<Fault>,
    /// The parts that are code, where a minus stays a hyphen.
    code: Vec<Range<usize>>,
    /// The ids of the listings so far.
    listings: Vec<String>,
    /// The place where the open box begins.
    open_box: Option<usize>,
    /// The place where the open problem begins.
    open_problem: Option<usize>,
}

/// A part of a chapter, by what becomes of it.
enum Part {
    /// Text that stays as it is.
    Plain,
    /// Code, in which nothing but numbers is looked for.
    Code,
    /// A part to be replaced.
    Replaced(Result<String, String>),
}

type Events<'a> = [(Event<'a>, Range<usize>)];

impl Chapter<'_> {
    fn expand_blocks(&mut self) {
        let events = Parser::new_ext(self.text, markdown::markdown_options());
        let events: Vec<_> = events.into_offset_iter().collect();
        let mut end_of_last = 0;
        for (index, (event, range)) in events.iter().enumerate() {
            if range.start < end_of_last {
                continue;
            }
            match self.expand_event(event, &events[index..], range) {
                Part::Plain => continue,
                Part::Code => self.code.push(range.clone()),
                Part::Replaced(text) => {
                    let text = self.text_or_record_fault(range.start, text);
                    self.edits.push((range.clone(), text));
                }
            }
            end_of_last = range.end;
        }
        if let Some(position) = self.open_problem.or(self.open_box) {
            self.faults.push((position, "the box has no {{#end}}".to_owned()));
        }
    }

    /// The text for a place; an empty one, and a fault, for an error.
    fn text_or_record_fault(&mut self, position: usize, text: Result<String, String>) -> String {
        text.unwrap_or_else(|fault| {
            self.faults.push((position, fault));
            String::new()
        })
    }

    fn expand_event(&mut self, event: &Event, events: &Events, range: &Range<usize>) -> Part {
        let source = &self.text[range.clone()];
        Part::Replaced(match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                return self.expand_code_block(kind, source);
            }
            Event::Start(Tag::Paragraph) => match self.expand_paragraph(events, range) {
                Some(html) => html.map(|html| format!("\n{html}\n")),
                None => return Part::Plain,
            },
            Event::Start(Tag::Image { dest_url, title, .. }) => {
                let picture = picture::Picture::from_markdown(source, dest_url, title);
                picture.html(self.workspace)
            }
            Event::InlineMath(latex) => formula::formula_html(latex, false),
            Event::DisplayMath(latex) => formula::formula_html(latex, true),
            Event::Code(code) if is_name_with_break(code) => {
                Ok(markdown::code_with_break_hints(code))
            }
            Event::Code(_) => return Part::Code,
            Event::Text(_) | Event::Html(_) | Event::InlineHtml(_) => {
                if let Some(position) = source.find('$')
                    && !self.text[..range.start + position].ends_with(['\\', '$'])
                {
                    let fault = "a $ that is no formula is written \\$, and a formula \
                                has its end, pairs of braces, and no HTML around it";
                    self.faults.push((range.start + position, fault.to_owned()));
                }
                return Part::Plain;
            }
            _ => return Part::Plain,
        })
    }

    /// A fence: an include becomes a listing, commands get a caption.
    fn expand_code_block(&mut self, kind: &CodeBlockKind, source: &str) -> Part {
        let CodeBlockKind::Fenced(info) = kind else { return Part::Code };
        let (language, folder) = info.split_once(',').unwrap_or((info, ""));
        let lines: Vec<&str> = source.trim_end().lines().skip(1).collect();
        let content = lines[..lines.len().saturating_sub(1)].join("\n");
        let html = if content.trim_start().starts_with("{{#include") {
            listing::html(language, &content, self.workspace, &mut self.listings)
        } else if language == "console" {
            console_figure_markdown(folder, &content)
        } else {
            return Part::Code;
        };
        Part::Replaced(html.map(|html| format!("\n{html}\n")))
    }

    /// A paragraph that is one directive, or nothing but pictures.
    fn expand_paragraph(
        &mut self,
        events: &Events,
        range: &Range<usize>,
    ) -> Option<Result<String, String>> {
        let source = self.text[range.clone()].trim();
        let (kind, words) = parse_directive(source).unwrap_or_default();
        Some(match (kind, words.trim()) {
            ("figure", name) => figure::html(name),
            ("check", name) => check_form::html(name, self.workspace),
            ("mistakes", step) => mistakes::html(step, self.workspace),
            ("listing", words) => listing::moving_listing_html(words, &mut self.listings),
            ("by-hand", test) => Ok(by_hand_note_html(test)),
            ("rust", words) => markdown::inline_html(words)
                .map(|words| format!("<p class=\"new-rust\"><b>New Rust here</b> {words}</p>\n")),
            ("problem", _) if self.open_problem.or(self.open_box).is_some() => {
                Err("a problem begins after the {{#end}} of another".to_owned())
            }
            ("problem", words) => {
                self.open_problem = Some(range.start);
                problem::opening_html(words)
            }
            ("end", _) => self.end_box(),
            (kind, words) => match folded_box::opening_html(kind, words) {
                Some(_) if self.open_box.is_some() => {
                    Err("a box can't hold another box".to_owned())
                }
                Some(html) => {
                    self.open_box = Some(range.start);
                    html
                }
                None => return self.expand_pictures_alone(events, range),
            },
        })
    }

    /// The end of the open box, and of the problem whose answer it is.
    fn end_box(&mut self) -> Result<String, String> {
        match (self.open_box.take(), self.open_problem.take()) {
            (Some(_), None) => Ok("</details>\n".to_owned()),
            (Some(_), Some(_)) => Ok("</details>\n</section>\n".to_owned()),
            (None, Some(_)) => Err("the problem has no {{#answer}}".to_owned()),
            (None, None) => Err("{{#end}} without a box to end".to_owned()),
        }
    }

    /// A paragraph of nothing but pictures; it says behind them, by `{{#live}}`, that
    /// they answer, or by `{{#live own_scene}}`, what does.
    fn expand_pictures_alone(
        &self,
        events: &Events,
        range: &Range<usize>,
    ) -> Option<Result<String, String>> {
        let mut pictures = vec![];
        let mut remaining = self.text[range.clone()].to_string();
        for (event, inner) in events {
            if let Event::Start(Tag::Image { dest_url, title, .. }) = event
                && inner.start < range.end
            {
                let markdown = &self.text[inner.clone()];
                pictures.push(picture::Picture::from_markdown(markdown, dest_url, title));
                remaining = remaining.replacen(markdown, "", 1);
            }
        }
        let live = parse_directive(remaining.trim()).filter(|(kind, _)| *kind == "live");
        let is_whole = live.is_some() || remaining.trim().is_empty();
        let live = live.map(|(_, name)| name);
        (is_whole && !pictures.is_empty())
            .then(|| picture::figures_html(&pictures, live, self.workspace))
    }

    /// Puts numbers in place, and finds directives that are left.
    fn fill_placeholders(&mut self) {
        let text = self.text;
        let replaced: Vec<_> = self.edits.iter().map(|(range, _)| range.clone()).collect();
        let inside =
            |ranges: &[Range<usize>], position| ranges.iter().any(|one| one.contains(&position));
        for (position, _) in text.match_indices("{{#") {
            if inside(&replaced, position) {
                continue;
            }
            let end = text[position..].find("}}").map_or(text.len(), |end| position + end + 2);
            let minus = if inside(&self.code, position) { "-" } else { "−" };
            let number = numbers::fill_in_text(&text[position..end], minus);
            let number = self.text_or_record_fault(position, number);
            self.edits.push((position..end, number));
        }
    }

    /// The chapter, with every edit made.
    fn apply_edits(mut self) -> (String, Vec<Fault>) {
        self.edits.sort_by_key(|(range, _)| range.start);
        let mut markdown = String::new();
        let mut copied_end = 0;
        for (range, replacement) in &self.edits {
            markdown += &self.text[copied_end..range.start];
            copied_end = range.end;
            // A comma stays on the line of the formula before it.
            let mark = self.text[copied_end..].chars().next();
            match mark.filter(|mark| ",.;:?)".contains(*mark)) {
                Some(mark) if replacement.ends_with("</math>") => {
                    markdown += &format!("<span class=\"tight\">{replacement}{mark}</span>");
                    copied_end += mark.len_utf8();
                }
                _ => markdown += replacement,
            }
        }
        markdown += &self.text[copied_end..];
        self.faults.sort();
        let line = |position: usize| 1 + self.text[..position].matches('\n').count();
        let faults = self.faults.into_iter().map(|(position, what)| (line(position), what));
        (markdown, faults.collect())
    }
}

/// Whether code is a name such as `Ray::at`, which may be broken.
fn is_name_with_break(code: &str) -> bool {
    let in_name = |c: char| c.is_ascii_alphanumeric() || "_:".contains(c);
    code.chars().all(in_name) && code.contains(['_', ':'])
}

/// The name of the test of what was worked out right above, for `{{#by-hand name}}`.
fn by_hand_note_html(test: &str) -> String {
    let name = markdown::code_with_break_hints(test);
    format!("<p class=\"by-hand\" id=\"by-hand-{test}\">Test: {name}</p>\n")
}

/// Commands, under a caption that says in folder folder they are meant, the reader's
/// or ours.
fn console_figure_markdown(folder: &str, commands: &str) -> Result<String, String> {
    let (folder, caption) = match folder {
        "yours" => ("yours", "in your folder"),
        "yours,refused" => ("yours refused", "in your folder"),
        "yours,fails" => ("yours fails", "in your folder"),
        "ours" => ("ours", "in <a href=\"how.html#two-folders\">our folder</a>"),
        _ => return Err("a console is console,yours or console,ours".to_string()),
    };
    Ok(format!(
        "<figure class=\"console\" data-folder=\"{folder}\">\
         <figcaption>{caption}</figcaption>\n\n\
         ```console\n{commands}\n```\n\n</figure>\n"
    ))
}
