use crate::files::{CHAPTERS, Files};
use crate::picture::size;
use crate::{gallery, module};
use anyhow::{Context, Result, anyhow};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::imageops::thumbnail;
use image::{ExtendedColorType, ImageEncoder, load_from_memory};
use live::Sight;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What the file of a picture ends with that has half the size, for a small screen.
pub const HALF: &str = "-half.png";

/// A wider picture has one of half the size beside it.
const WIDE: u32 = 1000;

/// Writes what the chapters show and what the pages load beside the chapters: the locked
/// snapshots, the gallery of mistakes, what is seen first of them live, and the modules.
/// Removes all else.
///
/// A file that is right already is left alone, so that a watching program is not
/// woken.
pub fn write(workspace: &Path) -> Result<()> {
    let folder = workspace.join(CHAPTERS).join("pictures");
    fs::create_dir_all(&folder)
        .with_context(|| format!("{} can't be made", folder.display()))?;
    let mut names = gallery::draw(&folder)?;
    let old = Files::read(&folder)?.0;
    let mut pictures = BTreeMap::from([("mistakes.png".to_owned(), mistakes()?)]);
    for (name, bytes) in Files::read(&workspace.join("tests/snapshots"))?.0 {
        let Some(name) = name.strip_suffix(".snap.png") else { continue };
        let (whole, smaller) = (format!("{name}.png"), format!("{name}{HALF}"));
        let half = match old.get(&smaller) {
            Some(half) if old.get(&whole) == Some(&bytes) => Some(half.clone()),
            _ => half(&bytes).with_context(|| name.to_owned())?,
        };
        pictures.extend(half.map(|half| (smaller, half)));
        pictures.insert(whole, bytes);
    }
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

/// What the gallery shows before its reader chooses.
fn mistakes() -> Result<Vec<u8>> {
    let live = live::find("mistakes").context("the live mistakes")?;
    match (live.sight)(&live.values()) {
        Sight::Picture { size, pixels } => {
            encoded(size, &pixels, ExtendedColorType::Rgba8)
        }
        Sight::Drawing(_) => Err(anyhow!("the live mistakes are no picture")),
    }
}

/// A wide picture in half its size.
fn half(png: &[u8]) -> Result<Option<Vec<u8>>> {
    let (width, height) = size(png).context("it is not a PNG file")?;
    if width < WIDE {
        return Ok(None);
    }
    let picture = load_from_memory(png)?.into_rgb8();
    let half = thumbnail(&picture, width / 2, height / 2);
    encoded([width / 2, height / 2], &half, ExtendedColorType::Rgb8).map(Some)
}

/// A PNG file of these pixels.
fn encoded(
    [width, height]: [u32; 2],
    pixels: &[u8],
    colours: ExtendedColorType,
) -> Result<Vec<u8>> {
    let mut png = vec![];
    PngEncoder::new_with_quality(
        &mut png,
        CompressionType::Default,
        FilterType::Adaptive,
    )
    .write_image(pixels, width, height, colours)?;
    Ok(png)
}

#[test]
fn a_wide_picture_is_halved() -> Result<()> {
    let square = |side: u32| {
        let pixels = vec![[10, 20, 30]; (side * side) as usize].concat();
        encoded([side, side], &pixels, ExtendedColorType::Rgb8)
    };
    assert_eq!(half(&square(WIDE - 1)?)?, None);
    assert_eq!(half(&square(WIDE)?)?, Some(square(WIDE / 2)?));
    Ok(())
}
