use crate::drawing::Drawing;
use crate::escape_for_terminal;
use course::{Step, camera};
use image::RgbImage;
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
