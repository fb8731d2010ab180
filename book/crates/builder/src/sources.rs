//! Access to everything that the chapters show: files, pictures, modules, and computed values.

use crate::values::Values;
use crate::{Files, figure_file};
use anyhow::{Context, Result};
use base64::prelude::{BASE64_STANDARD, Engine};
use course::{Step, WASM_MODULES, camera_with_size, encode_png};
use image::ImageReader;
use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// The folder for the files that a build generates. In the source, this folder is beside the
/// chapters. In the finished book, it is beside the pages.
pub const GENERATED: &str = "generated/";

/// The widths, in device pixels, of the cover's versions for small screens. On a phone, the cover
/// is 43 CSS pixels narrower than the window. So 720 is enough for a window with 390 CSS pixels of
/// 2 device pixels each, and 960 is enough for a window with 360 CSS pixels of 3 device pixels
/// each.
const COVER_COLUMNS: [u32; 2] = [720, 960];

/// Each pixel of the cover has this number of sub-pixels in each direction.
const COVER_SAMPLES: u32 = 4;

/// Access to everything that the chapters show.
#[derive(Debug)]
pub struct Sources {
    /// The root of the workspace, from which listings are read.
    pub workspace: PathBuf,
    /// The pictures and scripts in `generated/`.
    pub generated: Files,
    /// The values that `{{#value …}}` puts into a chapter.
    pub values: Values,
}

impl Sources {
    /// Reads the locked pictures, the pictures of the mistakes, and the modules. Draws the figures,
    /// and the versions of the cover for small screens.
    pub fn read(workspace: &Path) -> Result<Self> {
        let mut generated = Files::default();
        let files = &mut generated.0;
        for (name, bytes) in Files::read(&workspace.join("tests/snapshots"))?.0 {
            if let Some(name) = name.strip_suffix(".snap.png") {
                files.insert(format!("{name}.png"), bytes);
            }
        }
        for step in Step::ALL {
            let locked_png = files
                .get(&format!("{}.png", step.name()))
                .with_context(|| format!("{} has no locked picture", step.name()))?;
            let locked = image::load_from_memory(locked_png)?.into_rgb8();
            let small = encode_png(&course::make_small_picture(&locked));
            files.insert(small_picture_name(step), small);
            for (name, picture) in
                course::read_small_mistake_pictures(workspace, step).with_context(|| step.name())?
            {
                files.insert(format!("mistake-{name}.png"), encode_png(&picture));
            }
        }
        for columns in COVER_COLUMNS {
            let camera = camera_with_size(columns, columns * 9 / 16);
            let cover = Step::Phong.draw_function()(&camera, COVER_SAMPLES);
            files.insert(cover_version_name("cover", columns), encode_png(&cover));
        }
        for name in WASM_MODULES {
            let module = fs::read(workspace.join(format!("book/crates/page/{name}.wasm")))
                .with_context(|| format!("the module {name}.wasm can't be read"))?;
            insert_bytes_as_script(files, &format!("{name}-module"), &module);
        }
        files.extend(figure_file::svg_files_of_drawings(workspace)?);
        let texts = course::mistake_files().map(|texts| texts.join()).unwrap_or_default();
        insert_bytes_as_script(files, "mistakes", texts.as_bytes());
        Ok(Self { workspace: workspace.to_owned(), generated, values: Values::default() })
    }

    /// The width and height, in pixels, of the picture with the address `source`. Returns None if
    /// there is no such picture in `generated/`.
    pub fn picture_size(&self, source: &str) -> Option<(u32, u32)> {
        let file = self.generated.0.get(source.strip_prefix(GENERATED)?)?;
        ImageReader::new(Cursor::new(file)).with_guessed_format().ok()?.into_dimensions().ok()
    }

    /// The width and address of each smaller version of a picture. Only the cover has smaller
    /// versions.
    pub fn smaller_versions(&self, source: &str) -> Vec<(u32, String)> {
        let name = source.strip_suffix(".png").unwrap_or(source);
        let versions = COVER_COLUMNS.map(|columns| (columns, cover_version_name(name, columns)));
        versions.into_iter().filter(|(_, source)| self.picture_size(source).is_some()).collect()
    }
}

/// The name of a smaller version of a picture. `name` is the picture's name without `.png`, and
/// `columns` is the version's width in pixels.
fn cover_version_name(name: &str, columns: u32) -> String {
    format!("{name}-{columns}.png")
}

/// The file name of the small version of a step's correct picture. This version has the same size
/// as the pictures of mistakes.
pub fn small_picture_name(step: Step) -> String {
    format!("{}-small.png", step.name())
}

/// Inserts a script that contains these bytes. A page that was opened from a disk can load scripts
/// but can't fetch data, so all data has to be in scripts.
fn insert_bytes_as_script(files: &mut BTreeMap<String, Vec<u8>>, name: &str, bytes: &[u8]) {
    let bytes = BASE64_STANDARD.encode(bytes);
    let script = format!("book.modules.provide(\"{name}\", \"{bytes}\");\n");
    files.insert(format!("{name}.js"), script.into_bytes());
}
