use crate::{AspectRatio, Camera};
use clap::{CommandFactory, Parser, error::ErrorKind, value_parser};
use image::{ImageError, ImageResult, RgbImage, codecs::png::PngEncoder};
use rayon::ThreadPoolBuilder;
use std::io::{Write, stdout};
use std::path::Path;
use std::{fs, process, time::Instant};

/// The largest number of pixels that a picture may have, whatever its shape.
pub const MAX_PIXELS: u64 = 8192 * 4608;

/// Draws one picture of the course and saves it as a PNG file.
// The text of `--help` is the line above and the comments of the fields. In
// `--width -5`, clap would take the -5 for an unknown option. With
// `allow_hyphen_values`, it is a value, and the error says which range is allowed.
#[derive(Parser)]
struct Options {
    /// Columns of the picture, hRes: 2 to 8192
    #[arg(long, default_value = "640", allow_hyphen_values = true)]
    #[arg(value_parser = value_parser!(u32).range(2..=8192))]
    width: u32,
    /// Shape of the picture, W:H, such as 4:3 or 2.35:1; at most 4 times as high as
    /// wide
    #[arg(long, default_value = "16:9", allow_hyphen_values = true)]
    #[arg(value_parser = aspect_ratio)]
    aspect: AspectRatio,
    /// Horizontal field of view θ in degrees: above 0, below 180
    #[arg(long, default_value = "60", allow_hyphen_values = true)]
    #[arg(value_parser = angle)]
    fov: f64,
    /// Rays through each pixel, N × N, where N is 1 to 16
    #[arg(long, default_value = "1", allow_hyphen_values = true, value_name = "N")]
    #[arg(value_parser = value_parser!(u32).range(1..=16))]
    samples: u32,
    /// PNG file to write, named after the program by default
    #[arg(long, allow_hyphen_values = true, value_parser = png_name)]
    output: Option<String>,
}

fn aspect_ratio(text: &str) -> Result<AspectRatio, &'static str> {
    let allowed = "must be W:H, two numbers above 0, with H at most 4 times W";
    let (w, h) = text.split_once(':').ok_or(allowed)?;
    let width: f64 = w.parse().map_err(|_| allowed)?;
    let height: f64 = h.parse().map_err(|_| allowed)?;
    let is_allowed = width > 0.0 && height > 0.0 && height <= 4.0 * width;
    if is_allowed { Ok(AspectRatio { width, height }) } else { Err(allowed) }
}

fn angle(text: &str) -> Result<f64, &'static str> {
    match text.parse::<f64>() {
        Ok(degrees) if 0.0 < degrees && degrees < 180.0 => Ok(degrees),
        _ => Err("must be a number above 0 and below 180"),
    }
}

fn png_name(text: &str) -> Result<String, &'static str> {
    let is_png = text.to_lowercase().ends_with(".png");
    if is_png { Ok(text.into()) } else { Err("must be a name that ends in .png") }
}

/// What the program of a step or an exercise does: reads the options, draws
/// `picture`, and saves it as `name`.png, or where `--output` says. Any error ends
/// the program.
pub fn draw_and_save(name: &str, picture: fn(&Camera, u32) -> RgbImage) {
    let Options { width, aspect, fov, samples, output } = Options::parse();
    let file = output.unwrap_or_else(|| format!("{name}.png"));
    let height = aspect.v_res(width);
    if u64::from(width) * u64::from(height) > MAX_PIXELS {
        let message = format!(
            "--width {width} with this --aspect makes {width}×{height} pixels, \
             and a picture may have {MAX_PIXELS} in all"
        );
        Options::command().error(ErrorKind::ValueValidation, message).exit();
    }
    let camera = Camera::new(width, height, fov.to_radians());
    // Starts the threads here, so that a failure is an error message. Left to
    // itself, rayon would start them when it needs them, and panic if it can't.
    let thread_pool = match ThreadPoolBuilder::new().build() {
        Ok(thread_pool) => thread_pool,
        Err(error) => exit_with(&format!("can't start threads: {error}")),
    };

    let start = Instant::now();
    // Inside `install`, rayon uses the threads of this pool.
    let image = thread_pool.install(|| picture(&camera, samples));
    let time = start.elapsed();

    if let Err(error) = save(&image, &file) {
        exit_with(&format!("can't write '{file}': {error}"));
    }
    let (w, h) = image.dimensions();
    // `println!` would panic if standard output is closed.
    let _ = writeln!(stdout(), "{file}: {w}×{h} pixels in {time:.1?}");
}

/// Writes the picture to a temporary file and then renames it to `file`, so that an
/// earlier picture survives if the disk is full.
fn save(image: &RgbImage, file: &str) -> ImageResult<()> {
    let mut png = vec![];
    image.write_with_encoder(PngEncoder::new(&mut png))?;
    let temporary = Path::new(file).with_extension("tmp");
    let saved =
        fs::write(&temporary, png).and_then(|()| fs::rename(&temporary, file));
    if saved.is_err() {
        let _ = fs::remove_file(&temporary);
    }
    saved.map_err(ImageError::from)
}

fn exit_with(message: &str) -> ! {
    eprintln!("error: {message}");
    process::exit(1);
}
