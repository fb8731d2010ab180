use crate::{hash_picture, locked_hashes, read_png};
use compare::workspace;
use image::RgbImage;
use std::fs;

/// A picture to compare with.
#[derive(Clone, Debug, PartialEq)]
pub struct Locked {
    /// Name of a step or of an example of a step.
    pub name: String,
    /// Pixels that the picture has to have.
    pub picture: RgbImage,
}

impl Locked {
    /// All that there are in the folder of the course, or a sentence about why one of
    /// them can't be had.
    pub fn read_all() -> Result<Vec<Self>, String> {
        locked_names().into_iter().map(Self::read).collect()
    }

    /// The one of this name.
    pub fn read(name: &str) -> Result<Self, String> {
        let path = format!("tests/snapshots/{name}.snap.png");
        let file = fs::read(workspace().join(&path));
        let file = file.map_err(|error| format!("can't read {path}: {error}"))?;
        let picture = read_png(&file).map_err(|what| format!("{path} {what}"))?;
        Ok(Self { name: name.to_owned(), picture: picture.pixels })
    }

    /// Whether it is the picture with which this program was compiled.
    pub(crate) fn has_compiled_hash(&self) -> bool {
        let hash = hash_picture(&self.picture);
        locked_hashes().any(|(name, right)| name == self.name && right == hash)
    }
}

/// The names of all pictures that there are to compare with: those of the steps, and
/// those of the exercises, which are examples of a step, in the steps' order.
pub fn locked_names() -> Vec<&'static str> {
    locked_hashes().map(|(name, _)| name).collect()
}
