//! Every slide of the lecture is in its map, and the code and the tests that the
//! map names exist.

use crate::book::{BOOK, Book, workspace};
use crate::files::Files;
use crate::item::is_there;
use crate::slides::SLIDES;
use crate::source::SOURCE;
use crate::table::rows;
use crate::{assert_found, assert_none};
use std::sync::LazyLock;

const PAGE: &str = "lecture.html";

static TESTS: LazyLock<Files> = LazyLock::new(|| {
    let mut files = Files::read(&workspace().join("tests"));
    files.0.retain(|path, _| path.starts_with("step"));
    files
});

/// Each slide that is not in its place in the map, and each name there that stands
/// for nothing.
fn faults(book: &Book, source: &Files, tests: &Files) -> Vec<String> {
    let rows: Vec<_> = book.pages.get(PAGE).into_iter().flat_map(rows).collect();
    let mut slides = SLIDES.iter();
    let mut faults = vec![];
    for row in rows {
        let Some(title) = row.text("Slide") else { continue };
        let at = row.at();
        let expected = slides.next().copied().unwrap_or("no slide");
        if title.replace('’', "'") != expected {
            faults.push(format!(
                "The slide at {at} is {title:?}, but here comes {expected:?}."
            ));
            break;
        }
        let items = row.codes("In the code");
        let missing = items.iter().filter(|name| !is_there(source, name));
        faults.extend(
            missing
                .map(|name| format!("The code has no {name}, which {at} names.")),
        );
        let names = row.codes("Test");
        let missing = names.iter().filter(|name| !has_test(tests, name));
        faults.extend(
            missing
                .map(|name| format!("There is no test {name}, which {at} names.")),
        );
        if names.is_empty() && !items.is_empty() {
            faults.push(format!("No test holds the code of the slide at {at}."));
        }
    }
    if let (true, Some(slide)) = (faults.is_empty(), slides.next()) {
        faults.push(format!("The map in {PAGE} ends before the slide {slide:?}."));
    }
    faults
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
fn a_slide_out_of_its_place_is_found() {
    let book = BOOK.with(PAGE, "<td>2D Frustum</td>", "<td>3D Frustum</td>");
    let words = ["line ", PAGE, "\"3D Frustum\"", "\"2D Frustum\""];
    assert_found(&faults(&book, &SOURCE, &TESTS), &words);
    let book = BOOK.with(PAGE, "<tr><td>Next Time</td>", "<tr hidden>");
    assert_found(
        &faults(&book, &SOURCE, &TESTS),
        &["lecture.html", "\"Next Time\""],
    );
    let mut book = BOOK.clone();
    book.pages.remove(PAGE);
    assert_found(&faults(&book, &SOURCE, &TESTS), &["ends before", "Now Playing"]);
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
