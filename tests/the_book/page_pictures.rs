//! The picture is the output: every picture in the book is a locked one, a mistake's, or a
//! step's made small. Each is on a page, and what is said of a mistake's is so.

use super::assert_no_faults;
use super::built_book::{built_book, read_folder};
use builder::{effect_and_step_of_picture, inner_text, select_all};
use course::{Step, read_small_pictures, workspace};
use image::RgbImage;
use image::imageops::thumbnail;
use std::collections::{BTreeMap, HashMap};
use tests::camera;

/// The locked pictures, by the name that each has in the book.
fn locked_pictures() -> HashMap<String, Vec<u8>> {
    let snapshots = read_folder("tests/snapshots").0.into_iter();
    snapshots.map(|(file, png)| (file.replace(".snap.", "."), png)).collect()
}

/// The pictures of mistakes, and those of the steps made small, by the name that each has in the
/// book.
fn small_pictures() -> HashMap<String, RgbImage> {
    let mut pictures = HashMap::new();
    for step in Step::ALL {
        let small = thumbnail(&step.picture()(&camera(), 1), 320, 180);
        pictures.insert(format!("{}-small.png", step.name()), small);
        let mistakes = read_small_pictures(&workspace(), step).expect("small pictures");
        pictures
            .extend(mistakes.into_iter().map(|(name, one)| (format!("mistake-{name}.png"), one)));
    }
    pictures
}

#[test]
fn pictures_are_those_that_our_code_draws() {
    let (locked, small, book) = (locked_pictures(), small_pictures(), built_book());
    let mut locations = BTreeMap::new();
    for page in book.chapters_in_order() {
        for img in page.select_all("img") {
            let source = img.attr("src").unwrap_or_default();
            locations.insert(source, page.address_for_fault(img));
        }
    }
    locations.retain(|source, _| {
        let file = source.rsplit('/').next().unwrap_or_default();
        !book.files.0.get(*source).is_some_and(|png| match locked.get(file) {
            Some(locked_png) => png == locked_png,
            None => {
                image::load_from_memory(png).ok().map(|image| image.to_rgb8()).as_ref()
                    == small.get(file)
            }
        })
    });
    let faults = locations.iter();
    let faults = faults.map(|(file, place)| format!("{place}: {file} is not what our code draws."));
    assert_no_faults(&faults.collect::<Vec<_>>());
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
