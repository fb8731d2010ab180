use std::{ops::RangeInclusive, path::PathBuf};

pub(crate) fn width(text: &str) -> Result<u32, String> {
    whole(text, 2..=16384)
}

pub(crate) fn samples(text: &str) -> Result<u32, String> {
    whole(text, 1..=16)
}

fn whole(text: &str, all: RangeInclusive<u32>) -> Result<u32, String> {
    let number = text.parse().ok().filter(|number| all.contains(number));
    number.ok_or(format!(
        "allowed are whole numbers from {} to {}",
        all.start(),
        all.end()
    ))
}

pub(crate) fn degrees(text: &str) -> Result<f64, &'static str> {
    let angle = text.parse().ok().filter(|&angle| 0.0 < angle && angle < 180.0);
    angle.ok_or("allowed are angles in degrees, above 0 and below 180")
}

pub(crate) fn png(text: &str) -> Result<PathBuf, &'static str> {
    let path = PathBuf::from(text);
    let is_png =
        path.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"));
    is_png.then_some(path).ok_or("allowed are files whose name ends in .png")
}
