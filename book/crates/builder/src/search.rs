use crate::{Page, Site, inner_text, select_all};
use course::json;
use scraper::{ElementRef, Node};

/// The name of the script of the search.
pub const INDEX: &str = "search-index.js";

/// The script from which the search of a page has the text of the book: the address, the
/// title and the words of each section.
pub fn index_script(site: &Site) -> String {
    let sections = site.chapters_in_order().into_iter().flat_map(section_jsons);
    format!("window.searchIndex = {};\n", json::list(sections))
}

/// The sections of a page, each a list in JSON.
fn section_jsons(page: &Page) -> Vec<String> {
    let Ok(main) = page.select_first("main") else { return vec![] };
    let mut sections = vec![];
    let mut chapter = String::new();
    let (mut address, mut title, mut words) = <(String, String, String)>::default();
    for part in main.children() {
        let heading =
            ElementRef::wrap(part).filter(|one| ["h1", "h2", "h3"].contains(&one.value().name()));
        let Some(heading) = heading else {
            words += &visible_text(part);
            words.push(' ');
            continue;
        };
        sections.push((address, title, words));
        let id = heading.attr("id").unwrap_or_default();
        address = format!("{}#{id}", page.name);
        title = collapse_blanks(&inner_text(heading));
        if heading.value().name() == "h1" {
            chapter.clone_from(&title);
        } else {
            title = format!("{chapter}: {title}");
        }
        words = String::new();
    }
    sections.push((address, title, words));
    // Nothing stands before the first heading.
    sections
        .into_iter()
        .skip(1)
        .map(|(address, title, words)| {
            let words = collapse_blanks(&words);
            json::list([address, title, words].map(|one| json::quote(&one)))
        })
        .collect()
}

/// The text of a part that is not hidden.
fn visible_text(part: ego_tree::NodeRef<Node>) -> String {
    match ElementRef::wrap(part) {
        Some(element) if element.attr("hidden").is_some() => String::new(),
        Some(element) if !select_all(element, "svg").is_empty() => {
            select_all(element, "figcaption").into_iter().map(inner_text).collect()
        }
        Some(element) => inner_text(element),
        None => part.value().as_text().map_or(String::new(), |text| text.to_string()),
    }
}

/// The words of a text, with one blank between two.
fn collapse_blanks(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
