use crate::{AspectRatio, Camera};
use clap::{Parser, value_parser};
use image::{RgbImage, codecs::png::PngEncoder};
use std::io::{Write, stdout};
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
    aspect: AspectRatio,
    /// Horizontal field of view θ in degrees: above 0, below 180
    #[arg(long, default_value = "60", allow_hyphen_values = true)]
    #[arg(value_parser = angle)]
    fov: f64,
    /// Side of the grid of rays in each pixel: 1 to 16
    #[arg(long, default_value = "1", allow_hyphen_values = true)]
    #[arg(value_parser = value_parser!(u32).range(1..=16))]
    samples: u32,
    /// PNG file to write; it has the name of the program by default
    #[arg(long, allow_hyphen_values = true, value_parser = png)]
    output: Option<String>,
}

fn angle(text: &str) -> Result<f64, &'static str> {
    let angle = text.parse().ok().filter(|angle| 0.0 < *angle && *angle < 180.0);
    angle.ok_or("allowed are numbers above 0 and below 180")
}

fn png(name: &str) -> Result<String, &'static str> {
    let is_png = name.to_lowercase().ends_with(".png");
    if is_png { Ok(name.into()) } else { Err("allowed are names that end in .png") }
}

/// The program around a picture: draws it as its options say, and saves `name`.png or
/// what `--output` says; it exits with 1 where the file can't be written.
pub fn run(name: &str, picture: fn(&Camera, u32) -> RgbImage) {
    let Options { width, aspect, fov, samples, output } = Options::parse();
    let file = output.unwrap_or_else(|| format!("{name}.png"));
    let camera = Camera::new(width, aspect.v_res(width), fov.to_radians());
    let (start, image) = (Instant::now(), picture(&camera, samples));
    let (time, (w, h)) = (start.elapsed(), image.dimensions());
    let mut png = vec![];
    let encoded = image.write_with_encoder(PngEncoder::new(&mut png));
    if let Err(error) = encoded.and_then(|()| Ok(fs::write(&file, png)?)) {
        eprintln!("error: can't write '{file}': {error}");
        process::exit(1);
    }
    let _ = writeln!(stdout(), "{file}: {w}×{h} pixels in {time:.1?}");
}
