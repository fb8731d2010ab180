//! The finished book: its files, and its pages parsed into elements and text.

use crate::Files;
use anyhow::Result;
use html5ever::tendril::StrTendril;
use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{
    BufferQueue, TagKind, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts,
};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::iter;
use std::ops::Range;
use std::path::Path;

/// The finished book.
#[derive(Clone, Debug)]
pub struct Site {
    /// All files of the book.
    pub files: Files,
    /// All pages of the book, keyed by file name.
    pub pages: BTreeMap<String, Page>,
}

impl Site {
    /// Reads a book that has been built into `folder`.
    pub fn read(folder: &Path) -> Result<Self> {
        Ok(Self::parse(Files::read(folder)?))
    }

    /// Parses the pages among these files.
    pub fn parse(files: Files) -> Self {
        let texts = files.texts_with_suffix(".html");
        let pages = texts.map(|(name, html)| (name.to_owned(), Page::parse(name, html))).collect();
        Self { files, pages }
    }

    /// The pages in the order of the table of contents.
    ///
    /// `index.html` is left out, since it repeats the first page.
    pub fn pages_in_order(&self) -> Vec<&Page> {
        let page = &self.pages["index.html"];
        let contents = page.elements.iter().find(|element| element.attr("id") == Some("contents"));
        let links = page.descendants(contents.expect("the page has a table of contents")).iter();
        let names = links.filter_map(|link| link.attr("href"));
        names.filter_map(|name| self.pages.get(name)).collect()
    }
}

/// A page of the book: its elements, and its text.
#[derive(Clone, Debug)]
pub struct Page {
    /// The file name of the page, such as `step01_rays.html`.
    pub name: String,
    /// The elements, from top to bottom. An element comes before the elements inside it.
    pub elements: Vec<Element>,
    /// The text of the page, including the contents of scripts and styles.
    text: String,
}

/// An element of a page.
#[derive(Clone, Debug)]
pub struct Element {
    /// The name of the element's tag, such as `figure`.
    pub tag: String,
    /// The names and values of its attributes.
    pub attributes: Vec<(String, String)>,
    /// The elements inside this element, as a range of indices into [`Page::elements`].
    descendants: Range<usize>,
    /// The byte range of this element's text within the page's text.
    pub text: Range<usize>,
}

impl Element {
    /// The value of an attribute, or None if the element doesn't have that attribute.
    pub fn attr(&self, name: &str) -> Option<&str> {
        let value = self.attributes.iter().find(|(key, _)| key == name);
        value.map(|(_, value)| &**value)
    }
}

impl Page {
    /// Parses the HTML of the page `name`. An element without an end tag counts as empty.
    pub fn parse(name: &str, html: &str) -> Self {
        let mut elements: Vec<Element> = vec![];
        let mut text = String::new();
        let mut open: Vec<usize> = vec![];
        for (token, _) in tokens(html) {
            // Add a space, so that words on different lines or in different table cells aren't
            // joined.
            if matches!(&token, Token::TagToken(tag) if matches!(&*tag.name, "br" | "td" | "th")) {
                text.push(' ');
            }
            match token {
                Token::TagToken(tag) if tag.kind == TagKind::StartTag => {
                    open.push(elements.len());
                    let next_index = elements.len() + 1;
                    let attributes = tag.attrs.into_iter();
                    elements.push(Element {
                        tag: tag.name.to_string(),
                        attributes: attributes
                            .map(|attr| (attr.name.local.to_string(), attr.value.to_string()))
                            .collect(),
                        descendants: next_index..next_index,
                        text: text.len()..text.len(),
                    });
                }
                Token::TagToken(tag) => {
                    let is_start = |&index: &usize| elements[index].tag == *tag.name;
                    if let Some(level) = open.iter().rposition(is_start) {
                        let end = elements.len();
                        let element = &mut elements[open[level]];
                        (element.descendants.end, element.text.end) = (end, text.len());
                        open.truncate(level);
                    }
                }
                Token::CharacterTokens(characters) => text += &characters,
                _ => {}
            }
        }
        Self { name: name.to_owned(), elements, text }
    }

    /// The values of an attribute on all elements of the page.
    pub fn attribute_values(&self, attribute: &str) -> impl Iterator<Item = &str> {
        self.elements.iter().filter_map(move |element| element.attr(attribute))
    }

