use crate::hash::fnv_1a;
use crate::{Mistake, mistakes};
use image::RgbImage;

const TABLE: &str = include_str!("../mistakes/table.txt");

/// A number that hardly any two pictures share: FNV-1a, 64 bits of it, of the columns, the
/// rows and all bytes.
pub fn hash_picture(picture: &RgbImage) -> u64 {
    let (columns, rows) = picture.dimensions();
    let size = [columns, rows].into_iter().flat_map(u32::to_le_bytes);
    fnv_1a(size.chain(picture.as_raw().iter().copied()))
}

/// Hashes of the pictures of one mistake: a line of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableRow {
    /// Hash of the mistake and of the code of its file when it was drawn.
    pub key: u32,
    /// The sum of the picture of its step and of each later one, or of its exercise; None
    /// where that is right all the same, or can't be drawn.
    pub hashes: Vec<Option<u64>>,
}

impl TableRow {
    /// The key of a mistake, where `text` is that of its file: comments draw nothing.
    pub fn compute_key(mistake: &Mistake, file_text: &str) -> u32 {
        let lines = file_text.lines().map(str::trim);
        let code = lines.filter(|line| !line.starts_with("//") && !line.is_empty());
        let Mistake { file, old, new, .. } = mistake;
        let all = [&file[..], old, new].into_iter().chain(code).flat_map(str::bytes);
        (fnv_1a(all) >> 32) as u32
    }

    /// Formats the line of the table.
    pub fn to_line(&self) -> String {
        let sum = |sum: &Option<u64>| match sum {
            Some(sum) => format!(" {sum:016x}"),
            None => " -".to_owned(),
        };
        let hashes: String = self.hashes.iter().map(sum).collect();
        format!("{:08x}{hashes}\n", self.key)
    }
}

/// The sums of all pictures that are right, by their names.
pub fn locked_hashes() -> impl Iterator<Item = (&'static str, u64)> {
    TABLE.lines().filter_map(|line| {
        let (name, sum) = line.strip_prefix("= ")?.split_once(' ')?;
        Some((name, u64::from_str_radix(sum, 16).ok()?))
    })
}

/// The rows of the table that is checked in, a mistake each, in the order of the list.
pub fn table_rows() -> impl Iterator<Item = TableRow> {
    TABLE.lines().filter_map(|line| {
        let (key, hashes) = line.split_once(' ')?;
        let key = u32::from_str_radix(key, 16).ok()?;
        let hashes = hashes.split(' ').map(|sum| u64::from_str_radix(sum, 16).ok());
        Some(TableRow { key, hashes: hashes.collect() })
    })
}

/// The mistakes that give a picture, to the last pixel, each with the name of what was
/// drawn; the likeliest first, which are those that the book shows and small ones.
pub fn find_mistakes_with_hash(hash: u64) -> Vec<(Mistake, String)> {
    let all = mistakes().into_iter().zip(table_rows());
    let mut mistakes_and_names: Vec<_> = all
        .filter_map(|(mistake, row)| {
            let index = row.hashes.iter().position(|one| *one == Some(hash))?;
            let name = mistake.affected_picture_names().into_iter().nth(index)?;
            Some((mistake, name))
        })
        .collect();
    mistakes_and_names.sort_by_key(|(mistake, _)| {
        let size = mistake.old.len().abs_diff(mistake.new.len());
        (mistake.book_entry.is_none(), mistake.new.lines().count(), size)
    });
    mistakes_and_names
}

/// The names of all pictures that there are to compare with: those of the steps, and
/// those of the examples, in the steps' order.
pub fn locked_names() -> Vec<&'static str> {
    locked_hashes().map(|(name, _)| name).collect()
}
