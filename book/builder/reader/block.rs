use super::{Events, Part, Reader};
use crate::{boxes, figures, listing, picture};
use mdbook_markdown::pulldown_cmark::{CodeBlockKind, Event, Tag, TagEnd};
use std::ops::Range;

impl Reader<'_> {
    /// A fence: an include becomes a listing, other code is checked for its
    /// language.
    pub(super) fn code_block(
        &mut self,
        kind: &CodeBlockKind,
        range: &Range<usize>,
    ) -> Part {
        let wrong = |what: &str| Part::Inline(Err(what.to_string()));
        let CodeBlockKind::Fenced(info) = kind else {
            return wrong("code stands in a fence that names its language");
        };
        let lines: Vec<&str> =
            self.text[range.clone()].trim_end().lines().collect();
        let content = lines
            .get(1..lines.len().saturating_sub(1))
            .unwrap_or_default()
            .join("\n");
        let language = info.split([',', ' ']).next().unwrap_or_default();
        if listing::is_include(&content) {
            return Part::Block(listing::read(language, &content, self.house).map(
                |listing| {
                    self.page.listings += 1;
                    let id =
                        Some(listing.id()).filter(|id| !self.page.ids.contains(id));
                    self.page.ids.extend(id.clone());
                    listing.html(id.as_deref())
                },
            ));
        }
        match language.to_lowercase().as_str() {
            "" => wrong("the fence names no language; text is one, too"),
            "rust" | "rs" => {
                wrong("Rust in the book is one {{#include …}} and nothing else")
            }
            _ => Part::Literal,
        }
    }

    /// A paragraph: a figure, the edge of a box, pictures, or text.
    pub(super) fn paragraph(
        &mut self,
        events: &Events,
        range: &Range<usize>,
    ) -> Part {
        let source = self.text[range.clone()].trim();
        if let Some(name) = figures::directive(source) {
            self.page.figures += 1;
            self.page.ids.push(format!("figure-{name}"));
            return Part::Block(figures::html(name));
        }
        if let Some(html) = boxes::directive(source) {
            return Part::Block(html);
        }
        let pictures = self.pictures(events, range);
        if pictures.is_empty() {
            return Part::Plain;
        }
        self.page.pictures += pictures.len();
        Part::Block(picture::figure(&pictures, self.house))
    }

    /// The pictures of a paragraph of nothing but pictures.
    fn pictures(
        &self,
        events: &Events,
        range: &Range<usize>,
    ) -> Vec<picture::Picture> {
        let mut pictures = vec![];
        let mut inside = false;
        for (event, inner) in
            events.iter().take_while(|(_, inner)| inner.start < range.end).skip(1)
        {
            match event {
                Event::Start(Tag::Image { dest_url, title, .. }) => {
                    inside = true;
                    let markdown = &self.text[inner.clone()];
                    pictures.push(picture::Picture::new(markdown, dest_url, title));
                }
                Event::End(TagEnd::Image) => inside = false,
                Event::SoftBreak | Event::End(TagEnd::Paragraph) => {}
                _ if inside => {}
                _ => return vec![],
            }
        }
        pictures
    }
}
