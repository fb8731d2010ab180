use crate::comparison::{Pixel, scattered_places};
use crate::drawing::Drawing;
use crate::escape_for_terminal;
use course::{Step, camera, camera_with_size};
use image::RgbImage;
use std::sync::{Arc, OnceLock};
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
    pixels: OnceLock<Vec<Pixel>>,
}

impl Target {
    /// The locked picture of a name.
    pub fn of_locked(name: &str, picture: RgbImage) -> Self {
        Self {
            title: format!("the picture of {name}"),
            name: Some(name.to_owned()),
            drawing: Step::from_name(name).map(Drawing::of_step),
            picture: Arc::new(picture),
            pixels: OnceLock::new(),
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
            pixels: OnceLock::new(),
        }
    }

    /// All pixels, scattered over the picture, each with what is seen there; yours are as ours.
    pub fn pixels(&self) -> &[Pixel] {
        self.pixels.get_or_init(|| {
            let (columns, rows) = self.picture.dimensions();
            let camera = camera_with_size(columns, rows);
            let pixel = |place: (u32, u32)| {
                let ours = self.picture.get_pixel(place.0, place.1).0;
                let ray = camera.ray(place.0.into(), place.1.into());
                let hit = self.drawing.as_ref().and_then(|drawing| drawing.visible_hit(&ray));
                Pixel { place, ray, hit, yours: ours, ours }
            };
            scattered_places(columns, rows).map(pixel).collect()
        })
    }
}

/// A title such as `the scene of ada`.
pub(crate) fn scene_title(name: &str) -> String {
    format!("the scene of {}", escape_for_terminal(name))
}
