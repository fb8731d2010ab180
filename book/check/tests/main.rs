//! `check`: its list of mistakes, and what it says of every picture that a reader may
//! bring.

mod answers;
mod damaged;
mod list;
mod program;

use check::{Answer, Locked, look};
use image::RgbImage;
use std::path::PathBuf;
use std::{fs, sync::LazyLock};

/// All pictures that there are to compare with.
fn locked() -> &'static [Locked] {
    static LOCKED: LazyLock<Result<Vec<Locked>, String>> =
        LazyLock::new(Locked::all);
    LOCKED.as_ref().expect("locked pictures")
}

/// The locked picture `name`.
fn right(name: &str) -> RgbImage {
    let one = locked().iter().find(|one| one.name == name);
    one.expect("a locked picture").picture.clone()
}

/// What is said of a picture; it has a dozen lines at most.
fn said(picture: &RgbImage, name: &str) -> String {
    let Answer { code, text, .. } = look(picture, Some(name), locked());
    assert!(code == 1 && text.lines().count() <= 12, "{text}");
    text
}

/// An empty folder of this test.
fn folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}
