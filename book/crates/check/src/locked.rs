use crate::read_png;
use crate::target::Target;
use course::workspace;
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

    /// Pictures in the folder of the course.
    pub fn in_workspace() -> Self {
        Self::new(|name| {
            let path = format!("tests/snapshots/{name}.snap.png");
            let file = fs::read(workspace().join(&path));
            let file = file.map_err(|error| format!("can't read {path}: {error}"))?;
            Ok(read_png(&file).map_err(|what| format!("{path} {what}"))?.rgb)
        })
    }

    /// The picture of this name, with what it is drawn of.
    pub(crate) fn get(&self, name: &str) -> Result<Arc<Target>, String> {
        let kept = || self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(target) = kept().get(name) {
            return Ok(target.clone());
        }
        let target = Arc::new(Target::of_locked(name, (self.read)(name)?));
        Ok(kept().entry(name.to_owned()).or_insert(target).clone())
    }
}
