//! The picture is the output: every picture in the book has the pixels of a locked one, of
//! a mistake's, of a step's made small, or of what answers on the page, as it is printed. Each
//! is on a page, and what is said of a mistake's is so.

use super::assert_no_faults;
use super::built_book::{built_book, read_folder};
use builder::{effect_and_step_of_picture, inner_text, select_all};
use figures::{FIGURES, Output};
use image::RgbImage;
use image::imageops::thumbnail;
use std::collections::HashMap;
use tests::camera;

/// The pictures that the book may show, by the name of their file.
fn expected_pictures() -> HashMap<String, RgbImage> {
    let small_pictures = course::PICTURES[..5].iter().map(|(name, draw)| {
        let picture = thumbnail(&draw(&camera(), 1), 320, 180);
        (format!("{name}-small"), picture)
    });
    let live_pictures = FIGURES.iter().filter_map(|live| match live.default_output() {
        Output::Pixels(picture) => Some((live.name.to_owned(), picture)),
        Output::Drawing(_) => None,
    });
    let mut pictures: HashMap<_, _> = small_pictures.chain(live_pictures).collect();
    for (file, png) in read_folder("book/crates/course/mistakes/pictures").0 {
        let name = file.strip_suffix(".png").map(|name| format!("mistake-{name}"));
        pictures.extend(name.zip(decode_png(&png)));
    }
    for (file, png) in read_folder("tests/snapshots").0 {
        let name = file.strip_suffix(".snap.png").map(str::to_owned);
        pictures.extend(name.zip(decode_png(&png)));
    }
    pictures
}

fn decode_png(bytes: &[u8]) -> Option<RgbImage> {
    Some(image::load_from_memory(bytes).ok()?.to_rgb8())
}

#[test]
fn pictures_have_the_expected_pixels() {
    let (pictures, book, mut faults) = (expected_pictures(), built_book(), vec![]);
    for page in book.chapters_in_order() {
        for img in page.select_all("img") {
            let source = img.attr("src").unwrap_or_default();
            let file = source.rsplit('/').next().unwrap_or_default();
            let expected = pictures.get(file.trim_end_matches(".png"));
            let picture = book.files.0.get(source).and_then(|png| decode_png(png));
            if picture.is_none() || picture.as_ref() != expected {
                let location = page.address_for_fault(img);
                faults.push(format!("{location}: {source} is not what our code draws."));
            }
        }
    }
    assert_no_faults(&faults);
}

#[test]
fn every_picture_that_is_built_is_on_a_page() {
    let (book, mut faults) = (built_book(), vec![]);
    let chapters = book.chapters_in_order();
    let images = chapters.iter().flat_map(|page| page.select_all("img"));
    let sources: String = images
        .flat_map(|img| [img.attr("src"), img.attr("srcset")])
        .flatten()
        .map(|sources| format!("{sources} "))
        .collect();
    for file in book.files.0.keys().filter(|file| file.ends_with(".png")) {
        if !sources.contains(&format!("{file} ")) {
            faults.push(format!("{file} is on no page."));
        }
    }
    assert_no_faults(&faults);
}

/// The numbers of the steps that a text names.
fn named_steps(text: &str) -> Vec<usize> {
    let words: Vec<_> = text.split(|c: char| !c.is_alphanumeric()).collect();
    let pairs = words.windows(2).filter(|pair| pair[0].eq_ignore_ascii_case("step"));
    pairs.filter_map(|pair| pair[1].parse().ok()).collect()
}

#[test]
fn mistakes_have_the_sentence_of_the_list_and_the_step_that_is_named() {
    let (book, mut faults) = (built_book(), vec![]);
    for page in book.chapters_in_order() {
        for figure in page.select_all("figure.picture") {
            let Some(img) = select_all(figure, "img").first().copied() else {
                continue;
            };
            let source = img.attr("src").unwrap_or_default();
            let Some((effect, step)) = effect_and_step_of_picture(source) else {
                continue;
            };
            let location = page.address_for_fault(figure);
            if img.attr("alt") != Some(&effect) {
                faults.push(format!("{location}: the alt text is not {effect:?}."));
            }
            let mut steps = named_steps(&inner_text(figure));
            if steps.is_empty() {
                steps.extend(named_steps(&page.name.replace("step0", "step ").replace('_', " ")));
            }
            if steps != [step.number()] {
                let name = step.name();
                faults.push(format!("{location}: {source} shows {name}, not {steps:?}."));
            }
        }
    }
    assert_no_faults(&faults);
}
