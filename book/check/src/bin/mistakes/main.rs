//! Draws the mistakes of the list, and writes what `check` and the book know of them:
//! the table of sums and the small pictures.
//!
//! Each is applied to a copy of the course, compiled and drawn as a reader would draw it.
//! Without words, those are drawn whose text, or whose file's text, has changed; with
//! words, those that have one of them in their title or file. `--again 5` draws five,
//! others after each commit, and says whether the table has what they give.

mod batch;
mod source;

use batch::Batch;
use check::{Locked, Mistake, Row, code_key, mistakes, read_table, sum};
use compare::workspace;
use image::RgbImage;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::imageops::thumbnail;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::{env, fs, io, process::ExitCode};

/// So many are compiled at once.
const AT_ONCE: usize = 40;

fn main() -> ExitCode {
    match run(&env::args().skip(1).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(what) => {
            eprintln!("error: {what}");
            ExitCode::FAILURE
        }
    }
}

fn folder() -> PathBuf {
    workspace().join("book/check/mistakes")
}

fn run(words: &[String]) -> Result<(), String> {
    let table = folder().join("table.txt");
    let text = fs::read_to_string(&table).unwrap_or_default();
    let mut rows: HashMap<u32, Row> =
        read_table(&text).map(|row| (row.mistake, row)).collect();
    let locked = Locked::all()?;
    let all = mistakes();
    if let [option, count] = words
        && option == "--again"
    {
        return again(&all, &rows, &locked, count.parse().unwrap_or(5));
    }
    let mut asked = vec![];
    for mistake in &all {
        let row = rows.get(&mistake.key());
        let is_new = row.is_none_or(|row| row.file != file_key(mistake));
        let is_named = words.iter().any(|word| {
            mistake.title.contains(word) || mistake.file.contains(word)
        });
        if if words.is_empty() { is_new || is_unseen(mistake) } else { is_named } {
            asked.push(mistake);
        }
    }
    // What the book shows comes first, then what is sooner compiled.
    asked.sort_by_key(|mistake| (mistake.shown.is_none(), mistake.drawn().count()));
    println!("{} of {} mistakes are drawn", asked.len(), all.len());
    let mut batch = Batch::new().map_err(|error| error.to_string())?;
    for (k, some) in asked.chunks(AT_ONCE).enumerate() {
        for (mistake, pictures) in batch.draw(some).map_err(|e| e.to_string())? {
            let row = row(mistake, &pictures, &locked);
            if row.sums.iter().all(Option::is_none) {
                println!("shows nowhere: {} ({})", mistake.title, mistake.file);
            }
            rows.insert(row.mistake, row);
            show(mistake, &pictures).map_err(|error| error.to_string())?;
        }
        write(&table, &all, &rows, &locked)?;
        println!("{} of {}", (AT_ONCE * (k + 1)).min(asked.len()), asked.len());
    }
    write(&table, &all, &rows, &locked)
}

/// Draws `count` of all, and compares with the table.
fn again(
    all: &[Mistake],
    rows: &HashMap<u32, Row>,
    locked: &[Locked],
    count: usize,
) -> Result<(), String> {
    let head = fs::read_to_string(workspace().join(".git/logs/HEAD"));
    let start = code_key(&head.unwrap_or_default()) as usize;
    let some = (0..count).map(|k| &all[(start + k * 211) % all.len()]);
    let some: Vec<_> = some.collect();
    let mut batch = Batch::new().map_err(|error| error.to_string())?;
    for (mistake, pictures) in batch.draw(&some).map_err(|e| e.to_string())? {
        if rows.get(&mistake.key()) != Some(&row(mistake, &pictures, locked)) {
            return Err(format!("the table is wrong about {}", mistake.title));
        }
        println!("as in the table: {}", mistake.title);
    }
    Ok(())
}

/// What stands for the text of its file.
fn file_key(mistake: &Mistake) -> u32 {
    let text = fs::read_to_string(workspace().join(&mistake.file));
    code_key(&text.unwrap_or_default())
}

/// The names of its small pictures, each with the step that is drawn.
fn shown(mistake: &Mistake) -> impl Iterator<Item = (PathBuf, String)> {
    let pictures = mistake.shown.iter().flat_map(|shown| &shown.pictures);
    let path = |name: &str| folder().join(format!("pictures/{name}.png"));
    pictures.map(move |(name, step)| (path(name), step.name().to_owned()))
}

/// Whether the book shows it, and its picture is not there.
fn is_unseen(mistake: &Mistake) -> bool {
    shown(mistake).any(|(path, _)| !path.exists())
}

/// Its line of the table, from what was drawn.
fn row(
    mistake: &Mistake,
    pictures: &[(String, RgbImage)],
    locked: &[Locked],
) -> Row {
    let right = |name: &str| locked.iter().find(|one| one.name == name);
    let sums = mistake.drawn().map(|name| {
        let (_, picture) = pictures.iter().find(|(its, _)| *its == name)?;
        let is_right = right(&name).is_some_and(|one| one.picture == *picture);
        (!is_right).then(|| sum(picture))
    });
    let sums = sums.collect();
    Row { mistake: mistake.key(), file: file_key(mistake), sums }
}

/// Writes its small pictures.
fn show(mistake: &Mistake, pictures: &[(String, RgbImage)]) -> io::Result<()> {
    for (path, step) in shown(mistake) {
        let Some((_, picture)) = pictures.iter().find(|(name, _)| *name == step)
        else {
            println!("not drawn: {}", path.display());
            continue;
        };
        fs::create_dir_all(folder().join("pictures"))?;
        let small = thumbnail(picture, 320, 180);
        let file = fs::File::create(&path)?;
        let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
        let encoder = PngEncoder::new_with_quality(file, best, filter);
        small.write_with_encoder(encoder).map_err(io::Error::other)?;
    }
    Ok(())
}

/// Writes the table: the sums of what is right, then a row for each mistake.
fn write(
    table: &Path,
    all: &[Mistake],
    rows: &HashMap<u32, Row>,
    locked: &[Locked],
) -> Result<(), String> {
    let mut text = String::new();
    for Locked { name, picture } in locked {
        text += &format!("= {name} {:016x}\n", sum(picture));
    }
    let known = all.iter().filter_map(|mistake| rows.get(&mistake.key()));
    known.for_each(|row| text += &(row.line() + "\n"));
    let saved = fs::write(table, text);
    saved.map_err(|error| format!("can't write {}: {error}", table.display()))
}
