mod block;

use crate::page::{self, House, Page};
use crate::{boxes, caption, formula, link, picture, values};
use mdbook_markdown::pulldown_cmark::{Event, LinkType, Parser, Tag};
use std::ops::Range;

/// Reads a chapter once, from top to bottom, and notes what is to be replaced by
/// what.
pub struct Reader<'a> {
    text: &'a str,
    house: &'a House,
    page: Page,
    /// The parts to replace, and the text to put there.
    edits: Vec<(Range<usize>, String)>,
    /// What is wrong, and where.
    mistakes: Vec<(usize, String)>,
    /// The parts that need no second look.
    done: Vec<Range<usize>>,
    /// The parts that are code, where a minus stays a hyphen.
    literal: Vec<Range<usize>>,
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

impl<'a> Reader<'a> {
    /// A reader who has read nothing yet.
    pub fn new(text: &'a str, house: &'a House) -> Self {
        let (edits, mistakes, done, literal) = Default::default();
        Self { text, house, page: Page::default(), edits, mistakes, done, literal }
    }

    /// Reads the Markdown.
    pub fn events(&mut self) {
        let events = Parser::new_ext(self.text, page::options()).into_offset_iter();
        let events: Vec<_> = events.collect();
        let mut from = 0;
        for (index, (event, range)) in events.iter().enumerate() {
            if range.start < from {
                continue;
            }
            let (result, block) = match self.part(event, &events[index..], range) {
                Part::Plain => continue,
                Part::Literal => {
                    self.literal.push(range.clone());
                    from = range.end;
                    continue;
                }
                Part::Inline(result) => (result, false),
                Part::Block(result) => (result, true),
            };
            let before = &self.text[..range.start];
            let at_margin = before.is_empty() || before.ends_with('\n');
            match result {
                Ok(_) if block && !at_margin => {
                    self.mistake(
                        range,
                        "a listing, figure or picture stands at the left margin",
                    );
                }
                Ok(with) => {
                    let with = if block { format!("\n{with}\n") } else { with };
                    self.edits.push((range.clone(), with));
                }
                Err(what) => self.mistake(range, &what),
            }
            self.done.push(range.clone());
            from = range.end;
        }
    }

    /// Notes a mistake in a part: at its directive, if it has one.
    fn mistake(&mut self, range: &Range<usize>, what: &str) {
        let at = self.text[range.clone()].find("{{#").unwrap_or(0);
        self.mistakes.push((range.start + at, what.to_string()));
    }

    fn line(&self, at: usize) -> usize {
        1 + self.text[..at].matches('\n').count()
    }

