use compare::{Difference, panels, workspace};
use image::{ImageFormat, RgbImage};
use insta::internals::SnapshotContents;
use insta::{Comparator, Settings, assert_binary_snapshot};
use std::panic::{catch_unwind, set_hook, take_hook};
use std::path::PathBuf;
use std::{env, fs, io::Cursor};

/// The folder of the locked pictures.
const SNAPSHOTS: &str = "tests/snapshots";

/// The locked picture `name`, from its snapshot.
pub fn locked(name: &str) -> RgbImage {
    let path = workspace().join(format!("{SNAPSHOTS}/{name}.snap.png"));
    let picture = image::open(&path);
    picture.unwrap_or_else(|error| panic!("{}: {error}", path.display())).to_rgb8()
}

/// Pictures that are compared with their snapshots, one after the other; those that
/// differ are told together.
#[derive(Default)]
pub struct Locking {
    changed: Vec<String>,
    count: usize,
}

impl Locking {
    /// Compares every pixel of `picture` with the locked picture `name`.
    ///
    /// Where they differ, it says how, in one sentence, and writes a picture of the
    /// difference to the target folder.
    pub fn assert(&mut self, name: &str, picture: &RgbImage) {
        let mut png = Cursor::new(Vec::new());
        picture
            .write_to(&mut png, ImageFormat::Png)
            .expect("a picture in memory can be encoded");
        let mut settings = Settings::clone_current();
        settings.set_snapshot_path(workspace().join(SNAPSHOTS));
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.set_comparator(Box::new(Pixels { name: name.to_owned() }));
        let assert =
            || assert_binary_snapshot!(&format!("{name}.png"), png.into_inner());
        // insta panics; its sentence would hide ours.
        let hook = take_hook();
        set_hook(Box::new(|_| {}));
        let asserted = settings.bind(|| catch_unwind(assert));
        set_hook(hook);
        self.count += 1;
        // What an earlier run left to be reviewed is accepted with the picture.
        if env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
            for end in ["snap.new", "snap.new.png"] {
                let _ = fs::remove_file(
                    workspace().join(format!("{SNAPSHOTS}/{name}.{end}")),
                );
            }
        }
        if asserted.is_err() {
            self.changed.push(name.to_owned());
        }
    }

    /// Fails if there is a picture that differs.
    pub fn finish(self) {
        let Self { changed, count } = self;
        assert!(
            changed.is_empty(),
            "{} of {count} pictures changed: {}.\nIn {} are, from left to right, the new \
             one, the locked one and the difference: orange where the new one is \
             brighter, else blue. Look at them. Are they meant to change? Then \
             `INSTA_UPDATE=always cargo test` locks them anew.",
            changed.len(),
            changed.join(", "),
            differences().display()
        );
    }
}

/// Compares decoded pixels, so that the same picture from another PNG encoder is
/// the same.
#[derive(Clone)]
struct Pixels {
    name: String,
}

impl Comparator for Pixels {
    fn matches(&self, locked: &insta::Snapshot, new: &insta::Snapshot) -> bool {
        let (Some(locked), Some(new)) = (decoded(locked), decoded(new)) else {
            return false;
        };
        let Some(difference) = Difference::between(&locked, &new) else {
            return true;
        };
        println!("{}: {difference}.", self.name);
        let path = differences().join(format!("{}.png", self.name));
        let panels = panels(&new, &locked);
        if let Err(error) = panels.save(&path) {
            println!("{}: {error}", path.display());
        }
        false
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

fn decoded(snapshot: &insta::Snapshot) -> Option<RgbImage> {
    let SnapshotContents::Binary(Some(png)) = snapshot.contents() else {
        return None;
    };
    Some(image::load_from_memory(png).ok()?.to_rgb8())
}

/// The folder of the pictures of differences.
fn differences() -> PathBuf {
    let folder = target().join("differences");
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}

/// The target folder, marked by Cargo, in which this test program lies.
pub fn target() -> PathBuf {
    let program = env::current_exe().expect("a running program has a path");
    let mut around = program.ancestors();
    let target = around.find(|folder| folder.join("CACHEDIR.TAG").is_file());
    target.expect("a target folder").to_owned()
}
