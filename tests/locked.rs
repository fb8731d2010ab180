use compare::{Difference, panels, target_folder, workspace};
use image::RgbImage;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use insta::{Settings, assert_binary_snapshot};
use std::fs;
use std::io::{self, ErrorKind};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};

/// The folder of the locked pictures.
const SNAPSHOTS: &str = "tests/snapshots";

/// The locked picture `name`, from its snapshot.
pub fn locked(name: &str) -> RgbImage {
    let path = snapshot_path(name);
    let picture = image::open(&path);
    picture.unwrap_or_else(|error| panic!("{}: {error}", path.display())).to_rgb8()
}

/// Fails unless `picture` is the locked picture `name` in every pixel.
///
/// A difference is told in one sentence and drawn into the target folder; the last line is
/// the command that accepts the new picture.
pub fn assert_locked(name: &str, picture: &RgbImage) {
    let panels_path = differences().join(format!("{name}.png"));
    let locked_file = fs::read(snapshot_path(name));
    // insta compares files; the same picture from another PNG encoder is no change.
    let file = match complaint(name, picture, &locked_file, &panels_path) {
        None => {
            let _ = fs::remove_file(&panels_path);
            locked_file.expect("a file with the same picture")
        }
        Some(complaint) => {
            eprintln!("{complaint}");
            png(picture)
        }
    };
    // insta writes it anew where it is to be reviewed, and forgets it where it is accepted.
    let _ = fs::remove_file(snapshot_path(name).with_extension("new"));
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(workspace().join(SNAPSHOTS));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    if let Ok(path) = panels_path.strip_prefix(workspace()) {
        settings.set_description(path.to_string_lossy().replace('\\', "/"));
    }
    let assert = || assert_binary_snapshot!(&format!("{name}.png"), file);
    let asserted = catch_unwind(AssertUnwindSafe(|| settings.bind(assert)));
    if let Err(panic) = asserted {
        eprintln!(
            "Is it meant? `INSTA_UPDATE=always cargo test --test pictures {name}` accepts it."
        );
        resume_unwind(panic);
    }
}

/// How `picture` differs from the one in the locked file, drawn as panels, too; None where
/// it does not.
fn complaint(
    name: &str,
    picture: &RgbImage,
    locked_file: &io::Result<Vec<u8>>,
    panels_path: &Path,
) -> Option<String> {
    let decoded = match locked_file {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            return Some(format!("{name} is not locked yet."));
        }
        Err(error) => {
            return Some(format!("The snapshot of {name} can't be read: {error}."));
        }
        Ok(bytes) => image::load_from_memory(bytes),
    };
    let locked = match decoded {
        Ok(locked) => locked.to_rgb8(),
        Err(error) => {
            return Some(format!("The snapshot of {name} is no picture: {error}."));
        }
    };
    let difference = Difference::between(&locked, picture)?;
    let shown = match panels(picture, &locked).save(panels_path) {
        Ok(()) => {
            "New, locked and difference (orange where the new one is brighter):"
        }
        Err(_) => "The difference can't be written to",
    };
    Some(format!("{name}: {difference}.\n{shown} {}", panels_path.display()))
}

/// The file of the locked picture `name`.
fn snapshot_path(name: &str) -> PathBuf {
    workspace().join(SNAPSHOTS).join(format!("{name}.snap.png"))
}

/// A PNG file as small as the encoder can make it: the book shows it as it is.
fn png(picture: &RgbImage) -> Vec<u8> {
    let mut png = vec![];
    let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
    let encoder = PngEncoder::new_with_quality(&mut png, best, filter);
    let written = picture.write_with_encoder(encoder);
    written.expect("a picture in memory can be encoded");
    png
}

/// The folder of the pictures of differences.
fn differences() -> PathBuf {
    let folder = target_folder().join("differences");
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}
