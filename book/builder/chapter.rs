use crate::markdown::{self, parse_directive};
use crate::{
    check_form, figure, folded_box, formula, listing, mistakes, numbers, picture,
};
use mdbook_markdown::pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};
use std::ops::Range;
use std::path::Path;

/// A fault in a chapter: where it is, and a sentence about it.
type Fault = (usize, String);

/// Puts listings, formulas, figures, numbers, pictures and boxes into the `text` of a
/// chapter: gives Markdown as mdBook renders it, and what is wrong on which line.
pub fn expand(text: &str, workspace: &Path) -> (String, Vec<Fault>) {
    let (edits, faults, code, listings, open_box) = Default::default();
    let mut chapter =
        Chapter { text, workspace, edits, faults, code, listings, open_box };
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
        let events = Parser::new_ext(self.text, markdown::options());
        let events: Vec<_> = events.into_offset_iter().collect();
        let mut end_of_last = 0;
        for (index, (event, range)) in events.iter().enumerate() {
            if range.start < end_of_last {
                continue;
            }
            match self.replacement(event, &events[index..], range) {
                Part::Plain => continue,
                Part::Code => self.code.push(range.clone()),
                Part::Replaced(text) => {
                    let text = self.text_or_fault(range.start, text);
                    self.edits.push((range.clone(), text));
                }
            }
            end_of_last = range.end;
        }
        if let Some(at) = self.open_box {
            self.faults.push((at, "the box has no {{#end}}".to_owned()));
        }
    }

    /// The text for a place; an empty one, and a fault, for an error.
    fn text_or_fault(&mut self, at: usize, text: Result<String, String>) -> String {
        text.unwrap_or_else(|fault| {
            self.faults.push((at, fault));
            String::new()
        })
    }

    fn replacement(
        &mut self,
        event: &Event,
        events: &Events,
        range: &Range<usize>,
    ) -> Part {
        let source = &self.text[range.clone()];
        Part::Replaced(match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                return self.expand_fence(kind, source);
            }
            Event::Start(Tag::Paragraph) => {
                match self.expand_paragraph(events, range) {
                    Some(html) => html.map(|html| format!("\n{html}\n")),
                    None => return Part::Plain,
                }
            }
            Event::Start(Tag::Image { dest_url, title, .. }) => {
                let picture = picture::Picture::new(source, dest_url, title);
                picture.html(self.workspace)
            }
            Event::InlineMath(latex) => formula::mathml(latex, false),
            Event::DisplayMath(latex) => formula::mathml(latex, true),
            Event::Code(code) if is_breakable_name(code) => {
                Ok(markdown::code_with_break_hints(code))
            }
            Event::Code(_) => return Part::Code,
            Event::Text(_) | Event::Html(_) | Event::InlineHtml(_) => {
                if let Some(at) = source.find('$')
                    && !self.text[..range.start + at].ends_with(['\\', '$'])
                {
                    let fault = "a $ that is no formula is written \\$, and a formula \
                                has its end, pairs of braces, and no HTML around it";
                    self.faults.push((range.start + at, fault.to_owned()));
                }
                return Part::Plain;
            }
            _ => return Part::Plain,
        })
    }

    /// A fence: an include becomes a listing, commands get a caption.
    fn expand_fence(&mut self, kind: &CodeBlockKind, source: &str) -> Part {
        let CodeBlockKind::Fenced(info) = kind else { return Part::Code };
        let (language, folder) = info.split_once(',').unwrap_or((info, ""));
        let lines: Vec<&str> = source.trim_end().lines().skip(1).collect();
        let content = lines[..lines.len().saturating_sub(1)].join("\n");
        let html = if content.trim_start().starts_with("{{#include") {
            listing::html(language, &content, self.workspace, &mut self.listings)
        } else if language == "console" {
            console_figure(folder, &content)
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
            ("listing", words) => listing::moving(words, &mut self.listings),
            ("by-hand", test) => Ok(by_hand_note(test)),
            ("rust", words) => markdown::inline_html(words).map(|words| {
                format!("<p class=\"new-rust\"><b>New Rust here</b> {words}</p>\n")
            }),
            ("end", _) => match self.open_box.take() {
                Some(_) => Ok("</details>\n".to_owned()),
                None => Err("{{#end}} without a box to end".to_owned()),
            },
            (kind, words) => match folded_box::html(kind, words) {
                Some(_) if self.open_box.is_some() => {
                    Err("a box can't hold another box".to_owned())
                }
                Some(html) => {
                    self.open_box = Some(range.start);
                    html
                }
                None => return self.expand_pictures(events, range),
            },
        })
    }

    /// A paragraph of nothing but pictures; it says behind them, by `{{#live}}`, that
    /// they answer, or by `{{#live own_scene}}`, what does.
    fn expand_pictures(
        &self,
        events: &Events,
        range: &Range<usize>,
    ) -> Option<Result<String, String>> {
        let mut pictures = vec![];
        let mut rest = self.text[range.clone()].to_string();
        for (event, inner) in events {
            if let Event::Start(Tag::Image { dest_url, title, .. }) = event
                && inner.start < range.end
            {
                let markdown = &self.text[inner.clone()];
                pictures.push(picture::Picture::new(markdown, dest_url, title));
                rest = rest.replacen(markdown, "", 1);
            }
        }
        let live = parse_directive(rest.trim()).filter(|(kind, _)| *kind == "live");
        let is_whole = live.is_some() || rest.trim().is_empty();
        let live = live.map(|(_, name)| name);
        (is_whole && !pictures.is_empty())
            .then(|| picture::figure(&pictures, live, self.workspace))
    }

    /// Puts numbers in place, and finds directives that are left.
    fn fill_placeholders(&mut self) {
        let text = self.text;
        let replaced: Vec<_> =
            self.edits.iter().map(|(range, _)| range.clone()).collect();
        let inside = |ranges: &[Range<usize>], at| {
            ranges.iter().any(|one| one.contains(&at))
        };
        for (at, _) in text.match_indices("{{#") {
            if inside(&replaced, at) {
                continue;
            }
            let end = text[at..].find("}}").map_or(text.len(), |end| at + end + 2);
            let minus = if inside(&self.code, at) { "-" } else { "−" };
            let number = numbers::in_text(&text[at..end], minus);
            let number = self.text_or_fault(at, number);
            self.edits.push((at..end, number));
        }
    }

    /// The chapter, with every edit made.
    fn apply_edits(mut self) -> (String, Vec<Fault>) {
        self.edits.sort_by_key(|(range, _)| range.start);
        let mut markdown = String::new();
        let mut from = 0;
        for (range, with) in &self.edits {
            markdown += &self.text[from..range.start];
            from = range.end;
            // A comma stays on the line of the formula before it.
            let mark = self.text[from..].chars().next();
            match mark.filter(|mark| ",.;:?)".contains(*mark)) {
                Some(mark) if with.ends_with("</math>") => {
                    markdown +=
                        &format!("<span class=\"tight\">{with}{mark}</span>");
                    from += mark.len_utf8();
                }
                _ => markdown += with,
            }
        }
        markdown += &self.text[from..];
        self.faults.sort();
        let line = |at: usize| 1 + self.text[..at].matches('\n').count();
        let faults = self.faults.into_iter().map(|(at, what)| (line(at), what));
        (markdown, faults.collect())
    }
}

/// Whether code is a name such as `Ray::at`, which may be broken.
fn is_breakable_name(code: &str) -> bool {
    let in_name = |c: char| c.is_ascii_alphanumeric() || "_:".contains(c);
    code.chars().all(in_name) && code.contains(['_', ':'])
}

/// The name of the test of what was worked out right above, for `{{#by-hand name}}`.
fn by_hand_note(test: &str) -> String {
    let name = markdown::code_with_break_hints(test);
    format!("<p class=\"by-hand\" id=\"by-hand-{test}\">Test: {name}</p>\n")
}

/// Commands, under a caption that says in folder folder they are meant, the reader's
/// or ours.
fn console_figure(folder: &str, commands: &str) -> Result<String, String> {
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
