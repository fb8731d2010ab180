use crate::{Mistake, Step, mistakes};
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

/// A number of 32 bits that stands for a text.
fn key(text: &str) -> u32 {
    (fnv(text.bytes()) >> 32) as u32
}

/// What stands for the code of a file: its comments draw nothing.
pub fn code_key(text: &str) -> u32 {
    let lines = text.lines().map(str::trim);
    let code = lines.filter(|line| !line.starts_with("//") && !line.is_empty());
    key(&code.collect::<Vec<_>>().join("\n"))
}

impl Mistake {
    /// What stands for it in the table.
    pub fn key(&self) -> u32 {
        key(&[&self.file, &self.old, &self.new].map(|part| &part[..]).join("\n"))
    }
}

/// What was drawn of one mistake: a line of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The mistake's.
    pub mistake: u32,
    /// That of the code of its file when it was drawn.
    pub file: u32,
    /// The sum of the picture of its step and of each later one, or of its exercise; None
    /// where that is right all the same, or can't be drawn.
    pub sums: Vec<Option<u64>>,
}

/// The sums of all pictures that are right, by their names.
pub fn locked_sums() -> impl Iterator<Item = (&'static str, u64)> {
    TABLE.lines().filter_map(|line| {
        let (name, sum) = line.strip_prefix("= ")?.split_once(' ')?;
        Some((name, u64::from_str_radix(sum, 16).ok()?))
    })
}

/// The table as it is checked in.
pub fn rows() -> impl Iterator<Item = Row> {
    read(TABLE)
}

/// A table, from its text.
pub fn read(text: &str) -> impl Iterator<Item = Row> {
    text.lines().filter_map(|line| {
        let mut parts = line.split(' ');
        let mut key = || u32::from_str_radix(parts.next()?, 16).ok();
        let (mistake, file) = (key()?, key()?);
        let sums = parts.map(|sum| u64::from_str_radix(sum, 16).ok());
        Some(Row { mistake, file, sums: sums.collect() })
    })
}

impl Row {
    /// Its line.
    pub fn line(&self) -> String {
        let sum = |sum: &Option<u64>| match sum {
            Some(sum) => format!(" {sum:016x}"),
            None => " -".to_owned(),
        };
        let sums: String = self.sums.iter().map(sum).collect();
        format!("{:08x} {:08x}{sums}", self.mistake, self.file)
    }
}

/// The mistakes that give a picture, to the last pixel, each with the name of what was
/// drawn; the likeliest first, which are those that the book shows and small ones.
pub fn known(sum: u64) -> Vec<(Mistake, String)> {
    let mistakes = mistakes();
    let mut known: Vec<_> = rows()
        .filter_map(|row| {
            let at = row.sums.iter().position(|one| *one == Some(sum))?;
            let mistake = mistakes.iter().find(|one| one.key() == row.mistake)?;
            Some((mistake.clone(), mistake.drawn().nth(at)?))
        })
        .collect();
    known.sort_by_key(|(mistake, _)| {
        let size = mistake.old.len().abs_diff(mistake.new.len());
        (mistake.shown.is_none(), mistake.new.lines().count(), size)
    });
    known
}

impl Mistake {
    /// The names of the pictures that it may spoil, in their order.
    pub fn drawn(&self) -> impl Iterator<Item = String> {
        let exercise = self.file.split("/examples/").nth(1);
        let exercise = exercise.map(|file| file.trim_end_matches(".rs").to_owned());
        let steps = self.step().filter(|_| exercise.is_none()).into_iter();
        let steps = steps.flat_map(|first| {
            Step::ALL.into_iter().filter(move |step| first <= *step)
        });
        exercise.into_iter().chain(steps.map(|step| step.name().to_owned()))
    }
}
