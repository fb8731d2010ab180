use crate::{Mistake, mistakes};
use image::RgbImage;

const TABLE: &str = include_str!("../mistakes/table.txt");

/// A number that hardly any two pictures share: FNV-1a, 64 bits of it, of the columns, the
/// rows and all bytes.
pub fn sum(picture: &RgbImage) -> u64 {
    let (columns, rows) = picture.dimensions();
    let size = [columns, rows].into_iter().flat_map(u32::to_le_bytes);
    fnv(size.chain(picture.as_raw().iter().copied()))
}

fn fnv(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xCBF2_9CE4_8422_2325, |sum, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3)
    })
}

/// What was drawn of one mistake: a line of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What stands for the mistake and for the code of its file when it was drawn.
    pub key: u32,
    /// The sum of the picture of its step and of each later one, or of its exercise; None
    /// where that is right all the same, or can't be drawn.
    pub sums: Vec<Option<u64>>,
}

impl Row {
    /// The key of a mistake, where `text` is that of its file: comments draw nothing.
    pub fn key(mistake: &Mistake, text: &str) -> u32 {
        let lines = text.lines().map(str::trim);
        let code = lines.filter(|line| !line.starts_with("//") && !line.is_empty());
        let Mistake { file, old, new, .. } = mistake;
        let all =
            [&file[..], old, new].into_iter().chain(code).flat_map(str::bytes);
        (fnv(all) >> 32) as u32
    }

    /// Its line.
    pub fn line(&self) -> String {
        let sum = |sum: &Option<u64>| match sum {
            Some(sum) => format!(" {sum:016x}"),
            None => " -".to_owned(),
        };
        let sums: String = self.sums.iter().map(sum).collect();
        format!("{:08x}{sums}\n", self.key)
    }
}

/// The sums of all pictures that are right, by their names.
pub fn locked_sums() -> impl Iterator<Item = (&'static str, u64)> {
    TABLE.lines().filter_map(|line| {
        let (name, sum) = line.strip_prefix("= ")?.split_once(' ')?;
        Some((name, u64::from_str_radix(sum, 16).ok()?))
    })
}

/// The rows of the table that is checked in, a mistake each, in the order of the list.
pub fn rows() -> impl Iterator<Item = Row> {
    TABLE.lines().filter_map(|line| {
        let (key, sums) = line.split_once(' ')?;
        let key = u32::from_str_radix(key, 16).ok()?;
        let sums = sums.split(' ').map(|sum| u64::from_str_radix(sum, 16).ok());
        Some(Row { key, sums: sums.collect() })
    })
}

/// The mistakes that give a picture, to the last pixel, each with the name of what was
/// drawn; the likeliest first, which are those that the book shows and small ones.
pub fn known(sum: u64) -> Vec<(Mistake, String)> {
    let all = mistakes().into_iter().zip(rows());
    let mut known: Vec<_> = all
        .filter_map(|(mistake, row)| {
            let at = row.sums.iter().position(|one| *one == Some(sum))?;
            let name = mistake.drawn().into_iter().nth(at)?;
            Some((mistake, name))
        })
        .collect();
    known.sort_by_key(|(mistake, _)| {
        let size = mistake.old.len().abs_diff(mistake.new.len());
        (mistake.shown.is_none(), mistake.new.lines().count(), size)
    });
    known
}
