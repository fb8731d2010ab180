use crate::{Answer, Locked, png};
use image::RgbImage;
use std::io::{BufRead, Seek};

/// Compares the picture in a PNG file with the locked picture `name`; where that is
/// left out, with the one that the file's own name tells, or else with the nearest.
///
/// It takes nothing but what it is given: no file, no argument, no time.
pub fn check(
    png: impl BufRead + Seek,
    file: &str,
    name: Option<&str>,
    locked: &[Locked],
) -> Answer {
    match png::read(png) {
        Ok((picture, notes)) => {
            let _ = notes;
            look(&picture, name, locked)
        }
        Err(what) => Answer::new(2, format!("error: {file} {what}")),
    }
}

/// Compares a picture with the locked picture `name`, or with the nearest where `name`
/// is left out.
pub fn look(yours: &RgbImage, name: Option<&str>, locked: &[Locked]) -> Answer {
    let mut asked =
        locked.iter().filter(|one| name.is_none_or(|name| name == one.name));
    match asked.find(|one| one.picture == *yours) {
        Some(one) => Answer::new(
            0,
            format!("Right: this is the picture of {}, in every pixel.", one.name),
        ),
        None => Answer::new(1, "Not right yet.".to_owned()),
    }
}
