//! Every slide of the lecture is in its map, and the code and the tests that the
//! map names exist.

use super::built::{BOOK, files};
use super::item::Items;
use super::source::SOURCE;
use super::table::rows;
use super::{assert_found, assert_none};
use book::{Files, Site};
use std::sync::LazyLock;

const PAGE: &str = "lecture.html";

static TESTS: LazyLock<Files> = LazyLock::new(|| files("tests"));

/// Each name in the map that stands for nothing, each slide whose code no test holds,
/// and each slide that a page speaks of and that is not in the map.
fn faults(book: &Site, source: &Files, tests: &Files) -> Vec<String> {
    let items = Items::of(source);
    let rows: Vec<_> = book.pages.get(PAGE).into_iter().flat_map(rows).collect();
    let mut titles = vec![];
    let mut faults = vec![];
    for row in rows {
        let Some(title) = row.text("Slide") else { continue };
        titles.push(title.replace('’', "'"));
        let at = row.at();
        let (codes, names) = (row.codes("In the code"), row.codes("Test"));
        for name in codes.iter().filter(|name| !items.has(name)) {
            faults.push(format!("The code has no {name}, which {at} names."));
        }
        for name in names.iter().filter(|name| !has_test(tests, name)) {
            faults.push(format!("There is no test {name}, which {at} names."));
        }
        if names.is_empty() && !codes.is_empty() {
            faults.push(format!("No test holds the code of the slide at {at}."));
        }
    }
    // "Ambient Term" is "Phong Reflection Model: Ambient Term".
    let is_known = |slide: &str| {
        let end = format!(": {slide}");
        titles.iter().any(|title| title == slide || title.ends_with(&end))
    };
    for page in book.chapters() {
        for slide in quoted(&page.text).iter().filter(|slide| !is_known(slide)) {
            faults.push(format!(
                "The map has no slide {slide:?}, see {}.",
                page.name
            ));
        }
    }
    faults
}

/// The titles in a text: slide "A", slides "B" and "C".
fn quoted(text: &str) -> Vec<String> {
    let text = text.replace(['“', '”'], "\"").replace('’', "'");
    let mut titles = vec![];
    for (word, next) in [("lide \"", ""), ("lides \"", " and ")] {
        for rest in text.split(word).skip(1) {
            let mut parts = rest.split('"');
            titles.extend(parts.next().map(str::to_string));
            if parts.next() == Some(next) {
                titles.extend(parts.next().map(str::to_string));
            }
        }
    }
    titles
}

/// Whether there is a test `name`, such as `step02_sphere::a_ray_misses`.
fn has_test(tests: &Files, name: &str) -> bool {
    let Some((file, function)) = name.split_once("::") else { return false };
    let Some(text) = tests.text(&format!("{file}.rs")) else { return false };
    text.split("#[test]")
        .skip(1)
        .any(|test| test.trim_start().starts_with(&format!("fn {function}(")))
}

#[test]
fn every_slide_is_in_the_map_and_every_name_exists() {
    assert_none(&faults(&BOOK, &SOURCE, &TESTS));
}

#[test]
fn a_slide_that_is_not_in_the_map_is_found() {
    let book = BOOK.with(PAGE, "<td>Field of View</td>", "<td>Fields of View</td>");
    let words = ["no slide \"Field of View\"", "step01_rays.html"];
    assert_found(&faults(&book, &SOURCE, &TESTS), &words);
    for text in ["Slide “A”", "the slides “Rays” and “A”", "/// (slide \"A\")"]
    {
        let book = BOOK.with_html(&format!("<p>{text}</p>"));
        let words = ["no slide \"A\"", "step01_rays.html"];
        assert_found(&faults(&book, &SOURCE, &TESTS), &words);
    }
}

#[test]
fn a_name_that_stands_for_nothing_is_found() {
    let book = BOOK.with(PAGE, "<code>Ray::<wbr>at</code>", "<code>Ray::of</code>");
    assert_found(&faults(&book, &SOURCE, &TESTS), &["no Ray::of", "line ", PAGE]);
    let book = BOOK.with(PAGE, "every_<wbr>ray_<wbr>starts", "every_ray_ends");
    assert_found(
        &faults(&book, &SOURCE, &TESTS),
        &["no test step01_rays::every_ray_ends_at_c", PAGE],
    );
    let tests = TESTS.with("step01_rays.rs", "#[test]\nfn r_of_t", "fn r_of_t");
    assert_found(
        &faults(&BOOK, &SOURCE, &tests),
        &["no test step01_rays::r_of_t_is_s", PAGE],
    );
}
