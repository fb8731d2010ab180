//! The small pictures of the mistakes that the book shows: those of a step are one file, below
//! each other in the order of the table, as a change of a scene changes them all.

use crate::Step;
use crate::mistake_table::small_picture_names;
use image::imageops::crop_imm;
use image::{ImageResult, RgbImage};
use std::path::{Path, PathBuf};

/// The columns and rows of a small picture.
pub const SMALL_SIZE: [u32; 2] = [320, 180];

/// The file with the small pictures of a step.
pub fn small_pictures_path(workspace: &Path, step: Step) -> PathBuf {
    workspace.join(format!("book/crates/course/mistakes/{}.png", step.name()))
}

/// The small pictures of a step that are checked in, each with its name; fewer where the file
/// is not the one of the table.
pub fn read_small_pictures(
    workspace: &Path,
    step: Step,
) -> ImageResult<Vec<(&'static str, RgbImage)>> {
    let all = image::open(small_pictures_path(workspace, step))?.into_rgb8();
    let [columns, rows] = SMALL_SIZE;
    let tops = (0..all.height()).step_by(rows as usize);
    let pictures = tops.map(|top| crop_imm(&all, 0, top, columns, rows).to_image());
    Ok(small_picture_names(step).zip(pictures).collect())
}
