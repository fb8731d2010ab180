//! Every picture in the book is a locked one, or one of those of the mistakes that are
//! checked in, or what answers as it is printed, in every pixel.

use super::built::{BOOK, files};
use super::{assert_found, assert_none};
use book::{Files, Site};
use image::imageops::thumbnail;
use image::{DynamicImage, RgbImage, RgbaImage};
use live::{LIVE, Live, Sight};
use std::{collections::HashMap, sync::LazyLock};

/// What is checked in of mistakes, the steps' own pictures as small, and what answers as
/// it is printed, by the names of the pictures.
static DRAWN: LazyLock<HashMap<String, RgbImage>> = LazyLock::new(|| {
    let mistakes = files("book/check/mistakes/pictures").0.into_iter();
    let mistakes = mistakes.filter_map(|(name, png)| {
        let name = name.strip_suffix(".png")?;
        Some((format!("mistake-{name}"), decoded(Some(&png))?))
    });
    let small = check::Step::ALL.into_iter().map(|step| {
        let picture = thumbnail(&step.picture(&live::camera(), 1), 320, 180);
        (format!("{}-small", step.name()), picture)
    });
    let printed = LIVE.into_iter().filter_map(printed);
    mistakes.chain(small).chain(printed).collect()
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

fn decoded(png: Option<&Vec<u8>>) -> Option<RgbImage> {
    Some(image::load_from_memory(png?).ok()?.to_rgb8())
}

static SNAPSHOTS: LazyLock<Files> = LazyLock::new(|| files("tests/snapshots"));

/// Each picture in a chapter that is not the snapshot of its name, nor what is checked
/// in of a mistake.
fn faults(book: &Site, snapshots: &Files) -> Vec<String> {
    let mut faults = vec![];
    for page in book.chapters() {
        for img in page.all("img") {
            let source = img.get("src").unwrap_or_default();
            let name = source.rsplit('/').next().unwrap_or_default();
            let name = name.trim_end_matches(".png");
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
