//! Nothing unexpanded is left, every picture and drawing has words for those who
//! cannot see it, and an id stands for one thing.

use crate::book::BOOK;
use crate::{assert_found, assert_none};
use book::Page;
use book::Site;
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

/// The innermost elements with a leftover in their text.
fn unexpanded(page: &Page) -> Vec<String> {
    let mut faults = vec![];
    for leftover in LEFTOVERS {
        let holds = page.elements.iter().filter(|e| e.text.contains(leftover));
        let around: HashSet<_> = holds.clone().filter_map(|e| e.parent).collect();
        let holds = page
            .elements
            .iter()
            .enumerate()
            .filter(|(_, e)| e.text.contains(leftover));
        for (_, element) in holds.filter(|(at, _)| !around.contains(at)) {
            faults.push(format!(
                "{leftover} is left in the text at {}.",
                page.at(element)
            ));
        }
    }
    faults
}

/// Pictures without alt text, and drawings without a title that are not hidden.
fn wordless(page: &Page) -> Vec<String> {
    let silent = |text: Option<&str>| text.unwrap_or_default().trim().is_empty();
    let pictures = page.all("img").filter(|img| silent(img.get("alt")));
    let pictures = pictures
        .map(|img| format!("The picture at {} has no alt text.", page.at(img)));
    let images = page.all("img");
    let markdown = images.filter(|img| img.get("alt").is_some_and(is_markdown));
    let markdown = markdown
        .map(|img| format!("The alt text at {} has Markdown in it.", page.at(img)));
    let drawings = page.all("svg").filter(|svg| {
        let mut titles = page.all("title").filter(|title| page.within(title, svg));
        page.around(svg).any(|e| e.tag == "figure")
            && titles.all(|title| silent(Some(&title.text)))
    });
    let drawings = drawings
        .map(|svg| format!("The drawing at {} has no title.", page.at(svg)));
    pictures.chain(markdown).chain(drawings).collect()
}

/// Whether a link is left in a text.
fn is_markdown(text: &str) -> bool {
    text.contains("](")
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
    for text in ["{{#figure ray}}", "$$x$$", r"\frac{1}{2}", r"\begin{cases}"] {
        let book = BOOK.with_html(&format!("<p>So <b>{text}</b></p>"));
        assert_found(&faults(&book), &["is left", "line ", "step01_rays.html"]);
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
