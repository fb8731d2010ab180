//! Every picture in the book is a locked one, or one that the gallery of mistakes or what
//! answers draws, in every pixel.

use super::built::{BOOK, files};
use super::{assert_found, assert_none};
use book::{Files, Site};
use gallery::mistakes;
use image::{DynamicImage, RgbImage, RgbaImage};
use live::{LIVE, Live, Sight};
use std::{collections::HashMap, sync::LazyLock};

/// What the gallery draws, and what answers as it is printed, by the names of the
/// pictures.
static DRAWN: LazyLock<HashMap<String, RgbImage>> = LazyLock::new(|| {
    let shown =
        mistakes().flat_map(|one| one.shown().map(move |shown| (one, shown)));
    let gallery = shown.map(|(mistake, (step, name))| (name, mistake.show(step)));
    gallery.chain(LIVE.into_iter().filter_map(printed)).collect()
});

/// The name of what answers, and its picture as it is printed, if it is one.
fn printed(live: &Live) -> Option<(String, RgbImage)> {
    let Sight::Picture { size: [width, height], pixels } =
        (live.sight)(&live.values())
    else {
        return None;
    };
    let picture = RgbaImage::from_raw(width, height, pixels)?;
    Some((live.name.to_owned(), DynamicImage::from(picture).to_rgb8()))
}

static SNAPSHOTS: LazyLock<Files> = LazyLock::new(|| files("tests/snapshots"));

/// Each picture in a chapter that is not the snapshot of its name, nor what the gallery
/// draws.
fn faults(book: &Site, snapshots: &Files) -> Vec<String> {
    let mut faults = vec![];
    for page in book.chapters() {
        for img in page.all("img") {
            let source = img.get("src").unwrap_or_default();
            let name = source.rsplit('/').next().unwrap_or_default();
            let name = name.trim_end_matches(".png");
            let decoded = |png: Option<&Vec<u8>>| {
                Some(image::load_from_memory(png?).ok()?.to_rgb8())
            };
            let shown = decoded(book.files.0.get(source));
            let snapshot = format!("{name}.snap.png");
            let what = match (decoded(snapshots.0.get(&snapshot)), DRAWN.get(name))
            {
                (Some(locked), _) if shown.as_ref() == Some(&locked) => continue,
                (None, Some(drawn)) if shown.as_ref() == Some(drawn) => continue,
                (None, None) => "is not locked",
                (None, _) => "is not what our code draws",
                _ => "is not the locked one",
            };
            faults
                .push(format!("The picture {source} at {} {what}.", page.at(img)));
        }
    }
    faults
}

#[test]
fn every_picture_is_locked() {
    assert_none(&faults(&BOOK, &SNAPSHOTS));
}

#[test]
fn a_changed_picture_is_found() {
    let mut book = BOOK.clone();
    let files = &mut book.files.0;
    let other = files["pictures/mistake-mirrored.png"].clone();
    files.insert("pictures/mistake-y-down.png".to_owned(), other.clone());
    files.insert("pictures/step02_sphere.png".to_owned(), other);
    let faults = faults(&book, &SNAPSHOTS);
    for words in [
        ["step02_sphere.png", "line ", "step02_sphere.html", "the locked one"],
        ["mistake-y-down.png", "line ", "mistakes.html", "our code draws"],
    ] {
        let found = |fault: &String| words.iter().all(|word| fault.contains(word));
        assert!(faults.iter().any(found), "{words:?}: {faults:?}");
    }
}

#[test]
fn a_picture_that_is_not_locked_is_found() {
    let book = BOOK.with_html("<img src=\"pictures/mine.png\" alt=\"Mine\">");
    assert_found(
        &faults(&book, &SNAPSHOTS),
        &["pictures/mine.png", "step01_rays.html", "is not locked"],
    );
}
