use html5ever::tendril::StrTendril;
use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{
    BufferQueue, Tag, TagKind, Token, TokenSink, TokenSinkResult, Tokenizer,
};
use std::cell::RefCell;
use std::ops::Range;

/// An element of a page, such as a paragraph or a link.
#[derive(Clone, Debug, Default)]
pub struct Element {
    /// Its name, such as `p`.
    pub tag: String,
    /// The names and values of its attributes.
    pub attributes: Vec<(String, String)>,
    /// All text in it, that of the elements in it included.
    pub text: String,
    /// The line of the page on which it begins.
    pub line: u64,
    /// The place of the element around it in the list of all.
    pub parent: Option<usize>,
    /// Its place in the spaced text of the page.
    pub place: Range<usize>,
}

impl Element {
    /// The value of an attribute, if it is there.
    pub fn get(&self, name: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(known, _)| known == name);
        found.map(|(_, value)| value.as_str())
    }

    /// Whether it is a `tag` of this class.
    pub fn is(&self, tag: &str, class: &str) -> bool {
        let classes = self.get("class").unwrap_or_default();
        self.tag == tag && classes.split_whitespace().any(|one| one == class)
    }
}

/// Every element of a page, in the order in which they begin, and all of its text
/// with a space at each tag.
pub fn elements(html: &str) -> (Vec<Element>, String) {
    let input = BufferQueue::default();
    input.push_back(StrTendril::from(html));
    let tokenizer = Tokenizer::new(Reading::default(), Default::default());
    let _ = tokenizer.feed(&input);
    tokenizer.end();
    let Tree { elements, text, .. } = tokenizer.sink.0.into_inner();
    (elements, text)
}

/// Elements that have no end.
const VOID: [&str; 8] = ["br", "hr", "img", "input", "link", "meta", "base", "wbr"];

/// The elements so far, the places of those that are still open, and the text.
#[derive(Default)]
struct Tree {
    elements: Vec<Element>,
    open: Vec<usize>,
    text: String,
}

impl Tree {
    fn tag(&mut self, tag: Tag, line: u64) {
        let Self { elements, open, text } = self;
        let at = text.len();
        text.push(' ');
        let name = tag.name.to_string();
        if tag.kind == TagKind::EndTag {
            // Closes what was left open in it, too.
            if let Some(last) =
                open.iter().rposition(|&at| elements[at].tag == name)
            {
                open.drain(last..)
                    .for_each(|closed| elements[closed].place.end = at);
            }
            return;
        }
        let parent = open.last().copied();
        if !tag.self_closing && !VOID.contains(&name.as_str()) {
            open.push(elements.len());
        }
        let attributes = tag.attrs.iter().map(|attribute| {
            (attribute.name.local.to_string(), attribute.value.to_string())
        });
        elements.push(Element {
            tag: name,
            attributes: attributes.collect(),
            text: String::new(),
            line,
            parent,
            place: at..at,
        });
    }
}

/// The tokenizer shares what it fills.
#[derive(Default)]
struct Reading(RefCell<Tree>);

impl TokenSink for Reading {
    type Handle = ();

    fn process_token(&self, token: Token, line: u64) -> TokenSinkResult<()> {
        let mut tree = self.0.borrow_mut();
        match token {
            Token::TagToken(tag) => {
                let raw = match (tag.kind, &*tag.name) {
                    (TagKind::StartTag, "script") => Some(RawKind::ScriptData),
                    (TagKind::StartTag, "style") => Some(RawKind::Rawtext),
                    _ => None,
                };
                tree.tag(tag, line);
                raw.map_or(TokenSinkResult::Continue, TokenSinkResult::RawData)
            }
            Token::CharacterTokens(text) => {
                let Tree { elements, open, text: all } = &mut *tree;
                all.push_str(&text);
                open.iter().for_each(|&at| elements[at].text.push_str(&text));
                TokenSinkResult::Continue
            }
            _ => TokenSinkResult::Continue,
        }
    }
}
