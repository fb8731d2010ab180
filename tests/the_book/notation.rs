//! Every name in the notation tables exists in the code.

use super::built::BOOK;
use super::item::Items;
use super::source::SOURCE;
use super::table::rows;
use super::{assert_found, assert_none};
use book::{Files, Site};

const PAGE: &str = "notation.html";
const COLUMN: &str = "In the code";

/// Each name that stands for nothing in the code.
///
/// A cell names items, as `Ray::at`, and variables, as `v_0` in `Camera::new`.
fn faults(book: &Site, source: &Files) -> Vec<String> {
    let rows: Vec<_> = book.pages.get(PAGE).into_iter().flat_map(rows).collect();
    let cells: Vec<_> =
        rows.iter().filter_map(|row| Some((row, row.text(COLUMN)?))).collect();
    if cells.is_empty() {
        return vec![format!("No table of {PAGE} has a column {COLUMN:?}.")];
    }
    let items = Items::of(source);
    let mut faults = vec![];
    for (row, cell) in cells {
        for name in cell.split(", ") {
            let found = match name.split_once(" in ") {
                Some((variable, function)) => {
                    items.has_variable(function, variable)
                }
                None => items.has(name),
            };
            if !found {
                faults.push(format!(
                    "The code has no {name}, which {} names.",
                    row.at()
                ));
            }
        }
    }
    faults
}

#[test]
fn every_name_is_in_the_code() {
    assert_none(&faults(&BOOK, &SOURCE));
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

#[test]
fn missing_tables_are_found() {
    let mut book = BOOK.clone();
    book.pages.remove(PAGE);
    assert_found(&faults(&book, &SOURCE), &["No table of notation.html"]);
}
