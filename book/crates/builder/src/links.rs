//! Checks that every address within the book leads to a file or anchor that exists, and that the
//! pages fetch nothing from outside the book.

use crate::files::resolve_path;
use crate::page::Element;
use crate::{Page, Site};
use figures::{find_figure, parse_address};
use std::collections::BTreeSet;
use thiserror::Error;

/// An address that leads nowhere, or that would be fetched from outside the book.
#[derive(Debug, Error)]
#[error("{location}: {error}")]
pub struct LinkFault {
    /// The page, and the nearest id at or before the address.
    location: String,
    /// What is wrong with the address.
    error: LinkError,
}

/// Everything that can be wrong with an address.
#[derive(Debug, Error)]
enum LinkError {
    #[error("{0} is outside the book")]
    OutsideBook(String),
    #[error("there is no {0} in the book")]
    UnknownFile(String),
    #[error("there is no #{id} in {path}")]
    UnknownId { id: String, path: String },
}

/// Finds the addresses that lead nowhere, and the addresses that would be fetched from outside the
/// book. Skips the pages that only repeat other pages.
pub fn find_address_faults(site: &Site) -> Vec<LinkFault> {
    let with_id = site.pages.values().flat_map(|page| {
        page.elements.iter().map(|element| (page.name.as_str(), element.attr("id")))
    });
    let ids = with_id.collect();
    let mut faults = vec![];
    let is_copy = |page: &&Page| ["index.html", "print.html"].contains(&&*page.name);
    for page in site.pages.values().filter(|page| !is_copy(page)) {
        for element in &page.elements {
            for (attribute, address) in addresses_in(page, element) {
                let is_link = (&*element.tag, attribute) == ("a", "href");
                if is_link && is_outside_book(address) {
                    continue;
                }
                if let Err(error) = check_address(site, &ids, &page.name, address) {
                    faults.push(LinkFault { location: page.address_for_fault(element), error });
                }
            }
        }
    }
    faults
}

/// Returns every address that an element links to or loads. Each address comes with the name of the
/// attribute that contains it, or with an empty name if the address is in the text of a `<style>`
/// element.
fn addresses_in<'a>(page: &'a Page, element: &'a Element) -> Vec<(&'a str, &'a str)> {
    let mut addresses: Vec<(&str, &str)> = vec![];
    for (name, value) in &element.attributes {
        match &**name {
            // A `<base>` only says where the book is. Nothing is fetched from that address.
            "href" if element.tag == "base" => {}
            "href" | "src" => addresses.push((name, value)),
            "srcset" => {
                let candidates =
                    value.split(',').filter_map(|candidate| candidate.split_whitespace().next());
                addresses.extend(candidates.map(|address| (&**name, address)));
            }
            // These attributes contain text for readers, not addresses.
            "alt" | "title" | "aria-label" => {}
            _ if value.contains("//") => addresses.push((name, value)),
            _ => addresses.extend(style_urls(value).map(|address| (&**name, address))),
        }
    }
    if element.tag == "style" {
        addresses.extend(style_urls(page.text(element)).map(|address| ("", address)));
    }
    addresses
}

fn is_outside_book(address: &str) -> bool {
    let scheme = address.split(['/', '#', '?']).next().unwrap_or_default();
    address.starts_with('/') || scheme.contains(':')
}

/// Checks that an address on the page `page_path` leads to something in the book.
fn check_address(
    site: &Site,
    ids: &BTreeSet<(&str, Option<&str>)>,
    page_path: &str,
    address: &str,
) -> Result<(), LinkError> {
    if address.starts_with("data:") {
        return Ok(());
    }
    if is_outside_book(address) {
        return Err(LinkError::OutsideBook(address.to_owned()));
    }
    let (path, id) = address.split_once('#').unwrap_or((address, ""));
    let path = match path.split('?').next().unwrap_or_default() {
        "" => page_path.to_string(),
        path => resolve_path(page_path, path),
    };
    if !site.files.0.contains_key(&path) {
        return Err(LinkError::UnknownFile(path));
    }
    let is_known = id.is_empty()
        || ids.contains(&(&path, Some(id)))
        || site.pages.get(&path).is_some_and(|page| scripts_understand_fragment(page, id));
    if is_known { Ok(()) } else { Err(LinkError::UnknownId { id: id.to_owned(), path }) }
}

/// Whether the scripts on the page understand this fragment of an address. They understand:
///
/// - `pixel=470,120` on a page with a pixel panel
/// - `line=gate:true` on a page where the place `gate` can be edited
/// - `scene=camera-roll:45` on the page with the editable scene
fn scripts_understand_fragment(page: &Page, fragment: &str) -> bool {
    match fragment.split_once('=') {
        Some(("pixel", _)) => page.attribute_values("data-panel").next().is_some(),
        Some(("line", words)) => {
            let place = format!("{}:", words.split(':').next().unwrap_or_default());
            page.attribute_values("data-places")
                .any(|places| places.split(' ').any(|entry| entry.starts_with(&place)))
        }
        Some(("scene", address)) => {
            let is_here = page.attribute_values("data-live").any(|name| name == "own_scene");
            find_figure("own_scene")
                .filter(|_| is_here)
                .is_some_and(|live| parse_address(live, address).is_ok())
        }
        _ => false,
    }
}

/// The addresses from which a stylesheet fetches something: the addresses in `url(…)`, then the
/// addresses after `@import`.
fn style_urls(css: &str) -> impl Iterator<Item = &str> {
    let urls = css.split("url(").skip(1).filter_map(|part| part.split(')').next());
    let imports = css.split("@import \"").skip(1).filter_map(|part| part.split('"').next());
    urls.chain(imports).map(|url| url.trim().trim_matches(['"', '\'']))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn address_outside_the_book_has_a_scheme_or_begins_with_a_slash() {
        for address in ["https://a.org", "mailto:a", "//a.org", "/a.html"] {
            assert!(is_outside_book(address), "{address}");
        }
        for address in ["a.html", "a.html#b:c", "../a/b.png", "#a", ""] {
            assert!(!is_outside_book(address), "{address}");
        }
    }

    #[test]
    fn style_urls_are_those_in_url_and_after_import() {
        let css = "@import \"a.css\"; b { src: url(\"c.woff2\"), url(d.png); }";
        let urls: Vec<_> = style_urls(css).collect();
        assert_eq!(urls, ["c.woff2", "d.png", "a.css"]);
    }

    #[test]
    fn fragments_for_scripts_name_a_pixel_a_line_or_a_scene_of_the_page() {
        let html = "<details data-panel=\"a\"></details><figure data-live=\"own_scene\"></figure>\
                    <figure data-places=\"gate:1:2 normal:3:4\"></figure>";
        let page = Page::parse("a.html", html);
        for fragment in ["pixel=1,2", "line=normal:p", "scene=camera-roll:45"] {
            assert!(scripts_understand_fragment(&page, fragment), "{fragment}");
        }
        for fragment in ["line=norm:p", "scene=moon-radius:1", "section"] {
            assert!(!scripts_understand_fragment(&page, fragment), "{fragment}");
        }
        assert!(!scripts_understand_fragment(&Page::parse("b.html", ""), "pixel=1,2"));
    }
}
