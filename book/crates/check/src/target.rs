use crate::drawing::Drawing;
use crate::escape_for_terminal;
use course::{Step, camera};
use image::RgbImage;
use std::sync::Arc;
use step01_rays::render;

/// A picture to compare with: a locked one, or the scene of a name.
pub(crate) struct Target {
    /// Such as `the picture of glass`.
    pub title: String,
    /// The name of a locked picture; None of the scene of a name.
    pub name: Option<String>,
    /// None of an exercise.
    pub drawing: Option<Drawing>,
    pub picture: Arc<RgbImage>,
}

impl Target {
    /// The locked picture of a name.
    pub fn of_locked(name: &str, picture: RgbImage) -> Self {
        Self {
            title: format!("the picture of {name}"),
            name: Some(name.to_owned()),
            drawing: Step::from_name(name).map(Drawing::of_step),
            picture: Arc::new(picture),
        }
    }

    /// The scene that belongs to a name.
    pub fn of_scene(name: &str) -> Self {
        let drawing = Drawing::of_name(name);
        Self {
            title: scene_title(name),
            name: None,
            picture: Arc::new(render(&camera(), 1, |ray| drawing.colour(ray))),
            drawing: Some(drawing),
        }
    }
}

/// A title such as `the scene of ada`.
pub(crate) fn scene_title(name: &str) -> String {
    format!("the scene of {}", escape_for_terminal(name))
}
