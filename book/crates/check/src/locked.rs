use crate::read_png;
use crate::target::Target;
use course::{hash_picture, locked_hashes, workspace};
use image::RgbImage;
use std::cell::RefCell;
use std::collections::HashMap;
use std::fs;
use std::rc::Rc;

/// A picture to compare with.
#[derive(Clone, Debug, PartialEq)]
pub struct Locked {
    /// Name of a step or of an example of a step.
    pub name: String,
    /// Pixels that the picture has to have.
    pub picture: RgbImage,
}

impl Locked {
    /// The one of this name in the folder of the course, or a sentence about why it can't be
    /// read.
    pub fn read(name: &str) -> Result<Self, String> {
        let path = format!("tests/snapshots/{name}.snap.png");
        let file = fs::read(workspace().join(&path));
        let file = file.map_err(|error| format!("can't read {path}: {error}"))?;
        let picture = read_png(&file).map_err(|what| format!("{path} {what}"))?;
        Ok(Self { name: name.to_owned(), picture: picture.rows })
    }

    /// The pixels, if they are those with which this program was compiled; else a sentence.
    fn verify(self) -> Result<RgbImage, String> {
        let hash = hash_picture(&self.picture);
        match locked_hashes().any(|(name, right)| name == self.name && right == hash) {
            true => Ok(self.picture),
            false => Err(format!(
                "the picture of {} in this folder of the course is of another version than \
                 this program; after a change of the course, `cargo xtask` brings them together",
                self.name
            )),
        }
    }
}

/// The locked pictures, each read or drawn when it is first asked for.
pub struct LockedPictures {
    read: fn(&str) -> Result<RgbImage, String>,
    kept: RefCell<HashMap<String, Rc<Target>>>,
}

impl LockedPictures {
    /// Those that a function gives by their names, or says why it can't.
    pub fn new(read: fn(&str) -> Result<RgbImage, String>) -> Self {
        Self { read, kept: RefCell::default() }
    }

    /// Those in the folder of the course.
    pub fn in_workspace() -> Self {
        Self::new(|name| Locked::read(name)?.verify())
    }

    /// The picture of this name.
    pub fn get(&self, name: &str) -> Result<Rc<RgbImage>, String> {
        Ok(self.target(name)?.picture.clone())
    }

    /// The picture of this name, with what it is drawn of.
    pub(crate) fn target(&self, name: &str) -> Result<Rc<Target>, String> {
        if let Some(target) = self.kept.borrow().get(name) {
            return Ok(target.clone());
        }
        let target = Rc::new(Target::of_locked(name, (self.read)(name)?));
        self.kept.borrow_mut().insert(name.to_owned(), target.clone());
        Ok(target)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Rgb;

    #[test]
    fn changed_picture_is_of_another_version() {
        let mut locked = Locked::read("step01_rays").expect("a locked picture");
        assert!(locked.clone().verify().is_ok());
        locked.picture.put_pixel(9, 9, Rgb([0; 3]));
        assert!(locked.verify().is_err_and(|text| text.contains("another version")));
    }
}
