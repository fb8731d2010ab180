//! The index for the book's search.

use crate::fault::Faults;
use crate::page::Element;
use crate::{Page, Site};
use anyhow::Result;
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};
use std::iter;

/// The contents of search_words.txt: words that readers type into the search. The first lines of
/// the file explain its format.
pub const READER_WORDS: &str = include_str!("../search_words.txt");

/// Returns the script with the data that book/theme/search.js searches. The data consists of three
/// arrays: pages, hints, and groups of synonyms. Each entry is an array as well:
///
/// - A page consists of a name, a title, and sections.
/// - A section consists of an id, a title, prose, listings, and the phrases by which readers look
///   for the section.
/// - A hint consists of the address of a section, error messages, and the sentence to show when a
///   reader searches for such a message.
/// - A group of synonyms is an array of words.
///
/// Returns an error if `reader_words` names a section that the book doesn't have.
pub fn index_script(site: &Site, reader_words: &str) -> Result<String> {
    let SearchVocabulary { mut phrases, hints, synonyms } = SearchVocabulary::parse(reader_words);
    let mut addresses = BTreeSet::new();
    let pages = site.pages_in_order().into_iter().map(|page| {
        let sections = page_sections(page);
        let title = sections.first().map(|section| section.title.clone());
        let sections = sections.into_iter().map(|Section { id, title, prose, listings }| {
            let address = format!("{}#{id}", page.name);
            let mut phrases = phrases.remove(&*address).unwrap_or_default();
            phrases.extend(alt_texts_of_links_to(page, &id));
            addresses.insert(address);
            json!([id, title, prose, listings, phrases])
        });
        let sections: Vec<_> = sections.collect();
        json!([page.name, title.unwrap_or_default(), sections])
    });
    let index = serde_json::to_string(&pages.collect::<Vec<_>>())?;
    let is_stale = |address: &&&str| !addresses.contains(**address);
    let named = phrases.keys().chain(hints.iter().map(|hint| &hint.address));
    Faults::ensure_none(
        named
            .filter(is_stale)
            .map(|address| format!("search_words.txt: there is no section {address} in the book")),
    )?;
    let hints = hints
        .iter()
        .map(|Hint { address, messages, sentence }| json!([address, messages, sentence]));
    let hints = serde_json::to_string(&hints.collect::<Vec<_>>())?;
    let synonyms = serde_json::to_string(&synonyms)?;
    Ok(format!(
        "book.searchIndex = {index};\nbook.searchHints = {hints};\nbook.searchSynonyms = {synonyms};\n"
    ))
}

/// Words that readers type into the search but that aren't in the text of the book.
#[derive(Debug, Default, PartialEq)]
struct SearchVocabulary<'a> {
    /// The phrases by which readers look for a section, keyed by the section's address.
    phrases: BTreeMap<&'a str, Vec<&'a str>>,
    hints: Vec<Hint<'a>>,
    /// Groups of words that mean nearly the same.
    synonyms: Vec<Vec<&'a str>>,
}

/// Advice about certain error messages, such as the messages of the compiler.
#[derive(Debug, PartialEq)]
struct Hint<'a> {
    /// The address of the section to read.
    address: &'a str,
    messages: Vec<&'a str>,
    /// A sentence that says what to do.
    sentence: &'a str,
}

impl<'a> SearchVocabulary<'a> {
    fn parse(text: &'a str) -> Self {
        let mut vocabulary = Self::default();
        let mut address = "";
        for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
            if let Some(section) = line.strip_prefix("@ ") {
                address = section;
            } else if let Some(group) = line.strip_prefix("= ") {
                vocabulary.synonyms.push(split_at_commas(group).collect());
            } else if let Some(hint) = line.strip_prefix("! ") {
                let (messages, sentence) = hint.split_once(" → ").unwrap_or((hint, ""));
                let messages = split_at_commas(messages).collect();
                vocabulary.hints.push(Hint { address, messages, sentence });
            } else {
                vocabulary.phrases.entry(address).or_default().extend(split_at_commas(line));
            }
        }
        vocabulary
    }
}

