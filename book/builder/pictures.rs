use crate::files::{CHAPTERS, Files};
use crate::module;
use anyhow::{Context, Result};
use check::Step;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::imageops::thumbnail;
use image::{RgbImage, load_from_memory};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What the file of a picture ends with that has half the size, for a small screen.
pub const HALF: &str = "-half.png";

/// What the file of a step's picture ends with that is as small as those of mistakes.
pub const SMALL: &str = "-small.png";

/// A wider picture has one of half the size beside it.
const WIDE: u32 = 1000;

/// Writes what the chapters show and what the pages load beside the chapters: the locked
/// snapshots, those of the mistakes, and the modules. Removes all else.
///
/// A file that is right already is left alone, so that a watching program is not
/// woken.
pub fn write(workspace: &Path) -> Result<()> {
    let folder = workspace.join(CHAPTERS).join("pictures");
    fs::create_dir_all(&folder)
        .with_context(|| format!("{} can't be made", folder.display()))?;
    let old = Files::read(&folder)?.0;
    let mistakes = Files::read(&workspace.join("book/check/mistakes/pictures"))?.0;
    let mistakes = mistakes.into_iter();
    let mut pictures: BTreeMap<_, _> =
        mistakes.map(|(name, bytes)| (format!("mistake-{name}"), bytes)).collect();
    let locked = Files::read(&workspace.join("tests/snapshots"))?.0;
    let packed = locked.par_iter().filter_map(|(name, bytes)| {
        let name = name.strip_suffix(".snap.png")?;
        let files = packed(name, bytes, &old);
        Some(files.with_context(|| format!("the locked picture {name}")))
    });
    pictures.extend(packed.collect::<Result<Vec<_>>>()?.concat());
    for name in Step::ALL.map(Step::name) {
        let picture = decoded(&locked[&format!("{name}.snap.png")])?;
        let small = png(&thumbnail(&picture, 320, 180))?;
        pictures.insert(format!("{name}{SMALL}"), small);
    }
    let mut names = vec![];
    for (name, bytes) in pictures {
        if old.get(&name) != Some(&bytes) {
            fs::write(folder.join(&name), bytes).with_context(|| name.clone())?;
        }
        names.push(name);
    }
    names.extend(module::write(workspace, &folder)?);
    for stale in old.keys().filter(|name| !names.contains(name)) {
        fs::remove_file(folder.join(stale)).with_context(|| stale.clone())?;
    }
    Ok(())
}

/// The files of a locked picture, packed for a page, and of its half if it is wide; the
/// `old` ones where they show it.
fn packed(
    name: &str,
    locked: &[u8],
    old: &BTreeMap<String, Vec<u8>>,
) -> Result<Vec<(String, Vec<u8>)>> {
    let picture = decoded(locked)?;
    let names = [".png", HALF].map(|end| format!("{name}{end}"));
    let [whole, smaller] = names.each_ref().map(|name| old.get(name).cloned());
    let shows_it = |png: &Vec<u8>| decoded(png).is_ok_and(|old| old == picture);
    let files = match (whole.filter(shows_it), smaller) {
        (Some(whole), Some(half)) => [Some(whole), Some(half)],
        (Some(whole), None) => [Some(whole), half(&picture)?],
        (None, _) => [Some(png(&picture)?), half(&picture)?],
    };
    let files = names.into_iter().zip(files);
    Ok(files.filter_map(|(name, file)| Some((name, file?))).collect())
}

fn decoded(png: &[u8]) -> Result<RgbImage> {
    Ok(load_from_memory(png)?.into_rgb8())
}

/// A wide picture in half its size.
fn half(picture: &RgbImage) -> Result<Option<Vec<u8>>> {
    let (width, height) = picture.dimensions();
    let half = || png(&thumbnail(picture, width / 2, height / 2));
    (WIDE <= width).then(half).transpose()
}

/// A PNG file of the picture, packed as well as the encoder can: a page waits for it.
fn png(picture: &RgbImage) -> Result<Vec<u8>> {
    let mut png = vec![];
    let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
    let encoder = PngEncoder::new_with_quality(&mut png, best, filter);
    picture.write_with_encoder(encoder)?;
    Ok(png)
}

#[test]
fn a_wide_picture_is_halved() -> Result<()> {
    let square = |side: u32| RgbImage::from_pixel(side, side, [10, 20, 30].into());
    assert_eq!(half(&square(WIDE - 1))?, None);
    assert_eq!(half(&square(WIDE))?, Some(png(&square(WIDE / 2))?));
    Ok(())
}
