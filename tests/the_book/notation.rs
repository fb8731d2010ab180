//! Every name in the notation tables exists in the code.

use super::built::BOOK;
use super::item::Items;
use super::source::SOURCE;
use super::{assert_found, assert_none};
use book::{Element, Files, Page, Site};

const PAGE: &str = "notation.html";

/// Each name that stands for nothing in the code.
///
/// A cell names items, as `Ray::at`, and variables, as `v_0` in `Camera::new`.
fn faults(book: &Site, source: &Files) -> Vec<String> {
    let page = &book.pages[PAGE];
    let items = Items::of(source);
    let mut faults = vec![];
    for cell in cells(page) {
        for name in cell.text.trim().split(", ") {
            let found = match name.split_once(" in ") {
                Some((variable, of)) => items.has_variable(of, variable),
                None => items.has(name),
            };
            if !found {
                let at = page.at(cell);
                faults.push(format!("The code has no {name}, which {at} names."));
            }
        }
    }
    faults
}

/// The last cell of each row in the tables that end with a column "In the code".
fn cells(page: &Page) -> Vec<&Element> {
    let inside = |tag, outer| page.all(tag).filter(move |e| page.within(e, outer));
    let tables = page.all("table");
    let tables = tables.filter(|table| {
        inside("th", table).last().is_some_and(|head| head.text == "In the code")
    });
    let rows = tables.flat_map(|table| inside("tr", table));
    rows.filter_map(|row| inside("td", row).last()).collect()
}

#[test]
fn every_name_is_in_the_code() {
    assert_none(&faults(&BOOK, &SOURCE));
    assert!(!cells(&BOOK.pages[PAGE]).is_empty());
}

#[test]
fn a_name_that_is_not_in_the_code_is_found() {
    for (name, wrong) in [
        ("<td><code>Ray::<wbr>start", "<td><code>Ray::origin"),
        ("<td><code>Scene::<wbr>ambient_", "<td><code>Scene::diffuse_"),
        ("<td><code>v_<wbr>0</code> in", "<td><code>v_1</code> in"),
    ] {
        let found = faults(&BOOK.with(PAGE, name, wrong), &SOURCE);
        let wrong = wrong.replace("<td><code>", "").replace("</code>", "");
        assert_found(&found, &["line ", PAGE, &wrong]);
    }
    let renamed =
        SOURCE.with("steps/step01_rays/src/ray.rs", "pub start", "pub origin");
    assert_found(&faults(&BOOK, &renamed), &["no Ray::start", "line ", PAGE]);
}
