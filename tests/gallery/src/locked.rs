use crate::{Step, png};
use image::RgbImage;
use std::path::Path;

/// The exercises, by the names of their locked pictures.
///
/// One without a snapshot is not offered, and a snapshot that is not listed here, such
/// as that of the cover, is not compared with.
pub const EXERCISES: [&str; 16] = [
    "graticule",
    "look_at",
    "panorama",
    "plane",
    "quadric",
    "lens",
    "depth",
    "jitter",
    "many",
    "gamma",
    "sun",
    "spot",
    "shadows",
    "halfway",
    "mirror",
    "glass",
];

/// The names of all pictures that there are to compare with, steps first.
pub fn names() -> Vec<&'static str> {
    let there = |name: &&str| Path::new(&path(name)).exists();
    let steps = Step::ALL.into_iter().map(Step::name);
    steps.chain(EXERCISES).filter(there).collect()
}

/// The locked picture `name`, or a sentence about why it can't be had.
pub fn locked(name: &str) -> Result<RgbImage, String> {
    png::read(Path::new(&path(name)))
}

fn path(name: &str) -> String {
    format!("{}/../snapshots/{name}.snap.png", env!("CARGO_MANIFEST_DIR"))
}
