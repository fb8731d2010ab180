//! Every link, anchor and picture leads to something in the book, and nothing is
//! fetched from elsewhere.

use crate::fault::Fault;
use crate::files::joined;
use crate::{Element, Site};
use std::collections::BTreeSet;

/// Each link that leads nowhere, and all that would be fetched from elsewhere.
pub fn faults(site: &Site) -> Vec<Fault> {
    let mut faults = vec![];
    let pages = site.pages.values();
    let ids = pages.flat_map(|page| {
        page.elements
            .iter()
            .filter_map(|e| Some((page.name.as_str(), e.get("id")?)))
    });
    let ids = ids.collect();
    let mut tell = |file: &str, line, what: Result<(), String>| {
        let fault = |what| Fault { file: file.to_string(), line, what };
        faults.extend(what.err().map(fault));
    };
    for page in site.pages.values() {
        for element in &page.elements {
            for address in addresses(element) {
                if element.tag != "a" || !is_elsewhere(address) {
                    let what = resolve(site, &ids, &page.name, address);
                    tell(&page.name, element.line as usize, what);
                }
            }
        }
    }
    for (name, css) in site.files.texts(".css") {
        for (line, css) in css.lines().enumerate() {
            for address in urls(css) {
                tell(name, line + 1, resolve(site, &ids, name, address));
            }
        }
    }
    faults
}

/// Everything that an element leads to or loads.
fn addresses(element: &Element) -> Vec<&str> {
    if element.tag == "base" {
        // Says where the book is, and fetches nothing.
        return vec![];
    }
    let names = ["href", "src", "xlink:href", "poster", "data", "action"];
    let mut found: Vec<_> =
        names.iter().filter_map(|name| element.get(name)).collect();
    let sets = element.get("srcset").into_iter().flat_map(|set| set.split(','));
    found.extend(sets.filter_map(|one| one.split_whitespace().next()));
    found.extend(element.get("style").into_iter().flat_map(urls));
    if element.tag == "style" {
        found.extend(urls(&element.text));
    }
    found
}

/// Whether an address names another place than the book.
fn is_elsewhere(address: &str) -> bool {
    let scheme = address.split(['/', '#', '?']).next().unwrap_or_default();
    address.starts_with('/') || scheme.contains(':')
}

/// Says what is wrong with an address in the file `from`, if it is not that of
/// something in the book.
fn resolve(
    site: &Site,
    ids: &BTreeSet<(&str, &str)>,
    from: &str,
    address: &str,
) -> Result<(), String> {
    if address.starts_with("data:") {
        return Ok(());
    }
    if is_elsewhere(address) {
        return Err(format!("fetches {address} from outside the book"));
    }
    let (path, id) = address.split_once('#').unwrap_or((address, ""));
    let path = match path.split('?').next().unwrap_or_default() {
        "" => from.to_string(),
        path => joined(from, path),
    };
    if !site.files.0.contains_key(&path) {
        return Err(format!("leads to {path}, which is not in the book"));
    }
    if id.is_empty() || ids.contains(&(&path, id)) {
        return Ok(());
    }
    Err(format!("leads to #{id}, which is not in {path}"))
}

/// The address of everything that a style fetches: what is in `url(…)` or in an
/// `@import`.
fn urls(css: &str) -> Vec<&str> {
    let quotes = ['"', '\''];
    let inside =
        css.split("url(").skip(1).filter_map(|rest| rest.split(')').next());
    let imports = css.split("@import").skip(1);
    let imports = imports.filter_map(|rest| rest.split(quotes).nth(1));
    inside.chain(imports).map(|url| url.trim().trim_matches(quotes)).collect()
}
