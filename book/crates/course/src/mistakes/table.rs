//! The table of mistakes, and the small pictures with which the book shows mistakes. The table has
//! a hash of each wrong picture that a mistake produces. All small pictures for a step are stacked
//! in one file, in the order of the table. A file for each picture would have no advantage, since a
//! change to the scene changes all small pictures anyway.
//!
//! The table is `table.txt`, which `cargo xtask` writes. All its hashes are hexadecimal.
//!
//! - `= NAME HASH` is the name of a right picture, and the picture's hash.
//! - `! NAME` is the name of a small picture. The small picture shows what a wrong program draws.
//!   The nearest line with `=` above names the picture that the program should have drawn.
//! - `KEY HASH HASH …` is the row of a mistake. The key is a hash of everything that the mistake's
//!   pictures depend on. After the key, there is a hash for the mistake's step and for each later
//!   step: the hash of the picture that the step draws with the mistake. If that picture is right
//!   in spite of the mistake, or can't be drawn, `-` takes the place of the hash.

use crate::{Mistake, Step, mistake_files, mistakes};
use image::imageops::{crop_imm, thumbnail};
use image::{ImageResult, RgbImage};
use std::fmt::{self, Display, Formatter};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use thiserror::Error;

/// The table of mistakes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MistakeTable<'a> {
    /// The right pictures: those of the steps, then those of the examples.
    pub right_pictures: Vec<RightPicture<'a>>,
    /// A row for each mistake, in the order of the list of mistakes.
    pub rows: Vec<TableRow>,
}

/// A right picture in the table.
#[derive(Clone, Debug, PartialEq)]
pub struct RightPicture<'a> {
    /// The name of the picture's snapshot.
    pub name: &'a str,
    /// The picture's hash.
    pub hash: u64,
    /// The names of the small pictures that show what wrong programs draw instead of this picture.
    pub small_pictures: Vec<&'a str>,
}

/// A mistake's row in the table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableRow {
    /// A hash of everything that the mistake's pictures depended on when the pictures were drawn.
    pub key: u32,
    /// An entry for the mistake's step and for each later step: the hash of the picture that the
    /// step draws with the mistake. The entry is None if the picture is right in spite of the
    /// mistake, or can't be drawn.
    pub hashes: Vec<Option<u64>>,
}

/// The error if a line of the table can't be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "line {line} is not `= NAME HASH`, `! NAME` below a line with `=`, or `KEY HASH …`: {text}"
)]
pub struct TableError {
    line: usize,
    text: String,
}

impl<'a> MistakeTable<'a> {
    /// Parses a table in the format that [`Display`] writes.
    pub fn parse(text: &'a str) -> Result<Self, TableError> {
        let mut table = Self::default();
        for (index, line) in text.lines().enumerate() {
            let error = || TableError { line: index + 1, text: line.to_owned() };
            table.add_line(line).ok_or_else(error)?;
        }
        Ok(table)
    }

    /// Adds the contents of a line to the table. Returns None if the line can't be read.
    fn add_line(&mut self, line: &'a str) -> Option<()> {
        if let Some(words) = line.strip_prefix("= ") {
            let (name, hash) = words.split_once(' ')?;
            let hash = parse_hash(hash)?;
            self.right_pictures.push(RightPicture { name, hash, small_pictures: vec![] });
        } else if let Some(name) = line.strip_prefix("! ") {
            self.right_pictures.last_mut()?.small_pictures.push(name);
        } else {
            let (key, hashes) = line.split_once(' ')?;
            let parse_or_dash =
                |hash| if hash == "-" { Some(None) } else { parse_hash(hash).map(Some) };
            let hashes = hashes.split(' ').map(parse_or_dash).collect::<Option<_>>()?;
            let key = u32::from_str_radix(key, 16).ok().filter(|_| key.len() == 8)?;
            self.rows.push(TableRow { key, hashes });
        }
        Some(())
    }
}

/// Parses a hash of 16 hexadecimal digits. Returns None for any other number of digits, since that
/// means that the file is damaged.
fn parse_hash(digits: &str) -> Option<u64> {
    u64::from_str_radix(digits, 16).ok().filter(|_| digits.len() == 16)
}

