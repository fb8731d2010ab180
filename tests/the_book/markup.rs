//! Nothing unexpanded is left, every picture and drawing has words for those who
//! cannot see it, and an id stands for one thing.

use super::built::BOOK;
use super::{assert_found, assert_none};
use book::{Page, Site};
use std::collections::HashSet;

/// What is only there when a directive or a formula was not expanded.
const LEFTOVERS: [&str; 4] = ["{{#", "$$", r"\frac", r"\begin{"];

/// Everything that is wrong with the elements of a page.
fn faults(book: &Site) -> Vec<String> {
    let faults = book.pages.values().flat_map(|page| {
        unexpanded(page).into_iter().chain(wordless(page)).chain(repeated(page))
    });
    faults.collect()
}

/// What is left in the text of a page.
fn unexpanded(page: &Page) -> Vec<String> {
    let left = LEFTOVERS.iter().filter(|leftover| page.text.contains(**leftover));
    left.map(|leftover| format!("{leftover} is left in {}.", page.name)).collect()
}

/// Pictures without alt text, and drawings without a title that are not hidden.
fn wordless(page: &Page) -> Vec<String> {
    let mut faults = vec![];
    for img in page.all("img") {
        let alt = img.get("alt").unwrap_or_default();
        if alt.trim().is_empty() {
            faults
                .push(format!("The picture at {} has no alt text.", page.at(img)));
        } else if alt.contains("](") {
            faults.push(format!("The alt text at {} is Markdown.", page.at(img)));
        }
    }
    for svg in page.all("svg") {
        let mut titles = page.all("title").filter(|title| page.within(title, svg));
        let is_figure = page.around(svg).any(|e| e.tag == "figure");
        if is_figure && titles.all(|title| title.text.trim().is_empty()) {
            faults.push(format!("The drawing at {} has no title.", page.at(svg)));
        }
    }
    faults
}

/// Ids that stand for a second element.
fn repeated(page: &Page) -> Vec<String> {
    let mut known = HashSet::new();
    let ids = page.elements.iter().filter_map(|e| Some((e, e.get("id")?)));
    let repeated = ids.filter(|(_, id)| !known.insert(*id));
    repeated
        .map(|(e, id)| {
            format!(
                "The id {id} at {} stands for something else already.",
                page.at(e)
            )
        })
        .collect()
}

#[test]
fn every_page_is_whole() {
    assert_none(&faults(&BOOK));
}

#[test]
fn what_is_not_expanded_is_found() {
    for text in LEFTOVERS {
        let book = BOOK.with_html(&format!("<p>So <b>{text}</b></p>"));
        assert_found(&faults(&book), &[text, "is left", "step01_rays.html"]);
    }
}

#[test]
fn a_picture_or_a_drawing_without_words_is_found() {
    for html in ["<img src=\"a.png\">", "<img src=\"a.png\" alt=\" \">"] {
        assert_found(
            &faults(&BOOK.with_html(html)),
            &["step01_rays.html", "no alt text"],
        );
    }
    let html = "<img src=\"a.png\" alt=\"A [link](b.html)\">";
    assert_found(&faults(&BOOK.with_html(html)), &["step01_rays.html", "Markdown"]);
    for drawing in ["<path d=\"\"/>", "<title> </title>", "<g><title/></g>"] {
        let html = format!("<figure><svg>{drawing}</svg></figure>");
        let words = ["step01_rays.html", "no title"];
        assert_found(&faults(&BOOK.with_html(&html)), &words);
    }
}

#[test]
fn a_repeated_id_is_found() {
    let book = BOOK.with_html("<p id=\"mdbook-content\"></p>");
    assert_found(&faults(&book), &["mdbook-content", "line ", "step01_rays.html"]);
}
