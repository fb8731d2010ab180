//! Every picture in the book is a locked one, or one of those of the mistakes that are
//! checked in, or what answers as it is printed, in every pixel.

use super::assert_none;
use super::built::{book, files};
use image::imageops::thumbnail;
use live::{LIVE, Sight};
use std::collections::HashMap;

#[test]
fn every_picture_is_locked_or_drawn_by_our_code() {
    let small = check::Step::ALL.into_iter().map(|step| {
        let picture = thumbnail(&step.picture(&live::camera(), 1), 320, 180);
        (format!("{}-small", step.name()), picture)
    });
    let printed = LIVE.iter().filter_map(|live| match live.printed() {
        Sight::Picture(picture) => Some((live.name.to_owned(), picture)),
        Sight::Drawing(_) => None,
    });
    let mut right: HashMap<_, _> = small.chain(printed).collect();
    let decoded = |png: &[u8]| Some(image::load_from_memory(png).ok()?.to_rgb8());
    for (file, png) in files("book/check/mistakes/pictures").0 {
        let name = file.strip_suffix(".png").map(|name| format!("mistake-{name}"));
        right.extend(name.zip(decoded(&png)));
    }
    for (file, png) in files("tests/snapshots").0 {
        let name = file.strip_suffix(".snap.png").map(str::to_owned);
        right.extend(name.zip(decoded(&png)));
    }
    let (book, mut faults) = (book(), vec![]);
    for page in book.chapters() {
        for img in page.all("img") {
            let source = img.attr("src").unwrap_or_default();
            let name = source.rsplit('/').next().unwrap_or_default();
            let name = name.trim_end_matches(".png");
            let shown = book.files.0.get(source).and_then(|png| decoded(png));
            if shown.is_none() || shown.as_ref() != right.get(name) {
                let at = page.at(img);
                faults.push(format!("{at}: {source} is not what our code draws."));
            }
        }
    }
    assert_none(&faults);
}
