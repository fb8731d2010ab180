use crate::read_png;
use crate::target::Target;
use course::{hash_picture, locked_hashes, workspace};
use image::RgbImage;
use std::collections::HashMap;
use std::fs;
use std::sync::{Arc, Mutex, PoisonError};

/// The locked pictures, each read or drawn when it is first asked for.
pub struct LockedPictures {
    read: fn(&str) -> Result<RgbImage, String>,
    kept: Mutex<HashMap<String, Arc<Target>>>,
}

impl LockedPictures {
    /// Pictures that a function gives by their names, or says why it can't.
    pub fn new(read: fn(&str) -> Result<RgbImage, String>) -> Self {
        Self { read, kept: Mutex::default() }
    }

    /// Pictures in the folder of the course, as far as they are the ones with which this program
    /// was compiled.
    pub fn in_workspace() -> Self {
        Self::new(|name| verify(name, read(name)?))
    }

    /// The picture of this name.
    pub fn get(&self, name: &str) -> Result<Arc<RgbImage>, String> {
        Ok(self.target(name)?.picture.clone())
    }

    /// The picture of this name, with what it is drawn of.
    pub(crate) fn target(&self, name: &str) -> Result<Arc<Target>, String> {
        let kept = || self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(target) = kept().get(name) {
            return Ok(target.clone());
        }
        let target = Arc::new(Target::of_locked(name, (self.read)(name)?));
        Ok(kept().entry(name.to_owned()).or_insert(target).clone())
    }
}

/// Reads the locked picture of a name in the folder of the course.
fn read(name: &str) -> Result<RgbImage, String> {
    let path = format!("tests/snapshots/{name}.snap.png");
    let file = fs::read(workspace().join(&path));
    let file = file.map_err(|error| format!("can't read {path}: {error}"))?;
    Ok(read_png(&file).map_err(|what| format!("{path} {what}"))?.rgb)
}

/// The picture, if it is the one with which this program was compiled; else a sentence.
fn verify(name: &str, picture: RgbImage) -> Result<RgbImage, String> {
    let named_hash = (name, hash_picture(&picture));
    if locked_hashes().any(|one| one == named_hash) {
        return Ok(picture);
    }
    Err(format!(
        "the picture of {name} in this folder of the course is of another version than this \
         program; after a change of the course, `cargo xtask` brings them together"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changed_picture_is_of_another_version() {
        let mut picture = read("step01_rays").expect("a locked picture");
        assert!(verify("step01_rays", picture.clone()).is_ok());
        picture[(9, 9)] = image::Rgb([0; 3]);
        assert!(verify("step01_rays", picture).is_err());
    }
}
