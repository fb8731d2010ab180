use crate::markdown::{self, directive};
use crate::{
    boxes, check, excerpt, figure, formula, mistakes, number, picture, values,
};
use mdbook_markdown::pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};
use std::ops::Range;
use std::path::Path;

/// A chapter with everything in place.
#[derive(Debug)]
pub struct Chapter {
    /// Markdown that any program of mdBook's kind renders.
    pub markdown: String,
    /// What is wrong: the line, and what it is.
    pub faults: Vec<(usize, String)>,
}

/// Puts listings, formulas, figures, values, pictures and boxes into the `text` of
/// a chapter.
pub fn expand(text: &str, workspace: &Path) -> Chapter {
    let (edits, faults, literal, shown) = Default::default();
    let mut draft = Draft { text, workspace, edits, faults, literal, shown };
    draft.events();
    draft.values();
    draft.finish()
}

/// A chapter as it is read once, from top to bottom.
struct Draft<'a> {
    text: &'a str,
    workspace: &'a Path,
    /// The parts to replace, and the text to put there.
    edits: Vec<(Range<usize>, String)>,
    /// What is wrong, and where.
    faults: Vec<(usize, String)>,
    /// The parts that are code, where a minus stays a hyphen.
    literal: Vec<Range<usize>>,
    /// The listings so far, by their ids.
    shown: Vec<String>,
}

/// What a part of a chapter turns out to be.
enum Part {
    /// Something that stays as it is.
    Plain,
    /// Code, which stays as it is, and in which nothing but values is looked for.
    Literal,
    /// A part of a line, to be replaced.
    Inline(Result<String, String>),
    /// A block at the left margin, to be replaced.
    Block(Result<String, String>),
}

type Events<'a> = [(Event<'a>, Range<usize>)];

impl Draft<'_> {
    fn events(&mut self) {
        let events = Parser::new_ext(self.text, markdown::options());
        let events: Vec<_> = events.into_offset_iter().collect();
        let mut from = 0;
        for (index, (event, range)) in events.iter().enumerate() {
            if range.start < from {
                continue;
            }
            let with = match self.part(event, &events[index..], range) {
                Part::Plain => continue,
                Part::Literal => {
                    self.literal.push(range.clone());
                    from = range.end;
                    continue;
                }
                Part::Inline(with) => with,
                Part::Block(with) => with.and_then(|with| self.block(with, range)),
            };
            if let Err(what) = &with {
                let at = self.text[range.clone()].find("{{#").unwrap_or(0);
                self.faults.push((range.start + at, what.clone()));
            }
            self.edits.push((range.clone(), with.unwrap_or_default()));
            from = range.end;
        }
    }

    fn block(&self, html: String, range: &Range<usize>) -> Result<String, String> {
        let before = &self.text[..range.start];
        let at_margin = before.is_empty() || before.ends_with('\n');
        let what = "a listing, figure or picture stands at the left margin";
        at_margin.then(|| format!("\n{html}\n")).ok_or(what.to_string())
    }

    fn part(
        &mut self,
        event: &Event,
        events: &Events,
        range: &Range<usize>,
    ) -> Part {
        let source = &self.text[range.clone()];
        match event {
            Event::Start(Tag::CodeBlock(kind)) => self.code_block(kind, source),
            Event::Start(Tag::Paragraph) => self.paragraph(events, range),
            Event::Start(Tag::Image { dest_url, title, .. }) => {
                let picture = picture::Picture::new(source, dest_url, title);
                Part::Inline(picture.html(self.workspace))
            }
            Event::InlineMath(latex) => Part::Inline(formula(latex, false)),
            Event::DisplayMath(latex) => Part::Inline(formula(latex, true)),
            Event::Text(_) => self.dollars(range),
            Event::Code(code) => {
                let in_name =
                    |c: char| c.is_ascii_alphanumeric() || "_:".contains(c);
                if !code.chars().all(in_name) || !code.contains(['_', ':']) {
                    return Part::Literal;
                }
                Part::Inline(Ok(markdown::name(code)))
            }
            Event::Html(html) | Event::InlineHtml(html) => match wrong_html(html) {
                Some(what) => Part::Inline(Err(what.to_string())),
                None => Part::Plain,
            },
            _ => Part::Plain,
        }
    }

    /// A fence: an include becomes a listing, other code is checked for its
    /// language.
    fn code_block(&mut self, kind: &CodeBlockKind, source: &str) -> Part {
        let wrong = |what: &str| Part::Inline(Err(what.to_string()));
        let CodeBlockKind::Fenced(info) = kind else {
            return wrong("code stands in a fence that names its language");
        };
        let language = info.split([',', ' ']).next().unwrap_or_default();
        let lines: Vec<&str> = source.trim_end().lines().skip(1).collect();
        let content = lines[..lines.len().saturating_sub(1)].join("\n");
        if content.trim_start().starts_with("{{#include") {
            let ids = &mut self.shown;
            return Part::Block(excerpt::html(
                language,
                &content,
                self.workspace,
                ids,
            ));
        }
        match language.to_lowercase().as_str() {
            "console" => Part::Block(console(info, &content)),
            "" => wrong("the fence names no language; text is one, too"),
            "rust" | "rs" => {
                wrong("Rust in the book is one {{#include …}} and nothing else")
            }
            _ => Part::Literal,
        }
    }

    /// A paragraph: a figure, a form, the mistakes of a step, the name of a test, the edge of a box, pictures,
    /// or text.
    fn paragraph(&mut self, events: &Events, range: &Range<usize>) -> Part {
        let (kind, words) =
            directive(self.text[range.clone()].trim()).unwrap_or_default();
        let (pictures, live) = self.pictures(events, range);
        Part::Block(match (kind, &pictures[..]) {
            ("figure", _) => figure::html(words.trim()),
            ("check", _) => check::html(words.trim(), self.workspace),
            ("mistakes", _) => mistakes::html(words.trim(), self.workspace),
            ("listing", _) => excerpt::moving(words.trim(), &mut self.shown),
            ("by-hand", _) => Ok(by_hand(words.trim())),
            ("rust", _) => markdown::inline(words).map(|words| new_rust(&words)),
            (kind, []) => match boxes::html(kind, words) {
                Some(html) => html,
                None => return Part::Plain,
            },
            (_, pictures) => {
                picture::figure(pictures, live.as_deref(), self.workspace)
            }
        })
    }

    /// The pictures of a paragraph of nothing but pictures, and whether it says
    /// behind them, by `{{#live}}`, that they answer, or by `{{#live own_scene}}`,
    /// what does.
    fn pictures(
        &self,
        events: &Events,
        range: &Range<usize>,
    ) -> (Vec<picture::Picture>, Option<String>) {
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
        let live = directive(rest.trim()).filter(|(kind, _)| *kind == "live");
        let is_whole = live.is_some() || rest.trim().is_empty();
        let live = live.map(|(_, name)| name.to_string());
        (if is_whole { pictures } else { vec![] }, live)
    }

    /// Finds dollar signs that are no formula.
    fn dollars(&mut self, range: &Range<usize>) -> Part {
        if let Some(at) =
            self.text[range.clone()].find('$').map(|at| range.start + at)
            && !self.text[..at].ends_with(['\\', '$'])
        {
            let what = if self.text[at..].starts_with("$$") {
                "a leftover $$: its formula has no end, or its braces don't match"
            } else {
                "a lone $: write \\$ where no formula is meant"
            };
            self.faults.push((at, what.to_string()));
        }
        Part::Plain
    }

    /// Puts values in place, and finds directives that are left.
    fn values(&mut self) {
        let text = self.text;
        let done: Vec<_> =
            self.edits.iter().map(|(range, _)| range.clone()).collect();
        let inside = |ranges: &[Range<usize>], at| {
            ranges.iter().any(|range| range.contains(&at))
        };
        for (at, _) in text.match_indices("{{#") {
            if inside(&done, at) {
                continue;
            }
            let end = text[at..].find("}}").map_or(text.len(), |end| at + end + 2);
            // In code, a minus stays a hyphen.
            let minus = if inside(&self.literal, at) { "-" } else { "−" };
            let filled = values::fill(&text[at..end], |v| v.replace('-', minus));
            match filled.and_then(|text| number::fill(&text)) {
                Ok(value) => self.edits.push((at..end, value)),
                Err(what) => self.faults.push((at, what)),
            }
        }
        self.faults.extend(boxes::balanced(text).err());
    }

    /// The chapter, with every edit made.
    fn finish(mut self) -> Chapter {
        self.edits.sort_by_key(|(range, _)| range.start);
        let mut markdown = String::new();
        let mut from = 0;
        for (range, with) in &self.edits {
            markdown += &self.text[from..range.start];
            from = range.end;
            // A comma stays on the line of the formula before it.
            let mark =
                self.text[from..].chars().next().filter(|c| ",.;:?)".contains(*c));
            match mark.filter(|_| with.ends_with("</math>")) {
                Some(mark) => {
                    markdown +=
                        &format!("<span class=\"tight\">{with}{mark}</span>");
                    from += mark.len_utf8();
                }
                None => markdown += with,
            }
        }
        markdown += &self.text[from..];
        self.faults.sort();
        let line = |at: usize| 1 + self.text[..at].matches('\n').count();
        let faults = self.faults.into_iter().map(|(at, what)| (line(at), what));
        Chapter { markdown, faults: faults.collect() }
    }
}

