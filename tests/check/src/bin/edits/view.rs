use super::edit::Edit;
use gallery::Step;
use image::RgbImage;
use step01_rays::{AspectRatio, Camera};

/// What the options of a program say.
pub struct View {
    /// The right camera.
    pub camera: Camera,
    /// Rays a pixel, squared.
    pub samples: u32,
}

impl View {
    /// What the options of an edit say, and the defaults.
    pub fn of(edit: &Edit) -> Result<Self, String> {
        let (mut width, mut fov, mut samples) = (640, 60.0_f64, 1);
        let mut aspect = AspectRatio { width: 16.0, height: 9.0 };
        for pair in edit.options.chunks(2) {
            let [option, value] = pair else { return Err(format!("{pair:?}")) };
            let number =
                |text: &str| text.parse::<f64>().map_err(|_| text.to_owned());
            match (option.as_str(), value.split_once(':')) {
                ("--width", _) => width = number(value)? as u32,
                ("--fov", _) => fov = number(value)?,
                ("--samples", _) => samples = number(value)? as u32,
                ("--aspect", Some((w, h))) => {
                    aspect = AspectRatio { width: number(w)?, height: number(h)? }
                }
                _ => return Err(format!("{pair:?}")),
            }
        }
        let camera = Camera::new(width, aspect.v_res(width), fov.to_radians());
        Ok(Self { camera, samples })
    }

    /// The right picture.
    pub fn picture(&self, step: Step) -> RgbImage {
        step.picture(&self.camera, self.samples)
    }
}
