use crate::read_png;
use course::workspace;
use course::{hash_picture, locked_hashes, locked_names};
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
    /// them can't be read.
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

    /// All that there are in the folder of the course, if they are those with which this
    /// program was compiled; else a sentence.
    pub fn read_verified() -> Result<Vec<Self>, String> {
        let locked = Self::read_all()?;
        match locked.iter().find(|one| !one.has_compiled_hash()) {
            None => Ok(locked),
            Some(other) => Err(format!(
                "the picture of {} in this folder of the course is of another version than \
                 this program; after a change of the course, `cargo xtask` brings \
                 them together",
                other.name
            )),
        }
    }

    /// Whether it is the picture with which this program was compiled.
    pub fn has_compiled_hash(&self) -> bool {
        let hash = hash_picture(&self.picture);
        locked_hashes().any(|(name, right)| name == self.name && right == hash)
    }
}
