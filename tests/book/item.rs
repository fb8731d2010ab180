//! The items of the five crates, by their names.

use book::Files;
use std::collections::{BTreeMap, BTreeSet};
use syn::visit::{self, Visit};
use syn::{Field, Ident, ImplItem, Item, Type, Variant};

/// Every function, type and constant by its name, and every function, field and
/// variant of a type as `Type::member`.
#[derive(Default)]
pub struct Items {
    /// The words in each of them.
    words: BTreeMap<String, BTreeSet<String>>,
    /// The name of the item that is being read.
    name: String,
}

impl Items {
    /// Reads all files that are Rust.
    pub fn of(source: &Files) -> Self {
        let mut items = Self::default();
        let files = source.texts(".rs").map(|(_, text)| syn::parse_file(text));
        files.flatten().for_each(|file| items.visit_file(&file));
        items
    }

    /// Whether there is an item `name`.
    pub fn has(&self, name: &str) -> bool {
        self.words.contains_key(name)
    }

    /// Whether the function `function` speaks of a variable `name`.
    pub fn has_variable(&self, function: &str, name: &str) -> bool {
        self.words.get(function).is_some_and(|words| words.contains(name))
    }

    /// Reads what is inside an item of this name, if it has one.
    fn inside(&mut self, name: Option<&Ident>, read: impl FnOnce(&mut Self)) {
        let Some(name) = name else { return read(self) };
        let colons = if self.name.is_empty() { "" } else { "::" };
        let inner = format!("{}{colons}{name}", self.name);
        self.words.entry(inner.clone()).or_default();
        let outer = std::mem::replace(&mut self.name, inner);
        read(self);
        self.name = outer;
    }
}

impl<'a> Visit<'a> for Items {
    fn visit_item(&mut self, item: &'a Item) {
        let name = match item {
            Item::Fn(item) => Some(&item.sig.ident),
            Item::Struct(item) => Some(&item.ident),
            Item::Enum(item) => Some(&item.ident),
            Item::Const(item) => Some(&item.ident),
            Item::Impl(item) => match &*item.self_ty {
                Type::Path(of) => of.path.segments.last().map(|part| &part.ident),
                _ => None,
            },
            _ => None,
        };
        self.inside(name, |items| visit::visit_item(items, item));
    }

    fn visit_impl_item(&mut self, item: &'a ImplItem) {
        let ImplItem::Fn(function) = item else { return };
        let name = Some(&function.sig.ident);
        self.inside(name, |items| visit::visit_impl_item(items, item));
    }

    fn visit_field(&mut self, field: &'a Field) {
        self.inside(field.ident.as_ref(), |items| visit::visit_field(items, field));
    }

    fn visit_variant(&mut self, variant: &'a Variant) {
        self.inside(Some(&variant.ident), |_| {});
    }

    fn visit_ident(&mut self, word: &'a Ident) {
        if let Some(words) = self.words.get_mut(&self.name) {
            words.insert(word.to_string());
        }
    }
}

#[test]
fn items_are_found_by_their_names() {
    let items = Items::of(&crate::source::SOURCE);
    let there = "Ray Ray::start Ray::at Roots Roots::Two Roots::first_hit quadratic \
                 SPHERE Phong::sum AspectRatio::width polished Surface::of";
    for name in there.split(' ') {
        assert!(items.has(name), "{name}");
    }
    let not_there = "Way Ray::end Ray::radius Sphere::start Ray::self quad";
    for name in not_there.split(' ') {
        assert!(!items.has(name), "{name}");
    }
    assert!(items.has_variable("Row::new", "v_0"));
    assert!(items.has_variable("quadratic", "b"));
    assert!(!items.has_variable("quadratic", "v_0"));
}
