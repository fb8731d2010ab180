use html5ever::tendril::StrTendril;
use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{
    BufferQueue, Tag, TagKind, Token, TokenSink, TokenSinkResult, Tokenizer,
};
use std::cell::RefCell;

/// An element of a page, such as a paragraph or a link.
#[derive(Clone, Debug, Default)]
pub struct Element {
    pub tag: String,
    pub attributes: Vec<(String, String)>,
    /// All text in it, that of the elements in it included.
    pub text: String,
    /// The line of the page on which it begins.
    pub line: u64,
    /// The place of the element around it in the list of all.
    pub parent: Option<usize>,
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

/// Every element of a page, in the order in which they begin.
pub fn elements(html: &str) -> Vec<Element> {
    let input = BufferQueue::default();
    input.push_back(StrTendril::from(html));
    let tokenizer = Tokenizer::new(Tree::default(), Default::default());
    let _ = tokenizer.feed(&input);
    tokenizer.end();
    tokenizer.sink.elements.into_inner()
}

/// Elements that have no end.
const VOID: [&str; 8] = ["br", "hr", "img", "input", "link", "meta", "base", "wbr"];

/// The elements so far, and the places of those that are still open.
#[derive(Default)]
struct Tree {
    elements: RefCell<Vec<Element>>,
    open: RefCell<Vec<usize>>,
}

impl Tree {
    fn tag(&self, tag: Tag, line: u64) {
        let (mut elements, mut open) =
            (self.elements.borrow_mut(), self.open.borrow_mut());
        let name = tag.name.to_string();
        if tag.kind == TagKind::EndTag {
            // Closes what was left open in it, too.
            if let Some(at) = open.iter().rposition(|&at| elements[at].tag == name)
            {
                open.truncate(at);
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
        let attributes = attributes.collect();
        let text = String::new();
        elements.push(Element { tag: name, attributes, text, line, parent });
    }
}

impl TokenSink for Tree {
    type Handle = ();

    fn process_token(&self, token: Token, line: u64) -> TokenSinkResult<()> {
        match token {
            Token::TagToken(tag) => {
                let raw = match (tag.kind, &*tag.name) {
                    (TagKind::StartTag, "script") => Some(RawKind::ScriptData),
                    (TagKind::StartTag, "style") => Some(RawKind::Rawtext),
                    _ => None,
                };
                self.tag(tag, line);
                raw.map_or(TokenSinkResult::Continue, TokenSinkResult::RawData)
            }
            Token::CharacterTokens(text) => {
                let mut elements = self.elements.borrow_mut();
                for &at in self.open.borrow().iter() {
                    elements[at].text.push_str(&text);
                }
                TokenSinkResult::Continue
            }
            _ => TokenSinkResult::Continue,
        }
    }
}

#[test]
fn elements_have_their_text_place_and_attributes() {
    let html = "<p>a<br>b <i class=\"x y\">&lt;c</i></p>\n<script>\"<p>\"</script>";
    let elements = elements(html);
    let tags: Vec<_> =
        elements.iter().map(|e| (e.tag.as_str(), e.parent)).collect();
    let (p, in_p) = (None, Some(0));
    assert_eq!(tags, [("p", p), ("br", in_p), ("i", in_p), ("script", None)]);
    let texts: Vec<_> =
        elements.iter().map(|e| (e.text.as_str(), e.line)).collect();
    assert_eq!(texts, [("ab <c", 1), ("", 1), ("<c", 1), ("\"<p>\"", 2)]);
    assert!(elements[2].is("i", "y") && !elements[2].is("i", "z"));
}
