use crate::{AspectRatio, Camera};
use clap::{Parser, value_parser};
use image::{ImageResult, RgbImage, codecs::png::PngEncoder};
use rayon::ThreadPoolBuilder;
use std::io::{Write, stdout};
use std::path::Path;
use std::{fs, process, time::Instant};

/// Draws one picture of the course and saves it as a PNG file.
#[derive(Parser)]
struct Options {
    /// Columns of the picture, hRes: 2 to 8192
    #[arg(long, default_value = "640", allow_hyphen_values = true)]
    #[arg(value_parser = value_parser!(u32).range(2..=8192))]
    width: u32,
    /// Shape of the picture, W:H, such as 4:3, 16:9 or 2.35:1, down to 1:4
    #[arg(long, default_value = "16:9", allow_hyphen_values = true)]
    #[arg(value_parser = aspect_ratio)]
    aspect: AspectRatio,
    /// Horizontal field of view θ in degrees: above 0, below 180
    #[arg(long, default_value = "60", allow_hyphen_values = true)]
    #[arg(value_parser = angle)]
    fov: f64,
    /// Side of the grid of rays in each pixel: 1 to 16
    #[arg(long, default_value = "1", allow_hyphen_values = true)]
    #[arg(value_parser = value_parser!(u32).range(1..=16))]
    samples: u32,
    /// PNG file to write, named after the program by default
    #[arg(long, allow_hyphen_values = true, value_parser = png_name)]
    output: Option<String>,
}

fn aspect_ratio(text: &str) -> Result<AspectRatio, &'static str> {
    let allowed = "allowed is W:H, two numbers above 0, down to 1:4";
    let (width, height) = text.split_once(':').ok_or(allowed)?;
    let width: f64 = width.parse().or(Err(allowed))?;
    let height: f64 = height.parse().or(Err(allowed))?;
    let is_allowed = height > 0.0 && width / height >= 0.25;
    if is_allowed { Ok(AspectRatio { width, height }) } else { Err(allowed) }
}

fn angle(text: &str) -> Result<f64, &'static str> {
    let angle = text.parse().ok().filter(|angle| 0.0 < *angle && *angle < 180.0);
    angle.ok_or("allowed are numbers above 0 and below 180")
}

fn png_name(text: &str) -> Result<String, &'static str> {
    let is_png = text.to_lowercase().ends_with(".png");
    if is_png { Ok(text.into()) } else { Err("allowed are names that end in .png") }
}

/// The program of a step or an exercise: reads the options, draws `picture`, and saves
/// it as `name`.png, or where `--output` says. An error ends the program.
pub fn draw_and_save(name: &str, picture: fn(&Camera, u32) -> RgbImage) {
    let Options { width, aspect, fov, samples, output } = Options::parse();
    let file = output.unwrap_or_else(|| format!("{name}.png"));
    let camera = Camera::new(width, aspect.v_res(width), fov.to_radians());
    let threads = match ThreadPoolBuilder::new().build() {
        Ok(threads) => threads,
        Err(error) => {
            exit_with(&format!("can't start threads to draw with: {error}"))
        }
    };

    let start = Instant::now();
    let image = threads.install(|| picture(&camera, samples));
    let time = start.elapsed();

    if let Err(error) = save(&image, &file) {
        exit_with(&format!("can't write '{file}': {error}"));
    }
    let (w, h) = image.dimensions();
    // If nobody reads the output, that's no reason to fail.
    let _ = writeln!(stdout(), "{file}: {w}×{h} pixels in {time:.1?}");
}

/// Writes a second file first and then gives it the name, so that an earlier picture
/// is still there if the disk turns out to be full.
fn save(image: &RgbImage, file: &str) -> ImageResult<()> {
    let mut png = vec![];
    image.write_with_encoder(PngEncoder::new(&mut png))?;
    let unfinished = Path::new(file).with_extension("tmp");
    let saved =
        fs::write(&unfinished, png).and_then(|()| fs::rename(&unfinished, file));
    if saved.is_err() {
        let _ = fs::remove_file(&unfinished);
    }
    Ok(saved?)
}

fn exit_with(message: &str) -> ! {
    eprintln!("error: {message}");
    process::exit(1);
}
