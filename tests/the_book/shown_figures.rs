//! Tests that every figure and every interactive picture is in a chapter.

use super::assert_no_faults;
use super::built_book::built_book;
use figures::FIGURES;
use std::collections::HashSet;

#[test]
fn each_figure_is_on_a_page() {
    let pages = built_book().pages.values();
    let elements = pages.flat_map(|page| &page.elements);
    let names = elements.flat_map(|element| {
        let figure = element.attr("id").and_then(|id| id.strip_prefix("figure-"));
        [figure, element.attr("data-live"), element.attr("data-preview")]
    });
    let names: HashSet<_> = names.flatten().collect();
    let missing_names =
        FIGURES.iter().map(|figure| figure.name).filter(|name| !names.contains(name));
    let faults: Vec<_> =
        missing_names.map(|name| format!("No chapter has the figure {name}.")).collect();
    assert_no_faults(&faults);
}
