//! The index that the search of the pages uses.

use crate::page::Element;
use crate::{Page, Site};
use anyhow::Result;

/// The script that gives the search the text of the book. For each page, it has the name, the
/// title, and the id, title, prose and listings of each section.
pub fn index_script(site: &Site) -> Result<String> {
    let pages = site.pages_in_order().into_iter().map(|page| {
        let sections = sections(page);
        let title = sections.first().map(|[_, title, ..]| title.clone());
        (&page.name, title.unwrap_or_default(), sections)
    });
    let index = serde_json::to_string(&pages.collect::<Vec<_>>())?;
    Ok(format!("book.searchIndex = {index};\n"))
}

/// The id, the title, the prose and the listings of each section of a page.
fn sections(page: &Page) -> Vec<[String; 4]> {
    let mut sections: Vec<[String; 4]> = vec![];
    let main = page.elements.iter().find(|element| element.tag == "main");
    let mut end = 0;
    for part in main.into_iter().flat_map(|main| page.descendants(main)) {
        // Elements inside a part have been read with it. Some elements are only frames around parts.
        let is_frame = matches!(part.attr("class"), Some("cover" | "with-margin"));
        if part.text.start < end || is_frame {
            continue;
        }
        end = part.text.end;
        if let ("h1" | "h2" | "h3", Some(id)) = (&*part.tag, part.attr("id")) {
            let title = page.text(part).to_owned();
            sections.push([id.to_owned(), title, String::new(), String::new()]);
        } else if let Some([_, _, prose, listings]) = sections.last_mut() {
            let is_listing = part.attr("data-path").is_some();
            let text = page.text_without(part, is_hidden) + " ";
            *(if is_listing { listings } else { prose }) += &text;
        }
    }
    let join_words = |text: &String| text.split_whitespace().collect::<Vec<_>>().join(" ");
    sections.iter().map(|texts| texts.each_ref().map(join_words)).collect()
}

/// Whether the search skips an element: it is hidden or a drawing, or it is an answer or a hint,
/// which the search would give away.
fn is_hidden(element: &Element) -> bool {
    let is_answer = matches!(element.attr("class"), Some("answer" | "hints"));
    is_answer || element.attr("hidden").is_some() || element.tag == "svg"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hidden_elements_answers_and_hints_are_left_out() {
        let is_left_out = |html| is_hidden(&Page::parse("a.html", html).elements[0]);
        for html in
            ["<p hidden>", "<svg>", "<details class=\"answer\">", "<details class=\"hints\">"]
        {
            assert!(is_left_out(html), "{html}");
        }
        for html in ["<p>", "<details class=\"aside\">"] {
            assert!(!is_left_out(html), "{html}");
        }
    }
}