fn split_at_commas(phrases: &str) -> impl Iterator<Item = &str> {
    phrases.split(',').map(str::trim)
}

/// The alt texts of the pictures that link to a section. Such pictures occur only in the galleries
/// of mistakes. An alt text there describes the effect of a mistake, so that readers can search for
/// what they see in their own pictures.
fn alt_texts_of_links_to<'a>(page: &'a Page, id: &str) -> Vec<&'a str> {
    let leads_here = |link: &&Element| {
        link.tag == "a" && link.attr("href").and_then(|href| href.strip_prefix('#')) == Some(id)
    };
    let links = page.elements.iter().filter(leads_here);
    links.flat_map(|link| page.descendants(link)).filter_map(|image| image.attr("alt")).collect()
}

/// A section of a page. In the title, the prose and the listings, words are separated by single
/// spaces.
#[derive(Debug, Default, PartialEq)]
struct Section {
    id: String,
    title: String,
    /// The searchable text of the section, without the text of the listings.
    prose: String,
    /// The text of the listings in the section.
    listings: String,
}

/// Splits the content of a page into sections. Each section begins at a heading that has an id.
fn page_sections(page: &Page) -> Vec<Section> {
    let mut sections = Vec::<Section>::new();
    let main = page.elements.iter().find(|element| element.tag == "main");
    let mut end = 0;
    for part in main.into_iter().flat_map(|main| page.descendants(main)) {
        // Skip elements inside a part that has already been read. Skip wrappers as well, because
        // the elements inside them are read one by one.
        let is_wrapper = matches!(part.attr("class"), Some("cover" | "with-margin"));
        if part.text.start < end || is_wrapper {
            continue;
        }
        end = part.text.end;
        if let ("h1" | "h2" | "h3", Some(id)) = (&*part.tag, part.attr("id")) {
            let (id, title) = (id.to_owned(), collapse_whitespace(page.text(part)));
            sections.push(Section { id, title, ..Section::default() });
        } else if let Some(section) = sections.last_mut() {
            section.prose +=
                &(page.text_without(part, |part| is_skipped(part) || is_listing(part)) + " ");
            // Also add listings inside this part, such as listings in a folded box, unless the
            // search skips the part.
            let descendants = if is_skipped(part) { &[] } else { page.descendants(part) };
            for listing in iter::once(part).chain(descendants).filter(|part| is_listing(part)) {
                section.listings += &(page.text_without(listing, is_skipped) + " ");
            }
        }
    }
    for section in &mut sections {
        section.prose = collapse_whitespace(&section.prose);
        section.listings = collapse_whitespace(&section.listings);
    }
    sections
}

/// Replaces all whitespace between words with single spaces.
fn collapse_whitespace(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn is_listing(element: &Element) -> bool {
    element.attr("data-path").is_some()
}

/// Whether the search skips an element. The search skips drawings and hidden elements. The search
/// also skips boxes with answers or hints, because a search result would give the answer or the
/// hint away.
fn is_skipped(element: &Element) -> bool {
    let is_answer = matches!(element.attr("class"), Some("answer" | "hints"));
    is_answer || element.attr("hidden").is_some() || element.tag == "svg"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readers_words_have_letters_and_hints_end_in_full_stops() {
        let SearchVocabulary { phrases, hints, synonyms } = SearchVocabulary::parse(READER_WORDS);
        assert!(!phrases.contains_key(""), "there are phrases above the first section");
        for Hint { messages, sentence, .. } in &hints {
            assert!(sentence.ends_with('.'), "the sentence for {messages:?} has no full stop");
        }
        let messages = hints.iter().flat_map(|hint| &hint.messages);
        let mut all_phrases =
            phrases.values().flatten().chain(synonyms.iter().flatten()).chain(messages);
        assert!(all_phrases.all(|phrase| phrase.chars().any(char::is_alphanumeric)));
    }

    #[test]
    fn hidden_elements_answers_and_hints_are_left_out() {
        let is_left_out = |html| is_skipped(&Page::parse("a.html", html).elements[0]);
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