fn formula(latex: &str, display: bool) -> Result<String, String> {
    let latex = values::fill(latex, |value| value.to_string())?;
    formula::mathml(&latex, display)
}

/// The name of the test of what was worked out right above, for `{{#by-hand name}}`.
fn by_hand(test: &str) -> String {
    let name = markdown::name(test);
    format!("<p class=\"by-hand\" id=\"by-hand-{test}\">Test: {name}</p>\n")
}

/// What a week of Rust does not teach, right below where it first appears, for
/// `{{#rust words}}`.
fn new_rust(words: &str) -> String {
    format!("<p class=\"new-rust\"><b>New Rust here</b> {words}</p>\n")
}

/// Commands, under a caption that says in whose folder they are meant, the reader's
/// or ours.
fn console(info: &str, commands: &str) -> Result<String, String> {
    let (whose, caption) = match info.split_once(',') {
        Some((_, "yours")) => ("yours", "in your folder"),
        Some((_, "yours,refused")) => ("yours refused", "in your folder"),
        Some((_, "ours")) => {
            ("ours", "in <a href=\"how.html#two-folders\">our folder</a>")
        }
        _ => return Err("a console is console,yours or console,ours".to_string()),
    };
    Ok(format!(
        "<figure class=\"console\" data-folder=\"{whose}\">\
         <figcaption>{caption}</figcaption>\n\n\
         ```console\n{commands}\n```\n\n</figure>\n"
    ))
}

/// What is wrong with a piece of HTML in a chapter.
fn wrong_html(html: &str) -> Option<&'static str> {
    let wrong = [
        ("<img", "write a picture as ![what it shows](pictures/…)"),
        ("<pre", "code stands in a fence, not in HTML"),
        ("$", "no formula is read in a line of HTML"),
    ];
    wrong.iter().find(|(part, _)| html.contains(part)).map(|(_, what)| *what)
}
