use crate::files::{CHAPTERS, Files};
use anyhow::{Context, Result};
use base64::prelude::{BASE64_STANDARD, Engine};
use course::Step;
use course::target_folder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::imageops::thumbnail;
use image::{ImageReader, RgbImage};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Cursor;
use std::path::Path;

/// The end of the name of a picture of half the size, for a small screen.
pub const HALF_SUFFIX: &str = "-half.png";

/// The end of the name of a step's picture that is as small as those of mistakes.
pub const THUMBNAIL_SUFFIX: &str = "-small.png";

/// A wider picture has one of half the size beside it.
const MIN_WIDTH_OF_HALF: u32 = 1000;

/// The modules of the pages: what answers, what looks at a reader's picture, and what draws a
/// line of the reader's.
const MODULES: [&str; 3] = ["live", "check", "expressions"];

/// Writes what the chapters show and what the pages load: the locked snapshots as they are,
/// the pictures of the mistakes, and the modules. Removes all else. One process does so at a time.
pub fn write_generated_files(workspace: &Path) -> Result<()> {
    let lock = File::create(target_folder().join("book.lock"))?;
    lock.lock()?;
    let folder = workspace.join(CHAPTERS).join("generated");
    fs::create_dir_all(&folder).with_context(|| format!("{} can't be made", folder.display()))?;
    let old = Files::read(&folder)?.0;
    let mistakes = Files::read(&workspace.join("book/crates/course/mistakes/pictures"))?.0;
    let mistakes = mistakes.into_iter();
    let mut files: BTreeMap<_, _> =
        mistakes.map(|(name, bytes)| (format!("mistake-{name}"), bytes)).collect();
    for (name, bytes) in Files::read(&workspace.join("tests/snapshots"))?.0 {
        let Some(name) = name.strip_suffix(".snap.png") else { continue };
        files.extend(named_smaller_picture(name, &bytes).with_context(|| name.to_owned())?);
        files.insert(format!("{name}.png"), bytes);
    }
    for name in MODULES {
        // A page that was opened from a folder may load scripts, and nothing else.
        let module = fs::read(workspace.join(format!("book/crates/page/{name}.wasm")))
            .with_context(|| format!("the module {name}.wasm can't be read"))?;
        let module = BASE64_STANDARD.encode(module);
        let script = format!("wasmModules.provide(\"{name}\", \"{module}\");\n");
        files.insert(format!("{name}-module.js"), script.into_bytes());
    }
    for (name, bytes) in &files {
        if old.get(name) != Some(bytes) {
            fs::write(folder.join(name), bytes).with_context(|| name.clone())?;
        }
    }
    for stale in old.keys().filter(|name| !files.contains_key(*name)) {
        let _ = fs::remove_file(folder.join(stale));
    }
    Ok(())
}

/// The smaller pictures that go with the locked picture `name`: half of a wide one, and a
/// step's beside those of its mistakes.
fn named_smaller_picture(name: &str, file: &[u8]) -> Result<Option<(String, Vec<u8>)>> {
    let (width, height) =
        ImageReader::new(Cursor::new(file)).with_guessed_format()?.into_dimensions()?;
    let (end, part) = match Step::from_name(name) {
        _ if MIN_WIDTH_OF_HALF <= width => (HALF_SUFFIX, 2),
        Some(_) => (THUMBNAIL_SUFFIX, width / 320),
        None => return Ok(None),
    };
    let picture = image::load_from_memory(file)?.into_rgb8();
    let small = thumbnail(&picture, width / part, height / part);
    Ok(Some((format!("{name}{end}"), encode_png(&small)?)))
}

/// A PNG file of the picture, packed as well as the encoder can: a page waits for it.
fn encode_png(picture: &RgbImage) -> Result<Vec<u8>> {
    let mut png = vec![];
    let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
    let encoder = PngEncoder::new_with_quality(&mut png, best, filter);
    picture.write_with_encoder(encoder)?;
    Ok(png)
}
