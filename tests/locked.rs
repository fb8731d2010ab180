use crate::Difference;
use crate::panels::panels;
use image::{ImageFormat, RgbImage};
use insta::internals::SnapshotContents;
use insta::{Comparator, Settings, assert_binary_snapshot};
use std::path::PathBuf;
use std::{env, fs, io::Cursor};

/// The locked picture `name`, from its snapshot.
pub fn locked(name: &str) -> RgbImage {
    let path = here().join(format!("snapshots/{name}.snap.png"));
    let picture = image::open(&path);
    picture.unwrap_or_else(|error| panic!("{}: {error}", path.display())).to_rgb8()
}

/// Fails unless every pixel of `picture` is that of the locked picture `name`.
///
/// Then it says how they differ, and writes a picture of the difference to the
/// target folder.
pub fn assert_locked(name: &'static str, picture: &RgbImage) {
    let mut png = Cursor::new(Vec::new());
    picture
        .write_to(&mut png, ImageFormat::Png)
        .expect("a picture in memory can be encoded");
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(here().join("snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(Pixels { name }));
    settings
        .bind(|| assert_binary_snapshot!(&format!("{name}.png"), png.into_inner()));
}

/// Compares decoded pixels, so that the same picture from another PNG encoder is
/// the same.
#[derive(Clone)]
struct Pixels {
    name: &'static str,
}

impl Comparator for Pixels {
    fn matches(&self, locked: &insta::Snapshot, new: &insta::Snapshot) -> bool {
        let (Some(locked), Some(new)) = (decoded(locked), decoded(new)) else {
            return false;
        };
        let Some(difference) = Difference::between(&locked, &new) else {
            return true;
        };
        let path = target().join("differences").join(format!("{}.png", self.name));
        let saved = fs::create_dir_all(path.with_file_name(""))
            .map_err(Into::into)
            .and_then(|()| {
                panels([("new", &new), ("locked", &locked)]).save(&path)
            });
        eprintln!("{}: {difference}.", self.name);
        match saved {
            Ok(()) => eprintln!(
                "New, locked and difference side by side: {}",
                path.display()
            ),
            Err(error) => {
                eprintln!("No difference picture at {}: {error}", path.display())
            }
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

/// The folder of these tests, which may have moved since they were compiled.
pub fn here() -> PathBuf {
    let package = env::var("CARGO_MANIFEST_DIR").map_or("..".into(), PathBuf::from);
    package.join("../tests")
}

/// The target folder, marked by Cargo, in which this test program lies.
pub fn target() -> PathBuf {
    let program = env::current_exe().expect("a running program has a path");
    let mut around = program.ancestors();
    let target = around.find(|folder| folder.join("CACHEDIR.TAG").is_file());
    target.expect("a target folder").to_owned()
}
