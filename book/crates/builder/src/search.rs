use crate::{Page, Site, inner_text};
use anyhow::Result;
use scraper::ElementRef;
use scraper::node::Element;

/// The name of the script of the search.
pub const INDEX: &str = "search-index.js";

/// The script from which the search has the text of the book: for each page its name, its
/// title, and the id, the title, the prose and the listings of each section.
pub fn index_script(site: &Site) -> Result<String> {
    let pages = site.chapters_in_order().into_iter().map(|page| {
        let sections = sections(page);
        let title = sections.first().map(|[_, title, ..]| title.clone());
        (&page.name, title.unwrap_or_default(), sections)
    });
    let index = serde_json::to_string(&pages.collect::<Vec<_>>())?;
    Ok(format!("window.searchIndex = {index};\n"))
}

/// The id, the title, the prose and the listings of each section of a page.
fn sections(page: &Page) -> Vec<[String; 4]> {
    let mut sections: Vec<[String; 4]> = vec![];
    for part in page.select_all("main > :not(.cover), .cover > *") {
        if let ("h1" | "h2" | "h3", Some(id)) = (part.value().name(), part.attr("id")) {
            sections.push([id.to_owned(), inner_text(part), String::new(), String::new()]);
        } else if let Some([_, _, prose, listings]) = sections.last_mut() {
            let is_listing = part.attr("data-path").is_some();
            *(if is_listing { listings } else { prose }) += &visible_text(part);
        }
    }
    let join_words = |text: &String| text.split_whitespace().collect::<Vec<_>>().join(" ");
    sections.iter().map(|texts| texts.each_ref().map(join_words)).collect()
}

/// The text of an element without what is hidden or drawn in it, and without answers and
/// hints, which a search would give away.
fn visible_text(element: ElementRef) -> String {
    let is_hidden = |element: &Element| {
        let is_answer = matches!(element.attr("class"), Some("answer" | "hints"));
        is_answer || element.attr("hidden").is_some() || element.name() == "svg"
    };
    let texts = element.descendants().filter(|node| {
        let mut around = node.ancestors().filter_map(|node| node.value().as_element());
        !around.any(is_hidden)
    });
    let texts = texts.filter_map(|node| Some(&**node.value().as_text()?));
    texts.chain([" "]).collect()
}