    /// All elements inside an element, from top to bottom.
    pub fn descendants(&self, element: &Element) -> &[Element] {
        &self.elements[element.descendants.clone()]
    }

    /// The text of an element, including the text of the elements inside it.
    pub fn text(&self, element: &Element) -> &str {
        &self.text[element.text.clone()]
    }

    /// The text of an element, without the text of any element for which `is_left_out` returns
    /// true.
    pub fn text_without(
        &self,
        element: &Element,
        is_left_out: impl Fn(&Element) -> bool,
    ) -> String {
        let mut text = String::new();
        let mut start = element.text.start;
        let candidates = iter::once(element).chain(self.descendants(element));
        for left_out in candidates.filter(|element| is_left_out(element)) {
            text += self.text.get(start..left_out.text.start).unwrap_or_default();
            start = start.max(left_out.text.end);
        }
        text + &self.text[start..element.text.end]
    }

    /// Returns the location of an element, for a message about a fault: the name of the page, and
    /// the element's id. If the element has no id, uses the nearest id before the element. If there
    /// is no such id either, returns only the name of the page.
    pub fn address_for_fault(&self, element: &Element) -> String {
        let mut elements = self.elements[..element.descendants.start].iter().rev();
        let id = elements.find_map(|element| element.attr("id"));
        id.map_or(self.name.clone(), |id| format!("{}#{id}", self.name))
    }
}

/// Whether elements with this tag have neither content nor an end tag.
pub fn is_void(tag: &str) -> bool {
    matches!(
        tag,
        "base" | "br" | "col" | "hr" | "img" | "input" | "link" | "meta" | "source" | "wbr"
    )
}

/// Splits the HTML of a page into tokens, such as tags and text. Each token comes with its line
/// number.
pub fn tokens(html: &str) -> Vec<(Token, u64)> {
    let queue = BufferQueue::default();
    queue.push_back(StrTendril::from(html));
    let tokenizer = Tokenizer::new(TokenCollector::default(), TokenizerOpts::default());
    let _ = tokenizer.feed(&queue);
    tokenizer.end();
    tokenizer.sink.0.take()
}

/// Collects the tokens. Tells the tokenizer that the contents of scripts and styles aren't HTML.
#[derive(Default)]
struct TokenCollector(RefCell<Vec<(Token, u64)>>);

impl TokenSink for TokenCollector {
    type Handle = ();

    fn process_token(&self, token: Token, line: u64) -> TokenSinkResult<()> {
        let is_raw = matches!(&token, Token::TagToken(tag)
            if tag.kind == TagKind::StartTag && matches!(&*tag.name, "script" | "style"));
        self.0.borrow_mut().push((token, line));
        if is_raw { TokenSinkResult::RawData(RawKind::Rawtext) } else { TokenSinkResult::Continue }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HTML: &str = "<main id=\"a\"><p>one <b>two</b></p><style>p > b {}</style><img src=\"c\">\
                        <table><td>x</td><td>y</td></table></main>";

    #[test]
    fn parsed_page_has_its_elements_and_their_texts() {
        let page = Page::parse("a.html", HTML);
        let tags: Vec<_> = page.elements.iter().map(|element| &*element.tag).collect();
        assert_eq!(tags, ["main", "p", "b", "style", "img", "table", "td", "td"]);
        assert_eq!(page.text(&page.elements[1]), "one two");
        assert_eq!(page.text(&page.elements[3]), "p > b {}");
        assert_eq!(page.text(&page.elements[5]).trim(), "x  y");
        assert_eq!(page.descendants(&page.elements[1]).len(), 1);
        assert_eq!(page.attribute_values("src").collect::<Vec<_>>(), ["c"]);
    }

    #[test]
    fn text_of_some_elements_can_be_left_out() {
        let page = Page::parse("a.html", HTML);
        let text =
            page.text_without(&page.elements[0], |element| ["b", "style"].contains(&&*element.tag));
        assert_eq!(text.split_whitespace().collect::<Vec<_>>(), ["one", "x", "y"]);
    }

    #[test]
    fn fault_is_located_by_the_nearest_id_before_it() {
        let page = Page::parse("a.html", HTML);
        assert_eq!(page.address_for_fault(&page.elements[4]), "a.html#a");
    }
}
