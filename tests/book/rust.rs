//! What a week of Rust does not teach has a note below the listing in which it first
//! appears.

use super::built::BOOK;
use super::listing::Listing;
use super::{assert_found, assert_none};
use book::{Page, Site};

/// How such a thing looks in code, and what the note about it says.
const NEW: [(&str, &str); 28] = [
    ("|i, j|", "closure"),
    ("#[derive(", "derive"),
    ("impl Fn(", "impl Fn"),
    ("rotate_left", "rotate_left"),
    (".ok_or(", "ok_or"),
    ("#[arg(", "#[arg"),
    (": fn(", "a plain function"),
    ("let _ =", "let _ ="),
    ("?;", "?"),
    (".filter(", "filter"),
    ("(_) | Roots::", "“or”"),
    (") if ", "guard"),
    ("const SPHERE", "const fn"),
    ("<M>", "generic"),
    ("<'a", "lifetime"),
    ("        && ", "let chain"),
    ("let [", "takes an array apart"),
    (" else {\n            return", "let … else"),
    ("..scene", "struct update"),
    ("#[divan::", "divan::bench"),
    ("..=", "..="),
    ("&'static str", "&'static str"),
    ("= *point", "*point"),
    ("impl FromStr", "FromStr"),
    (".and_then(", "and_then"),
    ("< *k", "*k"),
    (".collect()", "collect"),
    ("::splat(", "splat"),
];

/// Each of them that has no note where it first appears, or no place in the book.
fn faults(book: &Site) -> Vec<String> {
    let pages =
        book.chapters().into_iter().filter(|page| page.name != "solutions.html");
    let listings: Vec<_> = pages
        .flat_map(|page| Listing::all(page).map(move |one| (page, one)))
        .collect();
    let faults = NEW.iter().filter_map(|(code, word)| {
        let Some((page, first)) =
            listings.iter().find(|(_, one)| one.code.contains(code))
        else {
            return Some(format!("No listing has {code:?}."));
        };
        let has_note = notes(page, first).any(|note| note.contains(word));
        (!has_note).then(|| {
            format!("No note below the listing on {} tells of {word:?}.", first.at)
        })
    });
    faults.collect()
}

/// The notes below a listing, above the next heading.
fn notes<'a>(page: &'a Page, listing: &Listing) -> impl Iterator<Item = &'a str> {
    let after = page.elements.iter().skip_while(|e| page.at(e) != listing.at);
    let section = after.take_while(|e| !["h2", "h3"].contains(&e.tag.as_str()));
    section.filter(|e| e.is("p", "new-rust")).map(|note| note.text.as_str())
}

#[test]
fn what_is_new_in_rust_is_told_where_it_first_appears() {
    assert_none(&faults(&BOOK));
}

#[test]
fn a_missing_note_is_found() {
    let book = BOOK.with("step03_nearest.html", "let chain", "chain");
    assert_found(&faults(&book), &["step03_nearest.html", "let chain"]);
}
