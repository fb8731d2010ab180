use course::{Difference, draw_panels, target_folder, workspace};
use image::RgbImage;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use insta::{Settings, assert_binary_snapshot};
use std::fs;
use std::io::{self, ErrorKind};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};

/// The folder of the snapshots, seen from the workspace.
const SNAPSHOT_FOLDER: &str = "tests/snapshots";

/// Reads the locked picture `name` from its snapshot.
pub fn read_snapshot(name: &str) -> RgbImage {
    let path = snapshot_path(name);
    let picture = image::open(&path);
    picture.unwrap_or_else(|error| panic!("{}: {error}", path.display())).to_rgb8()
}

/// Fails unless `picture` is the locked picture `name` in every pixel.
///
/// Prints how they differ in one sentence, writes both and their difference into the
/// target folder, and prints, last, the command that accepts the new picture.
pub fn assert_matches_snapshot(name: &str, picture: &RgbImage) {
    let panels_path = differences_folder().join(format!("{name}.png"));
    let snapshot = fs::read(snapshot_path(name));
    // insta compares bytes, and another PNG encoder may write the same pixels otherwise:
    // where no pixel differs, insta is given the bytes of the snapshot.
    let png = match mismatch_message(name, picture, &snapshot, &panels_path) {
        None => {
            let _ = fs::remove_file(&panels_path);
            snapshot.expect("a snapshot of the same picture")
        }
        Some(message) => {
            eprintln!("{message}");
            encode_png(picture)
        }
    };
    // insta writes `.new` where a picture waits for review, and leaves it there once it is
    // accepted otherwise.
    let _ = fs::remove_file(snapshot_path(name).with_extension("new"));
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(workspace().join(SNAPSHOT_FOLDER));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    if let Ok(path) = panels_path.strip_prefix(workspace()) {
        settings.set_description(path.to_string_lossy().replace('\\', "/"));
    }
    let assert = || assert_binary_snapshot!(&format!("{name}.png"), png);
    let result = catch_unwind(AssertUnwindSafe(|| settings.bind(assert)));
    if let Err(panic) = result {
        eprintln!(
            "Is it meant? `INSTA_UPDATE=always cargo test --test pictures {name}` accepts it."
        );
        resume_unwind(panic);
    }
}

/// How `picture` differs from the snapshot with these bytes, or why that can't be told;
/// None if no pixel differs. Writes the panels of a difference to `panels_path`.
fn mismatch_message(
    name: &str,
    picture: &RgbImage,
    snapshot: &io::Result<Vec<u8>>,
    panels_path: &Path,
) -> Option<String> {
    let bytes = match snapshot {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            return Some(format!("{name} is not locked yet."));
        }
        Err(error) => {
            return Some(format!("The snapshot of {name} can't be read: {error}."));
        }
        Ok(bytes) => bytes,
    };
    let locked_picture = match image::load_from_memory(bytes) {
        Ok(image) => image.to_rgb8(),
        Err(error) => {
            return Some(format!("The snapshot of {name} is no picture: {error}."));
        }
    };
    let difference = Difference::between(&locked_picture, picture)?;
    let caption = match draw_panels(picture, &locked_picture).save(panels_path) {
        Ok(()) => "New, locked and difference (orange where the new one is brighter):",
        Err(_) => "The difference can't be written to",
    };
    Some(format!("{name}: {difference}.\n{caption} {}", panels_path.display()))
}

/// The path of the snapshot of the locked picture `name`.
fn snapshot_path(name: &str) -> PathBuf {
    workspace().join(SNAPSHOT_FOLDER).join(format!("{name}.snap.png"))
}

/// Encodes a picture as small as the encoder can, as the book shows this very file.
fn encode_png(picture: &RgbImage) -> Vec<u8> {
    let mut png = vec![];
    let (compression, filter) = (CompressionType::Best, FilterType::Adaptive);
    let encoder = PngEncoder::new_with_quality(&mut png, compression, filter);
    let result = picture.write_with_encoder(encoder);
    result.expect("a picture in memory can be encoded");
    png
}

/// The folder of the panels of pictures that differ from their snapshots.
fn differences_folder() -> PathBuf {
    let folder = target_folder().join("differences");
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}
