use crate::element::{Element, elements};

/// A page of the book, as a browser reads it.
#[derive(Clone, Debug)]
pub struct Page {
    /// Its file, such as `step01_rays.html`.
    pub name: String,
    /// Every element of it, in the order in which they begin.
    pub elements: Vec<Element>,
    /// All of its text, with a space at each tag.
    pub text: String,
}

impl Page {
    /// Reads the HTML of the page `name`.
    pub fn new(name: &str, html: &str) -> Self {
        let (elements, text) = elements(html);
        Self { name: name.to_string(), elements, text }
    }

    /// Every element `tag`.
    pub fn all(&self, tag: &str) -> impl Iterator<Item = &Element> {
        self.elements.iter().filter(move |element| element.tag == tag)
    }

    /// The elements around an element, from the inside out.
    pub fn around<'a>(
        &'a self,
        element: &Element,
    ) -> impl Iterator<Item = &'a Element> {
        let mut parent = element.parent;
        std::iter::from_fn(move || {
            let around = &self.elements[parent?];
            parent = around.parent;
            Some(around)
        })
    }

    /// Whether `inner` stands somewhere in `outer`.
    pub fn within(&self, inner: &Element, outer: &Element) -> bool {
        self.around(inner).any(|around| std::ptr::eq(around, outer))
    }

    /// Where an element is, for the sentence about a fault.
    pub fn at(&self, element: &Element) -> String {
        format!("line {} of {}", element.line, self.name)
    }
}
