//! Draws the mistakes of the list, and writes what `check` and the book know of them:
//! the table of sums and the small pictures.
//!
//! Each is applied to a copy of the course, compiled and drawn as a reader would draw it.
//! Without words, those are drawn whose text, file or right picture has changed; with
//! words, those that have one of them in their title or file. `--again 5` draws five,
//! others each time, and says whether the table has what they give.

mod copy;

use check::{Locked, Mistake, Row, Step, locked_sums, mistakes, rows, sum};
use compare::workspace;
use copy::Copy;
use image::RgbImage;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::imageops::thumbnail;
use std::collections::HashMap;
use std::path::PathBuf;
use std::time::UNIX_EPOCH;
use std::{env, fs, io, process::ExitCode};

fn main() -> ExitCode {
    let words: Vec<_> = env::args().skip(1).collect();
    let done = match &words[..] {
        [option, count] if option == "--again" => again(count),
        words => draw(words),
    };
    match done {
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

/// What stands for a mistake in the table.
fn key(mistake: &Mistake) -> u32 {
    let text = fs::read_to_string(workspace().join(&mistake.file));
    Row::key(mistake, &text.unwrap_or_default())
}

/// All pictures that are right.
fn locked() -> io::Result<Vec<Locked>> {
    let exercises = exercises::PICTURES.iter().map(|(name, _)| *name);
    let names = Step::ALL.map(Step::name).into_iter().chain(exercises);
    names.map(|name| Locked::read(name).map_err(io::Error::other)).collect()
}

/// Draws those that are new or asked for.
fn draw(words: &[String]) -> io::Result<()> {
    let (locked, all) = (locked()?, mistakes());
    let drawn = rows().filter(|row| row.sums.iter().any(Option::is_some));
    let mut known: HashMap<u32, Row> = drawn.map(|row| (row.key, row)).collect();
    // Where what is right is another picture, so is what a mistake makes of it.
    let right: HashMap<_, _> = locked_sums().collect();
    let is_new = |one: &&Locked| right.get(&*one.name) != Some(&sum(&one.picture));
    let new: Vec<_> = locked.iter().filter(is_new).map(|one| &one.name).collect();
    for mistake in &all {
        if mistake.drawn().iter().any(|name| new.contains(&name)) {
            known.remove(&key(mistake));
        }
    }
    let is_asked = |mistake: &&Mistake| match words {
        [] => {
            let is_seen = shown(mistake).all(|(path, _)| path.exists());
            !known.contains_key(&key(mistake)) || !is_seen
        }
        words => words.iter().any(|word| {
            mistake.title.contains(word) || mistake.file.contains(word)
        }),
    };
    let asked: Vec<_> = all.iter().filter(is_asked).collect();
    println!("{} of {} mistakes are drawn", asked.len(), all.len());
    let copy = Copy::new()?;
    for (mistake, k) in asked.iter().zip(1..) {
        let pictures = copy.draw(mistake)?;
        let row = row(mistake, &pictures, &locked);
        if row.sums.iter().all(Option::is_none) {
            println!("shows nowhere: {} ({})", mistake.title, mistake.file);
        }
        known.insert(row.key, row);
        show(mistake, &pictures)?;
        if k % 50 == 0 {
            println!("{k} of {}", asked.len());
            write(&all, &known, &locked)?;
        }
    }
    write(&all, &known, &locked)
}

/// Draws `count` of all, and compares with the table.
fn again(count: &str) -> io::Result<()> {
    let count: usize = count.parse().map_err(io::Error::other)?;
    let locked = locked()?;
    let all: Vec<_> = mistakes().into_iter().zip(rows()).collect();
    let start = UNIX_EPOCH.elapsed().map_err(io::Error::other)?.as_secs() as usize;
    let copy = Copy::new()?;
    for k in 0..count {
        let (mistake, known) = &all[(start + k * 211) % all.len()];
        if row(mistake, &copy.draw(mistake)?, &locked) != *known {
            let what = format!("the table is wrong about {}", mistake.title);
            return Err(io::Error::other(what));
        }
        println!("as in the table: {}", mistake.title);
    }
    Ok(())
}

/// Its small pictures, each with the name of what is drawn.
fn shown(mistake: &Mistake) -> impl Iterator<Item = (PathBuf, &'static str)> {
    let pictures = mistake.shown.iter().flat_map(|shown| &shown.pictures);
    let path = |name: &str| folder().join(format!("pictures/{name}.png"));
    pictures.map(move |(name, step)| (path(name), step.name()))
}

/// Its line of the table, from what was drawn.
fn row(
    mistake: &Mistake,
    pictures: &[(String, RgbImage)],
    locked: &[Locked],
) -> Row {
    let sums = mistake.drawn().into_iter().map(|name| {
        let right = locked.iter().find(|one| one.name == name);
        let (_, picture) = pictures.iter().find(|(its, _)| *its == name)?;
        let is_right = right.is_some_and(|one| one.picture == *picture);
        (!is_right).then(|| sum(picture))
    });
    Row { key: key(mistake), sums: sums.collect() }
}

/// Writes its small pictures.
fn show(mistake: &Mistake, pictures: &[(String, RgbImage)]) -> io::Result<()> {
    for (path, step) in shown(mistake) {
        let drawn = pictures.iter().find(|(name, _)| name == step);
        let Some((_, picture)) = drawn else {
            println!("not drawn: {}", path.display());
            continue;
        };
        let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
        let file = fs::File::create(&path)?;
        let encoder = PngEncoder::new_with_quality(file, best, filter);
        let small = thumbnail(picture, 320, 180);
        small.write_with_encoder(encoder).map_err(io::Error::other)?;
    }
    Ok(())
}

/// Writes the table: the sums of what is right, then a row for each mistake.
fn write(
    all: &[Mistake],
    known: &HashMap<u32, Row>,
    locked: &[Locked],
) -> io::Result<()> {
    let mut text = String::new();
    for Locked { name, picture } in locked {
        text += &format!("= {name} {:016x}\n", sum(picture));
    }
    for mistake in all {
        let key = key(mistake);
        let none = || Row { key, sums: vec![None] };
        text += &known.get(&key).cloned().unwrap_or_else(none).line();
    }
    fs::write(folder().join("table.txt"), text)
}
