use crate::files::{CHAPTERS, Files};
use anyhow::{Context, Result};
use base64::prelude::{BASE64_STANDARD, Engine};
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

/// The modules of the pages: what answers, and what looks at a reader's picture.
const MODULES: [&str; 2] = ["live", "check"];

/// Writes what the chapters show and what the pages load: the locked snapshots, those of
/// the mistakes, and the modules. Removes all else.
pub fn write(workspace: &Path) -> Result<()> {
    let folder = workspace.join(CHAPTERS).join("pictures");
    fs::create_dir_all(&folder)
        .with_context(|| format!("{} can't be made", folder.display()))?;
    let old = Files::read(&folder)?.0;
    let mistakes = Files::read(&workspace.join("book/check/mistakes/pictures"))?.0;
    let mistakes = mistakes.into_iter();
    let mut files: BTreeMap<_, _> =
        mistakes.map(|(name, bytes)| (format!("mistake-{name}"), bytes)).collect();
    let locked = Files::read(&workspace.join("tests/snapshots"))?.0;
    let packed = locked.par_iter().filter_map(|(name, bytes)| {
        let name = name.strip_suffix(".snap.png")?;
        let files = packed(name, bytes, &old);
        Some(files.with_context(|| format!("the locked picture {name}")))
    });
    files.extend(packed.collect::<Result<Vec<_>>>()?.concat());
    for name in Step::ALL.map(Step::name) {
        let picture = decoded(&locked[&format!("{name}.snap.png")])?;
        let small = png(&thumbnail(&picture, 320, 180))?;
        files.insert(format!("{name}{SMALL}"), small);
    }
    for name in MODULES {
        // A page that was opened from a folder may load scripts, and nothing else.
        let module = fs::read(workspace.join(format!("book/wasm/{name}.wasm")))
            .with_context(|| format!("the module {name}.wasm can't be read"))?;
        let module = BASE64_STANDARD.encode(module);
        let script = format!("liveModule.come(\"{name}\", \"{module}\");\n");
        files.insert(format!("{name}-module.js"), script.into_bytes());
    }
    for (name, bytes) in &files {
        if old.get(name) != Some(bytes) {
            fs::write(folder.join(name), bytes).with_context(|| name.clone())?;
        }
    }
    for stale in old.keys().filter(|name| !files.contains_key(*name)) {
        fs::remove_file(folder.join(stale)).with_context(|| stale.clone())?;
    }
    Ok(())
}

/// The files of a locked picture, packed for a page, and of its half if it is wide; the
/// `old` ones where they show it, as packing takes long.
fn packed(
    name: &str,
    locked: &[u8],
    old: &BTreeMap<String, Vec<u8>>,
) -> Result<Vec<(String, Vec<u8>)>> {
    let picture = decoded(locked)?;
    let (width, height) = picture.dimensions();
    let shows_it = |png: &Vec<u8>| decoded(png).is_ok_and(|old| old == picture);
    let name = |end| format!("{name}{end}");
    let (whole, half) = (name(".png"), name(HALF));
    let old_whole = old.get(&whole).filter(|png| shows_it(png));
    let mut files =
        vec![(whole, old_whole.cloned().map_or_else(|| png(&picture), Ok)?)];
    if WIDE <= width {
        let old = old.get(&half).filter(|_| old_whole.is_some()).cloned();
        let smaller = || png(&thumbnail(&picture, width / 2, height / 2));
        files.push((half, old.map_or_else(smaller, Ok)?));
    }
    Ok(files)
}

fn decoded(png: &[u8]) -> Result<RgbImage> {
    Ok(load_from_memory(png)?.into_rgb8())
}

/// A PNG file of the picture, packed as well as the encoder can: a page waits for it.
fn png(picture: &RgbImage) -> Result<Vec<u8>> {
    let mut png = vec![];
    let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
    let encoder = PngEncoder::new_with_quality(&mut png, best, filter);
    picture.write_with_encoder(encoder)?;
    Ok(png)
}
