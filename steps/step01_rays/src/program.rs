use crate::{AspectRatio, Camera, render::ROWS};
use clap::{Parser, error::ErrorKind, value_parser};
use image::{ImageFormat, RgbImage};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{Cursor, Write, stdout};
use std::path::{Path, PathBuf};
use std::{error::Error, fs, iter, process, sync::atomic::Ordering, thread, time};

/// Draws one picture of the course and saves it as a PNG file.
#[derive(Parser)]
struct Options {
    /// Columns of the picture, hRes: 2 to 16384
    #[arg(long, default_value = "640", allow_hyphen_values = true)]
    #[arg(value_parser = value_parser!(u32).range(2..=16384))]
    width: u32,
    /// Shape of the picture, W:H, such as 4:3, 16:9, 2.35:1 or 2.59:1
    #[arg(long, default_value = "16:9", allow_hyphen_values = true)]
    #[arg(value_parser = shape)]
    aspect: AspectRatio,
    /// Horizontal field of view θ in degrees: above 0, below 180
    #[arg(long, default_value = "60", allow_hyphen_values = true)]
    #[arg(value_parser = |text: &str| number(text, 180.0))]
    fov: f64,
    /// Side of the grid of rays in each pixel: 1 to 16
    #[arg(long, default_value = "1", allow_hyphen_values = true)]
    #[arg(value_parser = value_parser!(u32).range(1..=16))]
    samples: u32,
    /// PNG file to write; it has the name of the program by default
    #[arg(long, allow_hyphen_values = true, value_parser = png)]
    output: Option<PathBuf>,
}

fn shape(text: &str) -> Result<AspectRatio, String> {
    let (w, h) = text.split_once(':').ok_or("allowed is W:H, such as 16:9")?;
    Ok(AspectRatio { width: number(w, 1e9)?, height: number(h, 1e9)? })
}

fn number(text: &str, end: f64) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&number| 0.0 < number && number < end);
    number.ok_or(format!("allowed are numbers above 0 and below {end}"))
}

fn png(text: &str) -> Result<PathBuf, &'static str> {
    let is_png = text.to_lowercase().ends_with(".png");
    is_png.then(|| text.into()).ok_or("allowed are files whose name ends in .png")
}

/// The program around a picture: reads its options, draws, saves, tells what it wrote.
/// It ends with 1 where the file can't be written, and with 2 where an option is wrong.
pub fn run(name: &str, picture: fn(&Camera, u32) -> RgbImage) {
    let Options { width, aspect, fov, samples, output } = Options::parse();
    let rows = aspect.v_res(width).unwrap_or_else(|what| {
        let what = format!("invalid value for '--aspect <ASPECT>': {what}\n");
        clap::Error::raw(ErrorKind::ValueValidation, what).exit()
    });
    let bar = progress(rows);
    let image = picture(&Camera::new(width, rows, fov.to_radians()), samples);
    let time = bar.elapsed();
    bar.finish_and_clear();
    let path = output.unwrap_or_else(|| format!("{name}.png").into());
    let file = path.display();
    if let Err(error) = save(&image, &path) {
        eprintln!("error: '--output' takes a file to write, not '{file}': {error}");
        process::exit(1);
    }
    let _ = writeln!(stdout(), "{file}: {width}×{rows} pixels in {time:.1?}");
}

/// Tells on a terminal, second by second, how far the picture is.
fn progress(rows: u32) -> ProgressBar {
    let bar = ProgressBar::new(rows.into());
    let style = ProgressStyle::with_template("{percent} % drawn, {eta} to go");
    style.into_iter().for_each(|style| bar.set_style(style));
    let seconds = iter::repeat(time::Duration::from_secs(1)).map(thread::sleep);
    let drawn = seconds.map(|()| ROWS.load(Ordering::Relaxed)).filter(|n| 0 < *n);
    let told = bar.clone();
    thread::spawn(move || drawn.for_each(|rows| told.set_position(rows.into())));
    bar
}

/// Writes the whole file beside `path`, which may be a link, and then renames it.
fn save(picture: &RgbImage, path: &Path) -> Result<(), Box<dyn Error>> {
    let mut png = Cursor::new(vec![]);
    picture.write_to(&mut png, ImageFormat::Png)?;
    let path = fs::canonicalize(path).unwrap_or(path.into());
    let old = fs::symlink_metadata(&path);
    if old.is_ok_and(|old| old.is_symlink() || old.permissions().readonly()) {
        return Err("it is read-only, or a link to nowhere".into());
    }
    let part = path.with_file_name(format!("{}.part", process::id()));
    let _ = fs::copy(&path, &part); // an old file keeps its permissions
    let saved = fs::write(&part, png.into_inner());
    let saved = saved.and_then(|()| fs::rename(&part, path));
    Ok(saved.inspect_err(|_| drop(fs::remove_file(&part)))?)
}
