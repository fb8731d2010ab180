use crate::drawing::Drawing;
use crate::{escape_for_terminal, read_png};
use course::{Step, camera, workspace};
use image::RgbImage;
use std::collections::HashMap;
use std::fs;
use std::sync::{Arc, Mutex, PoisonError};
use step01_rays::render;

/// A picture to compare with: a locked one, or the scene of a name.
pub(crate) struct Target {
    /// Such as `the picture of glass`.
    pub title: String,
    /// The name of a locked picture; None of the scene of a name.
    pub name: Option<String>,
    /// None of an exercise.
    pub drawing: Option<Drawing>,
    pub picture: RgbImage,
}

impl Target {
    /// The locked picture of a name.
    pub fn of_locked(name: &str, picture: RgbImage) -> Self {
        let drawing = Step::from_name(name).map(Drawing::of_step);
        let title = format!("the picture of {name}");
        Self { title, name: Some(name.to_owned()), drawing, picture }
    }

    /// The scene that belongs to a name.
    pub fn of_scene(name: &str) -> Self {
        let drawing = Drawing::of_name(name);
        let picture = render(&camera(), 1, |ray| drawing.colour(ray));
        Self { title: scene_title(name), name: None, drawing: Some(drawing), picture }
    }
}

/// A title such as `the scene of ada`.
pub(crate) fn scene_title(name: &str) -> String {
    format!("the scene of {}", escape_for_terminal(name))
}

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