/// Writes the table in the format of table.txt.
impl Display for MistakeTable<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        for RightPicture { name, hash, small_pictures } in &self.right_pictures {
            writeln!(f, "= {name} {hash:016x}")?;
            small_pictures.iter().try_for_each(|name| writeln!(f, "! {name}"))?;
        }
        for TableRow { key, hashes } in &self.rows {
            write!(f, "{key:08x}")?;
            for hash in hashes {
                match hash {
                    Some(hash) => write!(f, " {hash:016x}")?,
                    None => write!(f, " -")?,
                }
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

/// Returns the checked-in table, which is parsed only once. In WebAssembly, the table is empty
/// until `provide_mistake_files` has been called.
///
/// # Panics
///
/// Panics if a line can't be read. Only a bug in the project can cause this, because the table is
/// part of the project.
pub fn mistake_table() -> &'static MistakeTable<'static> {
    static EMPTY: MistakeTable = MistakeTable { right_pictures: vec![], rows: vec![] };
    static TABLE: OnceLock<MistakeTable> = OnceLock::new();
    let Some(texts) = mistake_files() else { return &EMPTY };
    TABLE.get_or_init(|| match MistakeTable::parse(texts.table) {
        Ok(table) => table,
        Err(error) => panic!("table.txt, {error}"),
    })
}

/// Pairs each mistake with its row in the checked-in table. Mistakes and rows are matched by order
/// alone, because computing a mistake's key requires the steps' source files. A test in xtask
/// compares the keys.
///
/// # Panics
///
/// Panics if the number of mistakes differs from the number of rows.
pub fn mistakes_and_their_rows() -> impl Iterator<Item = (&'static Mistake, &'static TableRow)> {
    let (mistakes, rows) = (mistakes(), &mistake_table().rows);
    assert_eq!(
        mistakes.len(),
        rows.len(),
        "each mistake needs a row in the table: run `cargo xtask`"
    );
    mistakes.iter().zip(rows)
}

/// Returns the names and hashes of the right pictures.
pub fn hashes_of_right_pictures() -> impl Iterator<Item = (&'static str, u64)> {
    mistake_table().right_pictures.iter().map(|picture| (picture.name, picture.hash))
}

/// Finds the mistakes that produce the picture with this hash. Each mistake comes with the name of
/// the picture that should have been drawn. A mistake that produces the same picture in several
/// steps is returned once for each of these steps.
///
/// The likeliest mistakes come first. Mistakes that the book shows come before mistakes that the
/// book doesn't show. Within each group, mistakes with fewer lines of wrong code come first. Of two
/// mistakes with equally many lines, the one that changes the code's length less comes first.
pub fn find_mistakes_with_hash(hash: u64) -> Vec<(&'static Mistake, &'static str)> {
    let mut mistakes_and_names: Vec<_> = mistakes_and_their_rows()
        .flat_map(|(mistake, row)| {
            let steps_and_hashes = mistake.affected_steps().zip(&row.hashes);
            let matching =
                steps_and_hashes.filter(move |(_, drawn_hash)| **drawn_hash == Some(hash));
            matching.map(move |(step, _)| (mistake, step.name()))
        })
        .collect();
    mistakes_and_names.sort_by_cached_key(|(mistake, _)| {
        let size = mistake.old.len().abs_diff(mistake.new.len());
        (mistake.presentation.is_none(), mistake.new.lines().count(), size)
    });
    mistakes_and_names
}

/// Returns the names of all right pictures. The five steps' pictures come first. The examples'
/// pictures follow, in the order of the steps.
pub fn names_of_right_pictures() -> Vec<&'static str> {
    hashes_of_right_pictures().map(|(name, _)| name).collect()
}

/// The numbers of columns and rows of a small picture.
pub const SMALL_SIZE: [u32; 2] = [320, 180];

/// Scales a picture down to a small picture.
pub fn make_small_picture(picture: &RgbImage) -> RgbImage {
    let [columns, rows] = SMALL_SIZE;
    thumbnail(picture, columns, rows)
}

/// Returns the path of the file with the small pictures for a step.
pub fn small_pictures_file_path(workspace: &Path, step: Step) -> PathBuf {
    workspace.join(format!("book/crates/course/mistakes/{}.png", step.name()))
}

/// Reads the checked-in small pictures for a step, each with its name in the table. If the file has
/// fewer pictures than the table has names, the last names are left out.
pub fn read_small_mistake_pictures(
    workspace: &Path,
    step: Step,
) -> ImageResult<Vec<(&'static str, RgbImage)>> {
    let right_picture =
        mistake_table().right_pictures.iter().find(|picture| picture.name == step.name());
    let names =
        right_picture.into_iter().flat_map(|picture| picture.small_pictures.iter().copied());
    let file = fs::read(small_pictures_file_path(workspace, step))?;
    let stacked_pictures = image::load_from_memory(&file)?.into_rgb8();
    let [columns, rows] = SMALL_SIZE;
    let tops = (0..stacked_pictures.height()).step_by(rows as usize);
    let pictures = tops.map(|top| crop_imm(&stacked_pictures, 0, top, columns, rows).to_image());
    Ok(names.zip(pictures).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
= step01_rays 00000000000000ff
! degrees
! no-tangent
= plane 0123456789abcdef
0000000a 0000000000000001 -
000000ff -
";

    #[test]
    fn table_is_parsed_and_written_again() {
        let table = MistakeTable::parse(TEXT).expect("the table is well-formed");
        let [rays, plane] = &table.right_pictures[..] else { panic!("{table:?}") };
        assert_eq!((rays.name, rays.hash), ("step01_rays", 255));
        assert_eq!(
            (&rays.small_pictures[..], plane.name),
            (&["degrees", "no-tangent"][..], "plane")
        );
        let rows = [(10, vec![Some(1), None]), (255, vec![None])];
        assert_eq!(table.rows, rows.map(|(key, hashes)| TableRow { key, hashes }));
        assert_eq!(table.to_string(), TEXT);
        let checked_in = mistake_files().expect("a native program includes the texts").table;
        assert!(
            mistake_table().to_string() == checked_in,
            "`cargo xtask` would write the lines of table.txt in a different order"
        );
    }

    #[test]
    fn error_names_the_line_that_cannot_be_read() {
        for line in [
            "",
            "= step01_rays",
            "= step01_rays ff",
            "= step01_rays 00000000000000fg",
            "0000000a",
            "0000000a 1",
            "0000000a - ",
            "a 0000000000000001",
            "<<<<<<< HEAD",
        ] {
            let text = format!("{TEXT}{line}\n{TEXT}");
            let error = MistakeTable::parse(&text).expect_err(line).to_string();
            assert!(error.starts_with("line 7 is not "), "{error}");
        }
        assert!(MistakeTable::parse("! degrees").is_err());
    }

    #[test]
    fn row_has_a_hash_for_each_step_that_its_mistake_affects() {
        for (mistake, row) in mistakes_and_their_rows() {
            assert_eq!(row.hashes.len(), mistake.affected_steps().count(), "{}", mistake.title);
        }
    }

    #[test]
    fn mistakes_are_found_by_their_hashes_and_those_in_the_book_come_first() {
        for (mistake, row) in mistakes_and_their_rows() {
            for (step, hash) in mistake.affected_steps().zip(&row.hashes) {
                let Some(hash) = hash else { continue };
                let entries = find_mistakes_with_hash(*hash);
                assert!(entries.contains(&(mistake, step.name())), "{}", mistake.title);
                let is_shown = |(mistake, _): &(&Mistake, _)| mistake.presentation.is_some();
                assert!(entries.is_sorted_by_key(|entry| !is_shown(entry)), "{}", mistake.title);
            }
        }
    }

    #[test]
    fn names_of_right_pictures_begin_with_those_of_the_steps() {
        assert_eq!(names_of_right_pictures()[..Step::NAMES.len()], Step::NAMES);
    }
}
