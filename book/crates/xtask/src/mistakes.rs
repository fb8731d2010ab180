use crate::batch::{self, Pictures, title_and_file};
use check::Locked;
use course::workspace;
use course::{Mistake, TableRow, hash_picture, locked_hashes, mistakes, table_rows};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::imageops::thumbnail;
use std::collections::HashMap;
use std::error::Error;
use std::path::PathBuf;
use std::{fs, io};

/// Draws the mistakes about which the table is old, and those that `is_chosen` selects;
/// writes the table and the small pictures.
pub fn draw_outdated_and_chosen(
    is_chosen: impl Fn(&Mistake) -> bool,
) -> Result<(), Box<dyn Error>> {
    let (locked, all) = (read_all_locked()?, mistakes());
    let rows_with_hash = table_rows().filter(|row| row.hashes.iter().any(Option::is_some));
    let mut table: HashMap<u32, TableRow> = rows_with_hash.map(|row| (row.key, row)).collect();
    // Where a locked picture has changed, its mistakes are drawn anew.
    let right: HashMap<_, _> = locked_hashes().collect();
    let is_new = |one: &&Locked| right.get(&*one.name) != Some(&hash_picture(&one.picture));
    let new: Vec<_> = locked.iter().filter(is_new).map(|one| &one.name).collect();
    let is_current = |mistake: &Mistake| {
        table.contains_key(&compute_table_key(mistake))
            && !mistake.affected_picture_names().iter().any(|name| new.contains(&name))
            && small_picture_paths(mistake).all(|(path, _)| path.exists())
    };
    let selected = all.iter().filter(|one| is_chosen(one) || !is_current(one));
    batch::draw_mistakes(selected.collect(), |mistake, pictures| {
        let row = table_row(mistake, &pictures, &locked);
        if row.hashes.iter().all(Option::is_none) {
            println!("shows nowhere: {}", title_and_file(mistake));
        }
        table.insert(row.key, row);
        write_small_pictures(mistake, &pictures)
    })?;
    write_picture_hashes(&all, &table, &locked)?;
    Ok(())
}

fn mistakes_folder() -> PathBuf {
    workspace().join("book/crates/course/mistakes")
}

/// The key of a mistake in the table, with its file as it is now.
fn compute_table_key(mistake: &Mistake) -> u32 {
    let text = fs::read_to_string(workspace().join(&mistake.file));
    TableRow::compute_key(mistake, &text.unwrap_or_default())
}

/// All locked pictures that somebody may draw.
fn read_all_locked() -> Result<Vec<Locked>, String> {
    course::PICTURES.iter().map(|(name, _)| Locked::read(name)).collect()
}

/// The paths of a mistake's small pictures, each with the name of what is drawn.
fn small_picture_paths(mistake: &Mistake) -> impl Iterator<Item = (PathBuf, &'static str)> {
    let pictures = mistake.book_entry.iter().flat_map(|shown| &shown.pictures);
    let path = |name: &str| mistakes_folder().join(format!("pictures/{name}.png"));
    pictures.map(move |(name, step)| (path(name), step.name()))
}

/// A mistake's row of the table.
fn table_row(mistake: &Mistake, pictures: &Pictures, locked: &[Locked]) -> TableRow {
    let sums = mistake.affected_picture_names().into_iter().zip(0..).map(|(name, k)| {
        let picture = pictures.get(k)?.as_ref()?;
        let is_right = |one: &Locked| one.name == name && one.picture == *picture;
        (!locked.iter().any(is_right)).then(|| hash_picture(picture))
    });
    TableRow { key: compute_table_key(mistake), hashes: sums.collect() }
}

fn write_small_pictures(mistake: &Mistake, pictures: &Pictures) -> io::Result<()> {
    for (path, step) in small_picture_paths(mistake) {
        let names = mistake.affected_picture_names().into_iter();
        let mut pictures_of_step = names.zip(pictures).filter(|(name, _)| *name == step);
        let Some((_, Some(picture))) = pictures_of_step.next() else {
            println!("not drawn: {}", path.display());
            continue;
        };
        let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
        let mut file = vec![];
        let encoder = PngEncoder::new_with_quality(&mut file, best, filter);
        let small = thumbnail(picture, 320, 180);
        small.write_with_encoder(encoder).map_err(io::Error::other)?;
        fs::write(path, file)?;
    }
    Ok(())
}

/// Writes the table: the hashes of what is right, then a row for each mistake.
fn write_picture_hashes(
    all: &[Mistake],
    table: &HashMap<u32, TableRow>,
    locked: &[Locked],
) -> io::Result<()> {
    let mut text = String::new();
    for Locked { name, picture } in locked {
        text += &format!("= {name} {:016x}\n", hash_picture(picture));
    }
    for mistake in all {
        let key = compute_table_key(mistake);
        let unknown = || TableRow { key, hashes: vec![None] };
        text += &table.get(&key).cloned().unwrap_or_else(unknown).to_line();
    }
    fs::write(mistakes_folder().join("table.txt"), text)
}
