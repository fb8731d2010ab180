use crate::{Camera, allowed, aspect_ratio::AspectRatio, program::Stop};
use clap::{CommandFactory, FromArgMatches, Parser};
use std::path::PathBuf;

/// Draws the picture of one step of the course and saves it as a PNG file.
#[derive(Parser)]
#[command(version)]
pub(crate) struct Options {
    /// Columns of the picture, hRes: 2 to 16384
    #[arg(long, default_value = "640", value_parser = allowed::width, allow_hyphen_values = true)]
    pub width: u32,
    /// Shape of the picture, W:H, such as 4:3, 16:9, 2.35:1 or 2.59:1
    #[arg(long, default_value = "16:9", allow_hyphen_values = true)]
    pub aspect: AspectRatio,
    /// Horizontal field of view θ in degrees: above 0, below 180
    #[arg(long, default_value = "60", value_parser = allowed::degrees, allow_hyphen_values = true)]
    pub fov: f64,
    /// Side of the grid of rays in each pixel: 1 to 16
    #[arg(long, default_value = "1", value_parser = allowed::samples, allow_hyphen_values = true)]
    pub samples: u32,
    /// PNG file to write
    #[arg(long, required = false, value_parser = allowed::png, allow_hyphen_values = true)]
    pub output: PathBuf,
}

impl Options {
    /// Reads the command line of the program `name`, which saves to name.png unless told otherwise.
    pub fn read(name: &str) -> Result<Self, Stop> {
        let output = format!("{name}.png");
        let command = Self::command().name(name.to_owned());
        let command = command.mut_arg("output", |arg| arg.default_value(output));
        let matches = command.try_get_matches();
        matches.and_then(|matches| Self::from_arg_matches(&matches)).map_err(|error| {
            let text = error.to_string();
            match text.split_once("\n\n") {
                Some((sentence, _)) if error.use_stderr() => Stop::bad_option(sentence),
                _ => Stop { code: 0, text: text.trim_end().to_owned() },
            }
        })
    }

    /// The camera with these columns, this shape and this field of view.
    pub fn camera(&self) -> Result<Camera, Stop> {
        let Self { width: h_res, aspect: AspectRatio { width, height }, fov, .. } = *self;
        let v_res = self.aspect.v_res(h_res).ok_or_else(|| {
            Stop::bad_option(&format!(
                "error: invalid value '{width}:{height}' for '--aspect <ASPECT>': allowed are \
                 shapes that give {h_res} columns 1 to 16384 rows"
            ))
        })?;
        Ok(Camera::new(h_res, v_res, fov.to_radians()))
    }
}
