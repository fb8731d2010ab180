use crate::{AspectRatio, Camera, allowed, program::End};
use clap::{CommandFactory, FromArgMatches, Parser};
use std::path::PathBuf;

/// Draws the picture of one step of the course and saves it as a PNG file.
#[derive(Parser)]
#[command(version)]
pub(crate) struct Options {
    /// Columns of the picture, hRes: 2 to 16384
    #[arg(long, default_value = "640", value_parser = allowed::width)]
    pub width: u32,
    /// Shape of the picture, W:H, such as 4:3, 16:9, 2.35:1 or 2.59:1
    #[arg(long, default_value = "16:9")]
    pub aspect: AspectRatio,
    /// Horizontal field of view θ in degrees: above 0, below 180
    #[arg(long, default_value = "60", value_parser = allowed::degrees)]
    pub fov: f64,
    /// Side of the grid of rays in each pixel: 1 to 16
    #[arg(long, default_value = "1", value_parser = allowed::samples)]
    pub samples: u32,
    /// PNG file to write
    #[arg(long, required = false, value_parser = allowed::png)]
    pub output: PathBuf,
}

impl Options {
    /// Reads the command line of the program `name`; its output is name.png by default.
    pub fn read(name: &str) -> Result<Self, End> {
        let output = format!("{name}.png");
        let matches = Self::command()
            .name(name.to_owned())
            .mut_arg("output", |arg| arg.default_value(output))
            .mut_args(|arg| arg.allow_hyphen_values(true))
            .try_get_matches();
        let options = matches.and_then(|matches| Self::from_arg_matches(&matches));
        options.map_err(|end| match end.to_string().split_once("\n\n") {
            Some((sentence, _)) if end.use_stderr() => End::bad_option(sentence),
            _ => End { code: 0, text: end.to_string().trim_end().to_owned() },
        })
    }

    /// The camera with these columns, this shape and this field of view.
    pub fn camera(&self) -> Result<Camera, End> {
        let (h_res, AspectRatio { width, height }) = (self.width, self.aspect);
        let v_res = self.aspect.v_res(h_res).ok_or_else(|| {
            End::bad_option(&format!(
                "error: invalid value '{width}:{height}' for '--aspect <ASPECT>': \
                 allowed are shapes that give {h_res} columns 1 to 16384 rows"
            ))
        })?;
        Ok(Camera::new(h_res, v_res, self.fov.to_radians()))
    }
}
