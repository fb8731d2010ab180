//! Checks the bytes of a PNG file and returns an answer.

use crate::explain::{Explanation, explain};
use crate::png_file::{PngError, read_png};
use crate::reader_picture::ReaderPicture;
use crate::target::{Target, find_name_in_file_name};
use crate::{Answer, ComparedPictures, ReadFileError, Verdict, escape_for_terminal};
use course::names_of_right_pictures;
use image::RgbImage;
use std::error;
use thiserror::Error;

/// Why a file couldn't be compared with a right picture.
#[derive(Debug, Error)]
pub enum CheckError {
    /// The file can't be read.
    #[error(transparent)]
    Read(#[from] ReadFileError),
    /// The file isn't a readable PNG file.
    #[error("{file_name} {error}")]
    Png {
        /// The file name, escaped for a terminal.
        file_name: String,
        /// What is wrong with the file.
        error: PngError,
    },
    /// Neither the file's name nor its pixels say which picture the file should contain.
    #[error(
        "nothing says which picture this should be; put its name into the file name, such as step02_sphere"
    )]
    UnknownName,
    /// The right picture couldn't be loaded.
    #[error(transparent)]
    NoRightPicture(Box<dyn error::Error + Send + Sync>),
}

/// Compares the picture in a PNG file with a locked picture. The name of the locked picture is the
/// first of these that exists:
///
/// 1. `expected_name`
/// 2. a name that occurs in `file_name`
/// 3. the name of the locked picture that equals the picture in the file
/// 4. the name of the locked picture that a listed mistake turns into the picture in the file
///
/// `right_picture` loads the locked picture with a given name. The rest of this function reads no
/// files, no command-line arguments and no clock.
pub fn check_png<E: Into<Box<dyn error::Error + Send + Sync>>>(
    png: &[u8],
    file_name: &str,
    expected_name: Option<&str>,
    right_picture: impl FnOnce(&str) -> Result<RgbImage, E>,
) -> Result<Answer, CheckError> {
    let yours = decode(png, file_name)?;
    let name = expected_name
        .or_else(|| find_name_in_file_name(file_name, names_of_right_pictures().into_iter()))
        .or_else(|| yours.find_equal_locked_picture())
        .or_else(|| yours.find_mistakes().first().map(|(_, name)| *name))
        .ok_or(CheckError::UnknownName)?;
    let ours = right_picture(name).map_err(|error| CheckError::NoRightPicture(error.into()))?;
    Ok(compare(yours, Target::of_locked(name, ours)))
}

/// Compares the picture in a PNG file with the picture of the scene that is generated from a name.
pub fn check_scene_png(png: &[u8], file_name: &str, name: &str) -> Result<Answer, CheckError> {
    Ok(compare(decode(png, file_name)?, Target::of_generated_scene(name)))
}

fn decode(png: &[u8], file_name: &str) -> Result<ReaderPicture, CheckError> {
    let file_name = escape_for_terminal(file_name);
    let decoded = read_png(png).map_err(|error| CheckError::Png { file_name, error })?;
    Ok(ReaderPicture::new(decoded))
}

/// Compares a reader's picture with the target, and explains any difference. A transparent picture
/// isn't right, even if all of its colours are.
fn compare(yours: ReaderPicture, target: Target) -> Answer {
    let Explanation { verdict, headline, details, causes, causes_line, option_doubts } =
        explain(&yours, &target);
    let ours = target.picture;
    let is_compared = verdict == Verdict::NotRight && yours.rgb.dimensions() == ours.dimensions();
    let (verdict, headline, details) = if yours.is_transparent && verdict != Verdict::NotRight {
        let without_alpha = format!("Without alpha, the verdict would be \"{}\".", verdict.label());
        (Verdict::NotRight, without_alpha, [vec![headline], details].concat())
    } else {
        (verdict, headline, details)
    };
    Answer {
        verdict,
        file_notes: yours.file_notes,
        headline,
        details,
        causes,
        compared_pictures: is_compared.then_some(ComparedPictures { yours: yours.rgb, ours }),
        causes_line,
        option_doubts,
    }
}
