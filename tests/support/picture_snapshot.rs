use course::{Difference, draw_panels, target_folder, workspace};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ImageResult, RgbImage};
use insta::internals::SnapshotContents;
use insta::{Comparator, Settings, Snapshot};
use std::path::PathBuf;
use std::{env, fs, thread};

/// Reads the locked picture `name` from its snapshot.
pub fn read_snapshot(name: &str) -> RgbImage {
    let path = snapshot_path(name, "snap.png");
    let picture = image::open(&path);
    picture.unwrap_or_else(|error| panic!("{}: {error}", path.display())).to_rgb8()
}

/// Compares `picture` with the snapshot `name`, pixel by pixel: `assert` hands the PNG file
/// that it is given to insta.
///
/// Prints how they differ in one sentence before insta says anything, writes both and their
/// difference into the target folder, and prints, last, the command that accepts the picture.
pub fn compare_pixels(name: &str, picture: &RgbImage, assert: impl FnOnce(Vec<u8>)) {
    let _review = PendingReview::read(name);
    let snapshot = snapshot_path(name, "snap");
    if !snapshot.exists() {
        println!("{name}: it is not locked, there is no file {}.", snapshot.display());
    }
    let mut settings = Settings::clone_current();
    settings.set_comparator(Box::new(PixelComparator { name: name.to_owned() }));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    if let Ok(path) = panels_path(name).strip_prefix(workspace()) {
        settings.set_description(path.to_string_lossy().replace('\\', "/"));
    }
    // Encoding takes longer than drawing: a picture that is locked keeps its file.
    let locked_png = fs::read(snapshot_path(name, "snap.png")).ok();
    let is_locked = |png: &Vec<u8>| decode(png).is_ok_and(|locked| locked == *picture);
    let png = locked_png.filter(is_locked).unwrap_or_else(|| encode_small(picture));
    settings.bind(|| assert(png));
}

/// Compares the pixels of two pictures, as another encoder may write the same ones otherwise.
#[derive(Clone)]
struct PixelComparator {
    /// The name of the locked picture.
    name: String,
}

impl Comparator for PixelComparator {
    fn matches(&self, locked: &Snapshot, new: &Snapshot) -> bool {
        let mismatch = describe_mismatch(&self.name, locked.contents(), new.contents());
        match &mismatch {
            Some(text) => println!("{}: {text}", self.name),
            None => drop(fs::remove_file(panels_path(&self.name))),
        }
        mismatch.is_none()
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// How the pixels of two pictures differ, or why that can't be told; None if they are equal.
/// Writes the panels of a difference.
fn describe_mismatch(
    name: &str,
    locked: &SnapshotContents,
    new: &SnapshotContents,
) -> Option<String> {
    if locked == new {
        return None;
    }
    let path = snapshot_path(name, "snap.png");
    let SnapshotContents::Binary(Some(locked)) = locked else {
        return Some(format!("there is no picture {}.", path.display()));
    };
    let SnapshotContents::Binary(Some(new)) = new else { return Some("it is no picture.".into()) };
    let [locked, new] = match [decode(locked), decode(new)] {
        [Ok(locked), Ok(new)] => [locked, new],
        [Err(error), _] | [_, Err(error)] => {
            return Some(format!("{} can't be read: {error}.", path.display()));
        }
    };
    let difference = Difference::between(&locked, &new)?;
    let path = panels_path(name);
    let is_written = fs::create_dir_all(path.with_file_name("")).is_ok()
        && draw_panels(&new, &locked).save(&path).is_ok();
    let caption = match is_written {
        true => "New, locked and difference (orange where the new one is brighter):",
        false => "The difference can't be written to",
    };
    Some(format!("{difference}.\n{caption} {}", path.display()))
}

fn decode(png: &[u8]) -> ImageResult<RgbImage> {
    Ok(image::load_from_memory(png)?.to_rgb8())
}

/// Encodes a picture as small as the encoder can, as the book shows this very file.
fn encode_small(picture: &RgbImage) -> Vec<u8> {
    let mut png = vec![];
    let (compression, filter) = (CompressionType::Best, FilterType::Adaptive);
    let encoder = PngEncoder::new_with_quality(&mut png, compression, filter);
    let result = picture.write_with_encoder(encoder);
    result.expect("a picture in memory can be encoded");
    png
}

/// The path of a file of the snapshot `name`.
fn snapshot_path(name: &str, extension: &str) -> PathBuf {
    workspace().join(format!("tests/snapshots/{name}.{extension}"))
}

/// The path of the panels of a picture that differs from its snapshot.
fn panels_path(name: &str) -> PathBuf {
    target_folder().join(format!("differences/{name}.png"))
}

/// A picture that waits for review. insta deletes it before it compares another, even where it
/// may write none: there it is put back in the end.
struct PendingReview<'a> {
    /// The name of the locked picture.
    name: &'a str,
    /// The files to put back.
    files: Vec<(PathBuf, Vec<u8>)>,
}

/// Whether insta is told to `update` snapshots so.
fn insta_updates(update: &str) -> bool {
    let default = if env::var_os("CI").is_some() { "no" } else { "new" };
    env::var("INSTA_UPDATE").unwrap_or(default.to_owned()) == update
}

impl<'a> PendingReview<'a> {
    /// Reads what waits, where insta may not write.
    fn read(name: &'a str) -> Self {
        let paths = ["snap.new", "snap.new.png"].map(|extension| snapshot_path(name, extension));
        let paths = paths.into_iter().filter(|_| insta_updates("no"));
        let files = paths.filter_map(|path| fs::read(&path).ok().map(|bytes| (path, bytes)));
        Self { name, files: files.collect() }
    }
}

impl Drop for PendingReview<'_> {
    fn drop(&mut self) {
        for (path, bytes) in self.files.iter().filter(|(path, _)| !path.exists()) {
            let _ = fs::write(path, bytes);
        }
        if insta_updates("always") {
            // insta leaves half of what waited, and the picture is accepted now.
            let _ = fs::remove_file(snapshot_path(self.name, "snap.new"));
        }
        if thread::panicking() {
            let command = "INSTA_UPDATE=always cargo test --test pictures";
            println!("Is it meant? `{command} {}` accepts it.", self.name);
        }
    }
}