    fn part(
        &mut self,
        event: &Event,
        events: &Events,
        range: &Range<usize>,
    ) -> Part {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => self.code_block(kind, range),
            Event::Start(Tag::Paragraph) => self.paragraph(events, range),
            Event::Start(Tag::Image { dest_url, title, .. }) => {
                self.page.pictures += 1;
                let picture = picture::Picture::new(
                    &self.text[range.clone()],
                    dest_url,
                    title,
                );
                Part::Inline(picture.html(self.house))
            }
            Event::Start(Tag::Heading { id: Some(id), .. }) => {
                self.id(id.to_string())
            }
            Event::Start(Tag::Heading { .. } | Tag::DefinitionListTitle) => {
                let inside =
                    events.iter().take_while(|(_, inner)| inner.start < range.end);
                let text = inside
                    .fold(String::new(), |text, (event, _)| text + &plain(event));
                self.id(link::unique(&link::id_of(&text), &self.page.ids))
            }
            Event::Start(Tag::Link { link_type, dest_url, .. }) => {
                if *link_type != LinkType::Email {
                    self.page
                        .links
                        .push((self.line(range.start), dest_url.to_string()));
                }
                Part::Plain
            }
            Event::InlineMath(latex) => self.formula(latex, false),
            Event::DisplayMath(latex) => self.formula(latex, true),
            Event::Text(_) => self.dollars(range),
            Event::Code(code) => name(code),
            Event::Html(html) | Event::InlineHtml(html) => self.html(html, range),
            _ => Part::Plain,
        }
    }

    fn id(&mut self, id: String) -> Part {
        self.page.ids.push(id);
        Part::Plain
    }

    fn formula(&mut self, latex: &str, display: bool) -> Part {
        self.page.formulas += 1;
        let latex = values::fill(latex, |value| value.to_string());
        Part::Inline(latex.and_then(|latex| formula::mathml(&latex, display)))
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
            self.mistakes.push((at, what.to_string()));
        }
        Part::Plain
    }

    fn html(&mut self, html: &str, range: &Range<usize>) -> Part {
        self.page.ids.extend(link::attributes(html, "id"));
        let line = self.line(range.start);
        let targets = link::attributes(html, "href").into_iter();
        self.page.links.extend(targets.map(|target| (line, target)));
        let wrong = |what: &str| Part::Inline(Err(what.to_string()));
        match html {
            html if html.contains("<img") => {
                wrong("write a picture as ![what it shows](pictures/…)")
            }
            html if html.contains("<pre") => {
                wrong("code stands in a fence, not in HTML")
            }
            html if html.contains('$') => {
                wrong("no formula is read in a line of HTML")
            }
            _ => Part::Plain,
        }
    }

    /// Puts values in place, and finds directives that are left.
    pub fn directives(&mut self) {
        let inside = |ranges: &[Range<usize>], at| {
            ranges.iter().any(|range| range.contains(&at))
        };
        let text = self.text;
        for (at, _) in
            text.match_indices("{{#").filter(|(at, _)| !inside(&self.done, *at))
        {
            let end = text[at..].find("}}").map_or(text.len(), |end| at + end + 2);
            let literal = inside(&self.literal, at);
            match values::fill(&text[at..end], |value| {
                caption::minus(value, literal)
            }) {
                Ok(value) => self.edits.push((at..end, value)),
                Err(what) => self.mistakes.push((at, what)),
            }
        }
        self.mistakes.extend(boxes::balanced(text).err());
    }

    /// The page, with every edit made.
    pub fn finish(mut self) -> Page {
        self.edits.sort_by_key(|(range, _)| range.start);
        let mut from = 0;
        for (range, with) in &self.edits {
            self.page.markdown += &self.text[from..range.start];
            from = range.end;
            // A comma stays on the line of the formula before it.
            let mark =
                self.text[from..].chars().next().filter(|c| ",.;:?)".contains(*c));
            match mark.filter(|_| with.ends_with("</math>")) {
                Some(mark) => {
                    self.page.markdown +=
                        &format!("<span class=\"tight\">{with}{mark}</span>");
                    from += mark.len_utf8();
                }
                None => self.page.markdown += with,
            }
        }
        self.page.markdown += &self.text[from..];
        self.mistakes.sort();
        self.page.mistakes = self
            .mistakes
            .iter()
            .map(|(at, what)| (self.line(*at), what.clone()))
            .collect();
        self.page
    }
}

/// A name in code, which a narrow column may break after :: and _ and nowhere else.
fn name(code: &str) -> Part {
    let in_name = |c: char| c.is_ascii_alphanumeric() || "_:".contains(c);
    if !code.chars().all(in_name) || !code.contains(['_', ':']) {
        return Part::Literal;
    }
    let code = code.replace("::", "::<wbr>").replace('_', "&#95;<wbr>");
    Part::Inline(Ok(format!("<code>{code}</code>")))
}

/// The text of an event in a heading, as mdBook reads it for the heading's id.
fn plain(event: &Event) -> String {
    match event {
        Event::Text(text) | Event::Code(text) => text.to_string(),
        Event::InlineMath(latex) => {
            formula::mathml(latex, false).map_or(String::new(), |mathml| {
                let parts =
                    mathml.split('<').filter_map(|part| part.split_once('>'));
                parts.map(|(_, text)| text).collect()
            })
        }
        _ => String::new(),
    }
}
