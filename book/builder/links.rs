//! Every link, anchor and picture leads to something in the book, and nothing is
//! fetched from elsewhere.

use crate::files::joined;
use crate::{Site, text};
use scraper::ElementRef;
use std::collections::BTreeSet;

/// Each link that leads nowhere, and all that would be fetched from elsewhere.
pub fn faults(site: &Site) -> Vec<String> {
    let with_id = site.pages.values().flat_map(|page| {
        page.all("[id]").into_iter().map(|one| (page.name.as_str(), one.attr("id")))
    });
    let ids = with_id.collect();
    let mut faults = vec![];
    for page in site.pages.values() {
        for element in page.html.root_element().descendent_elements() {
            for address in addresses(element) {
                let what = resolve(site, &ids, &page.name, &address);
                let is_link =
                    element.value().name() == "a" && is_elsewhere(&address);
                let what = what.filter(|_| !is_link);
                faults.extend(
                    what.map(|what| format!("{} {what}", page.at(element))),
                );
            }
        }
    }
    faults
}

/// Everything that an element leads to or loads.
fn addresses(element: ElementRef) -> Vec<String> {
    if element.value().name() == "base" {
        // Says where the book is, and fetches nothing.
        return vec![];
    }
    let mut found = vec![];
    for (name, value) in element.value().attrs() {
        match name {
            "href" | "src" => found.push(value.into()),
            "srcset" => {
                let sets =
                    value.split(',').flat_map(|set| set.split_whitespace().next());
                found.extend(sets.map(str::to_owned));
            }
            _ => {}
        }
    }
    if element.value().name() == "style" {
        found.extend(urls(&text(element)).map(str::to_owned));
    }
    found
}

/// Whether an address names another place than the book.
fn is_elsewhere(address: &str) -> bool {
    let scheme = address.split(['/', '#', '?']).next().unwrap_or_default();
    address.starts_with('/') || scheme.contains(':')
}

/// What is wrong with an address in the file `from`, if it is not that of something in
/// the book.
fn resolve(
    site: &Site,
    ids: &BTreeSet<(&str, Option<&str>)>,
    from: &str,
    address: &str,
) -> Option<String> {
    if address.starts_with("data:") {
        return None;
    }
    if is_elsewhere(address) {
        return Some(format!("fetches {address} from outside the book"));
    }
    let (path, id) = address.split_once('#').unwrap_or((address, ""));
    let path = match path.split('?').next().unwrap_or_default() {
        "" => from.to_string(),
        path => joined(from, path),
    };
    if !site.files.0.contains_key(&path) {
        return Some(format!("leads to {path}, which is not in the book"));
    }
    let is_there = id.is_empty() || ids.contains(&(&path, Some(id)));
    (!is_there).then(|| format!("leads to #{id}, which is not in {path}"))
}

/// The address of everything that a style fetches: what is in `url(…)`.
fn urls(css: &str) -> impl Iterator<Item = &str> {
    let inside =
        css.split("url(").skip(1).filter_map(|rest| rest.split(')').next());
    inside.map(|url| url.trim().trim_matches(['"', '\'']))
}
