//! The table with a hash of each picture that a mistake produces, and the small pictures that the
//! book shows. The small pictures for a step are stacked in one file, in the order of the table,
//! since a change to the scene changes all of them anyway.

use crate::hash::fnv_1a;
use crate::mistake_files::mistake_texts;
use crate::{Mistake, Step, mistakes};
use image::imageops::{crop_imm, thumbnail};
use image::{ImageResult, RgbImage};
use std::fs;
use std::path::{Path, PathBuf};

fn table_lines() -> std::str::Lines<'static> {
    mistake_texts().map(|texts| texts.table).unwrap_or_default().lines()
}

/// Hashes a picture: 64-bit FNV-1a of the number of columns, the number of rows and all bytes.
pub fn hash_picture(picture: &RgbImage) -> u64 {
    let (columns, rows) = picture.dimensions();
    let size = [columns, rows].into_iter().flat_map(u32::to_le_bytes);
    fnv_1a(size.chain(picture.as_raw().iter().copied()))
}

/// A mistake's row in the table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableRow {
    /// A hash of everything that determined the mistake's pictures when they were drawn.
    pub key: u32,
    /// The hashes of the pictures of the mistake's step and of all later steps. A hash is None if
    /// that picture is right in spite of the mistake, or can't be drawn.
    pub hashes: Vec<Option<u64>>,
}

/// Returns the names and hashes of the right pictures.
pub fn locked_hashes() -> impl Iterator<Item = (&'static str, u64)> {
    table_lines().filter_map(|line| {
        let (name, hash) = line.strip_prefix("= ")?.split_once(' ')?;
        Some((name, u64::from_str_radix(hash, 16).ok()?))
    })
}

/// Returns the rows of the checked-in table, one for each mistake in the order of the list. Only
/// this order says which mistake a row belongs to: comparing keys would require the files of the
/// steps. A test in xtask compares them.
pub fn table_rows() -> impl Iterator<Item = TableRow> {
    table_lines().filter_map(|line| {
        let (key, hashes) = line.split_once(' ')?;
        let key = u32::from_str_radix(key, 16).ok()?;
        let hashes = hashes.split(' ').map(|hash| u64::from_str_radix(hash, 16).ok());
        Some(TableRow { key, hashes: hashes.collect() })
    })
}

/// Finds the mistakes that produce the picture with this hash. Each comes with the name of the
/// picture that should have been drawn, and occurs once for each such name. The likeliest come
/// first: those that the book shows, then those that change the least code.
pub fn find_mistakes_with_hash(hash: u64) -> Vec<(&'static Mistake, &'static str)> {
    let all = mistakes().iter().zip(table_rows());
    let mut mistakes_and_names: Vec<_> = all
        .flat_map(|(mistake, row)| {
            let steps = mistake.affected_steps().zip(row.hashes);
            let steps = steps.filter(move |(_, drawn)| *drawn == Some(hash));
            steps.map(move |(step, _)| (mistake, step.name()))
        })
        .collect();
    mistakes_and_names.sort_by_key(|(mistake, _)| {
        let size = mistake.old.len().abs_diff(mistake.new.len());
        (mistake.shown.is_none(), mistake.new.lines().count(), size)
    });
    mistakes_and_names
}

/// Returns the names of all locked pictures: those of the steps, then those of the examples in the
/// order of their steps.
pub fn locked_names() -> Vec<&'static str> {
    locked_hashes().map(|(name, _)| name).collect()
}

/// The columns and rows of a small picture.
pub const SMALL_SIZE: [u32; 2] = [320, 180];

/// Scales a picture down to a small picture.
pub fn make_small_picture(picture: &RgbImage) -> RgbImage {
    let [columns, rows] = SMALL_SIZE;
    thumbnail(picture, columns, rows)
}

/// Returns the path of the file with the small pictures for a step.
pub fn small_pictures_path(workspace: &Path, step: Step) -> PathBuf {
    workspace.join(format!("book/crates/course/mistakes/{}.png", step.name()))
}

/// Reads the checked-in small pictures for a step, each with its name in the table. If the file has
/// fewer pictures than the table has names, the last names are left out.
pub fn read_small_pictures(
    workspace: &Path,
    step: Step,
) -> ImageResult<Vec<(&'static str, RgbImage)>> {
    let right = format!("= {} ", step.name());
    let lines = table_lines().skip_while(|line| !line.starts_with(&right)).skip(1);
    let names = lines.map_while(|line| line.strip_prefix("! "));
    let file = fs::read(small_pictures_path(workspace, step))?;
    let all = image::load_from_memory(&file)?.into_rgb8();
    let [columns, rows] = SMALL_SIZE;
    let tops = (0..all.height()).step_by(rows as usize);
    let pictures = tops.map(|top| crop_imm(&all, 0, top, columns, rows).to_image());
    Ok(names.zip(pictures).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mistakes_are_found_by_their_hashes_and_those_in_the_book_come_first() {
        for (mistake, row) in mistakes().iter().zip(table_rows()) {
            for (step, hash) in mistake.affected_steps().zip(row.hashes) {
                let Some(hash) = hash else { continue };
                let found = find_mistakes_with_hash(hash);
                assert!(found.contains(&(mistake, step.name())), "{}", mistake.title);
                let is_shown = |(mistake, _): &(&Mistake, _)| mistake.shown.is_some();
                assert!(found.is_sorted_by_key(|one| !is_shown(one)), "{}", mistake.title);
            }
        }
    }

    #[test]
    fn hash_depends_on_the_size_and_on_each_byte() {
        let black = hash_picture(&RgbImage::new(2, 3));
        assert_eq!(black, hash_picture(&RgbImage::new(2, 3)));
        assert_ne!(black, hash_picture(&RgbImage::new(3, 2)));
        let mut picture = RgbImage::new(2, 3);
        picture[(1, 2)][2] = 1;
        assert_ne!(black, hash_picture(&picture));
    }

    #[test]
    fn locked_names_begin_with_the_steps() {
        assert_eq!(locked_names()[..Step::NAMES.len()], Step::NAMES);
    }
}
