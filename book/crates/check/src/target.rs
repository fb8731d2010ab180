use crate::drawing::Drawing;
use crate::{escape_for_terminal, read_bounded_file, read_png};
use course::{Step, camera, workspace};
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

/// The locked picture of a name, from the folder of the course, or why it can't be read.
pub fn read_locked_picture(name: &str) -> Result<RgbImage, String> {
    let path = format!("tests/snapshots/{name}.snap.png");
    let png = read_bounded_file(&workspace().join(&path))?;
    Ok(read_png(&png).map_err(|what| format!("{path} {what}"))?.rgb)
}
