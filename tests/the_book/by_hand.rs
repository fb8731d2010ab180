//! What a chapter works out by hand, the step's tests by hand hold: each of them is named
//! right below its numbers.

use super::assert_none;
use super::built::book;
use super::source::SOURCE;
use super::typist::STEPS;
use ::book::Page;
use scraper::ElementRef;
use std::collections::BTreeMap;
use std::mem::take;

/// Each test that a page names, and the text from the heading or the name before.
fn named(page: &Page) -> BTreeMap<String, String> {
    let mut named = BTreeMap::new();
    let mut text = String::new();
    for node in page.html.root_element().descendants() {
        if let Some(words) = node.value().as_text() {
            text += " ";
            text += words;
        }
        let Some(element) = ElementRef::wrap(node) else { continue };
        if ["h1", "h2", "h3", "h4"].contains(&element.value().name()) {
            text.clear();
        }
        let label =
            Some(element).filter(|one| one.attr("class") == Some("by-hand"));
        let id = label.and_then(|one| one.attr("id")?.strip_prefix("by-hand-"));
        if let Some(name) = id {
            named.insert(name.to_owned(), take(&mut text));
        }
    }
    named
}

/// The numbers in a text: each without its sign, and with it.
fn shown(text: &str) -> Vec<f64> {
    let text = text.replace(['-', '−'], " - ");
    let text =
        text.replace(|c: char| !c.is_ascii_digit() && !"-.,".contains(c), " ");
    let mut numbers = vec![];
    let mut sign = 1.0;
    for word in text.split_whitespace() {
        let digits = word.replace(',', "");
        if let Ok(number) = digits.trim_matches('.').parse::<f64>() {
            numbers.extend([number, sign * number]);
        }
        sign = if word == "-" { -1.0 } else { 1.0 };
    }
    numbers
}

/// The numbers with a point in a test, but for those in a `let`, which are given, those in
/// a product, which are the formula's, and a tolerance such as 5e-5.
fn asserted(test: &str) -> Vec<f64> {
    let test = test.replace(" * ", "*");
    let statements = test.split(';').filter(|one| !one.trim().starts_with("let "));
    let words = statements.flat_map(|one| {
        one.split(|c: char| !c.is_ascii_alphanumeric() && !"-._*".contains(c))
    });
    let is_number = |word: &&str| {
        word.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit())
            && word.contains('.')
            && !word.contains('e')
    };
    let numbers = words.filter(is_number);
    numbers.filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn every_number_by_hand_is_tested() {
    let (book, mut faults) = (book(), vec![]);
    for step in STEPS {
        let path = format!("steps/{step}/tests/by_hand.rs");
        let file = SOURCE.text(&path).unwrap_or_default();
        let page = format!("{step}.html");
        let mut named = named(&book.pages[&page]);
        let mut line = 1;
        for (k, test) in file.split("#[test]\n").enumerate() {
            let at = format!("{path}:{line}");
            line += test.matches('\n').count() + 1;
            let test = test.split("\n}\n").next().unwrap_or_default();
            let Some((name, body)) = test.split_once("() {") else { continue };
            let name = name.trim_start_matches("fn ");
            let Some(text) = named.remove(name).filter(|_| 0 < k) else {
                faults.push(format!("{at}: {page} does not name the test {name}."));
                continue;
            };
            let shown = shown(&text);
            let wrong =
                asserted(body).into_iter().filter(|one| !shown.contains(one));
            faults.extend(wrong.map(|number| {
                format!("{at}: {page}#by-hand-{name} has no {number} above it.")
            }));
        }
        let lost =
            named.keys().map(|name| format!("{page} names no test: {name}."));
        faults.extend(lost);
    }
    assert_none(&faults);
}
