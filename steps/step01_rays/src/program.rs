use crate::{Camera, file::save, options::Options};
use image::RgbImage;
use std::{io, io::Write, process::ExitCode, time::Instant};

/// Why a program ends before its picture is saved: the exit code, and what its user is told.
pub(crate) struct Stop {
    pub code: u8,
    pub text: String,
}

impl Stop {
    pub fn bad_option(sentence: &str) -> Self {
        Self { code: 2, text: format!("{sentence}; see --help") }
    }
}

/// The program around a picture: reads its options, draws, saves, and tells what was written.
///
/// The exit code is 0; 1 where the file can't be written; 2 where an option is wrong. One sentence
/// on standard error then names the option, the value and what is allowed.
pub fn run(name: &str, picture: fn(&Camera, u32) -> RgbImage) -> ExitCode {
    let (code, text) = match Options::read(name).and_then(|options| draw(&options, picture)) {
        Ok(text) => (0, text),
        Err(stop) => (stop.code, stop.text),
    };
    // Where nobody listens any more, there is nobody to tell.
    let _ = match code {
        0 => writeln!(io::stdout(), "{text}"),
        _ => writeln!(io::stderr(), "{text}"),
    };
    ExitCode::from(code)
}

fn draw(options: &Options, picture: fn(&Camera, u32) -> RgbImage) -> Result<String, Stop> {
    let camera = options.camera()?;
    let output = options.output.display();
    let start = Instant::now();
    let image = picture(&camera, options.samples);
    let time = start.elapsed();
    save(&image, &options.output).map_err(|error| Stop {
        code: 1,
        text: format!(
            "error: can't write '{output}' for '--output <OUTPUT>': {error}; allowed are files \
             that can be written, in a folder that is there"
        ),
    })?;
    let (width, height) = image.dimensions();
    let rays = u64::from(width) * u64::from(height) * u64::from(options.samples.pow(2));
    Ok(format!("{output}: {width}×{height} pixels, {rays} rays in {time:.1?}"))
}
