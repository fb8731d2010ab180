//! The picture is the output: every picture in the book has the pixels of a locked one, of
//! a mistake's, of a step's made small, or of what answers on the page, as it is printed.

use super::assert_no_faults;
use super::built_book::{built_book, read_folder};
use image::RgbImage;
use image::imageops::thumbnail;
use live::{LIVE, Output};
use std::collections::HashMap;
use tests::camera;

/// The pictures that the book may show, by the name of their file.
fn expected_pictures() -> HashMap<String, RgbImage> {
    let small_pictures = exercises::STEPS.into_iter().map(|(name, draw)| {
        let picture = thumbnail(&draw(&camera(), 1), 320, 180);
        (format!("{name}-small"), picture)
    });
    let live_pictures =
        LIVE.iter().filter_map(|live| match live.default_output() {
            Output::Picture(picture) => Some((live.name.to_owned(), picture)),
            Output::Drawing(_) => None,
        });
    let mut pictures: HashMap<_, _> = small_pictures.chain(live_pictures).collect();
    for (file, png) in read_folder("book/check/mistakes/pictures").0 {
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
                faults.push(format!(
                    "{location}: {source} is not what our code draws."
                ));
            }
        }
    }
    assert_no_faults(&faults);
}
