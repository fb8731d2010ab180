//! The items of the five crates, by their names.

use book::Files;
use std::collections::{BTreeMap, BTreeSet};
use syn::visit_mut::{self, VisitMut};
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
        files.flatten().for_each(|mut file| items.visit_file_mut(&mut file));
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
    fn inside(&mut self, name: Option<Ident>, read: impl FnOnce(&mut Self)) {
        let Some(name) = name else { return read(self) };
        let colons = if self.name.is_empty() { "" } else { "::" };
        let inner = format!("{}{colons}{name}", self.name);
        self.words.entry(inner.clone()).or_default();
        let outer = std::mem::replace(&mut self.name, inner);
        read(self);
        self.name = outer;
    }
}

impl VisitMut for Items {
    fn visit_item_mut(&mut self, item: &mut Item) {
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
        let name = name.cloned();
        self.inside(name, |items| visit_mut::visit_item_mut(items, item));
    }

    fn visit_impl_item_mut(&mut self, item: &mut ImplItem) {
        let ImplItem::Fn(function) = item else { return };
        let name = Some(function.sig.ident.clone());
        self.inside(name, |items| visit_mut::visit_impl_item_mut(items, item));
    }

    fn visit_field_mut(&mut self, field: &mut Field) {
        let name = field.ident.clone();
        self.inside(name, |items| visit_mut::visit_field_mut(items, field));
    }

    fn visit_variant_mut(&mut self, variant: &mut Variant) {
        self.inside(Some(variant.ident.clone()), |_| {});
    }

    fn visit_ident_mut(&mut self, word: &mut Ident) {
        if let Some(words) = self.words.get_mut(&self.name) {
            words.insert(word.to_string());
        }
    }
}

#[test]
fn items_are_found_by_their_names() {
    let items = Items::of(&super::source::SOURCE);
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
