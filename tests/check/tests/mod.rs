//! The gallery of mistakes, and what `check` says of every picture that a reader may
//! bring.

mod answers;
mod damaged;
mod edits;
mod formulas;
mod kinds;
mod measure;
mod mistakes;
mod program;
mod slips;

use ::check::Locked;
use gallery::{Mistake, Parts, Step, camera};
use image::RgbImage;
use std::path::{Path, PathBuf};
use std::{fs, sync::LazyLock};

/// An empty folder of this test.
fn folder(test: &str) -> PathBuf {
    let folder = tests::target().join("tests").join(format!("check-{test}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}

fn opened(path: &Path) -> RgbImage {
    image::open(path).expect("a PNG").to_rgb8()
}

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

fn named(name: &str) -> &'static Mistake {
    gallery::mistakes().find(|mistake| mistake.name == name).expect(name)
}

/// The picture of `step` with all these mistakes in it.
fn made(step: Step, names: &[&str], size: (u32, u32), samples: u32) -> RgbImage {
    let mut parts = Parts::right(&camera(size.0, size.1));
    names.iter().for_each(|name| (named(name).change)(&mut parts));
    parts.picture(step, samples)
}
