use crate::{Camera, file::save, options::Options};
use image::RgbImage;
use std::{io, io::Write, process::ExitCode, time::Instant};

/// A picture as a function of the camera, and of the samples along a pixel's side.
pub type Picture = fn(&Camera, u32) -> RgbImage;

/// How a program ends: its exit code, and what it tells its user.
pub(crate) struct End {
    pub code: u8,
    pub text: String,
}

impl End {
    pub fn bad_option(sentence: &str) -> Self {
        Self { code: 2, text: format!("{sentence}; see --help") }
    }
}

/// The program around a picture: reads its options, draws, saves, tells what it wrote.
///
/// The exit code is 0; 1 where the file can't be written; 2 where an option is wrong.
/// A sentence on standard error then names the option, the value and what is allowed.
pub fn run(name: &str, picture: Picture) -> ExitCode {
    let drawn = Options::read(name).and_then(|options| draw(&options, picture));
    let End { code, text } = drawn.unwrap_or_else(|end| end);
    // Where nobody listens any more, there is nobody to tell.
    let _ = match code {
        0 => writeln!(io::stdout(), "{text}"),
        _ => writeln!(io::stderr(), "{text}"),
    };
    ExitCode::from(code)
}

fn draw(options: &Options, picture: Picture) -> Result<End, End> {
    let camera = options.camera()?;
    let output = options.output.display();
    let start = Instant::now();
    let image = picture(&camera, options.samples);
    let time = start.elapsed();
    save(&image, &options.output).map_err(|error| End {
        code: 1,
        text: format!(
            "error: can't write '{output}' for '--output <OUTPUT>': {error}; allowed are \
             files that can be written, in a folder that is there"
        ),
    })?;
    let (columns, rows) = image.dimensions();
    let rays =
        u64::from(columns) * u64::from(rows) * u64::from(options.samples.pow(2));
    let text =
        format!("{output}: {columns}×{rows} pixels, {rays} rays in {time:.1?}");
    Ok(End { code: 0, text })
}
