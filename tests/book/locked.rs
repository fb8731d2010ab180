//! Every picture in the book is a locked one, the very same file, or one that the
//! gallery of mistakes draws.

use crate::book::{BOOK, files};
use crate::{assert_found, assert_none};
use book::{Files, Site};
use gallery::{Mistake, mistakes};
use std::sync::LazyLock;

static SNAPSHOTS: LazyLock<Files> = LazyLock::new(|| files("tests/snapshots"));

/// Each picture in a chapter that is not, byte for byte, the snapshot of its name.
fn faults(book: &Site, snapshots: &Files) -> Vec<String> {
    let mut faults = vec![];
    for page in book.chapters() {
        for img in page.all("img") {
            let source = img.get("src").unwrap_or_default();
            let name = source.rsplit('/').next().unwrap_or_default();
            let name = name.trim_end_matches(".png");
            if mistakes().flat_map(Mistake::shown).any(|(_, shown)| shown == name) {
                continue;
            }
            let snapshot = format!("{name}.snap.png");
            let what = match (book.files.0.get(source), snapshots.0.get(&snapshot))
            {
                (Some(shown), Some(locked)) if shown == locked => continue,
                (_, None) => "is not locked",
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
    let picture = book.files.0.get_mut("pictures/step02_sphere.png");
    picture.expect("the picture of step 2").push(0);
    let words = [
        "pictures/step02_sphere.png",
        "line ",
        "step02_sphere.html",
        "is not the locked one",
    ];
    let faults = faults(&book, &SNAPSHOTS);
    assert!(
        faults.iter().any(|fault| words.iter().all(|word| fault.contains(word))),
        "{faults:?}"
    );
}

#[test]
fn a_picture_that_is_not_locked_is_found() {
    let book = BOOK.with_html("<img src=\"pictures/mine.png\" alt=\"Mine\">");
    assert_found(
        &faults(&book, &SNAPSHOTS),
        &["pictures/mine.png", "step01_rays.html", "is not locked"],
    );
}
