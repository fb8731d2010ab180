//! Keeps the table and the small pictures of the mistakes up to date. A mistake is wrong code that
//! readers may write in a step. To *draw* a mistake is to draw the picture of each step that this
//! wrong code affects.

use crate::error::{XtaskError, XtaskResult};
use crate::mistakes_program::{self, DrawnPictures, title_and_file, unindented_text_with_mistake};
use crate::source_hash::{hash_texts, trimmed_code_lines};
use course::{
    Mistake, MistakePicture, MistakeTable, PICTURES, RightPicture, SMALL_SIZE, Step, TableRow,
    encode_png, hash_picture, make_small_picture, mistake_table, parse_mistake_lists,
    read_locked_picture, read_small_mistake_pictures, small_pictures_file_path, workspace,
};
use image::RgbImage;
use image::imageops::replace;
use std::collections::HashMap;
use std::fs;

/// The maximum number of mistakes in one program. With more, the compiler would need too much
/// memory. The results are written after each program, so that an interruption loses only the
/// results of one program.
const BATCH_SIZE: usize = 60;

/// All mistakes, and what is known about their pictures.
pub struct DrawnMistakes {
    /// The name and the hash of each right picture, that is, each picture without mistakes.
    right_pictures: Vec<(&'static str, u64)>,
    /// All mistakes, each with the result of [`redraw_key`].
    keys_and_mistakes: Vec<(u32, &'static Mistake)>,
    /// The rows of the table, keyed by the result of [`redraw_key`].
    rows: HashMap<u32, Vec<Option<u64>>>,
    /// The small pictures, keyed by name.
    small_pictures: HashMap<&'static str, RgbImage>,
}

/// Draws each mistake that lacks its row in the table or one of its small pictures. Then writes the
/// table and the small pictures.
pub fn draw_new_mistakes() -> XtaskResult<()> {
    let mut drawn_mistakes = DrawnMistakes::read()?;
    let new_mistakes: Vec<_> = drawn_mistakes.mistakes_to_draw().copied().collect();
    println!("Mistakes to draw: {}", new_mistakes.len());
    for batch in new_mistakes.chunks(BATCH_SIZE) {
        let mistakes: Vec<_> = batch.iter().map(|(_, mistake)| *mistake).collect();
        for ((key, mistake), pictures) in
            batch.iter().zip(mistakes_program::draw_mistakes(&mistakes)?)
        {
            drawn_mistakes.record(*key, mistake, &pictures);
        }
        drawn_mistakes.write()?;
        println!("{} drawn", batch.len());
    }
    drawn_mistakes.write()
}

/// Hashes everything that determines a mistake's pictures:
/// - the code of the mistake's file, with the mistake applied;
/// - the right pictures of the steps that the mistake affects, drawn without the mistake;
/// - the names and steps of the pictures in the book that show the mistake.
///
/// If the hash changes, the mistake has to be drawn again.
pub fn redraw_key(mistake: &Mistake, right_pictures: &[(&str, u64)]) -> XtaskResult<u32> {
    let steps: Vec<_> = mistake.affected_steps().map(Step::name).collect();
    let affected_pictures = right_pictures.iter().filter(|(name, _)| steps.contains(name));
    let right_hashes = affected_pictures.map(|(_, hash)| hash.to_string());
    let pictures = mistake.pictures().iter();
    let shown_names = pictures.map(|picture| format!("{} {}", picture.name, picture.step.name()));
    let code = trimmed_code_lines(&unindented_text_with_mistake(mistake)?);
    Ok(hash_texts(right_hashes.chain(shown_names).chain([code])) as u32)
}

impl DrawnMistakes {
    /// Reads the list of mistakes, the right pictures, and the checked-in table and small pictures.
    pub fn read() -> XtaskResult<Self> {
        let (mut right_pictures, mut keys_and_mistakes) = (vec![], vec![]);
        for (name, _) in PICTURES {
            right_pictures.push((*name, hash_picture(&read_locked_picture(name)?)));
        }
        for mistake in parse_mistake_lists()? {
            keys_and_mistakes.push((redraw_key(mistake, &right_pictures)?, mistake));
        }
        let drawn_rows =
            mistake_table().rows.iter().filter(|row| row.hashes.iter().any(Option::is_some));
        let rows = drawn_rows.map(|row| (row.key, row.hashes.clone())).collect();
        let pictures = Step::ALL.map(|step| read_small_mistake_pictures(&workspace(), step));
        let small_pictures = pictures.into_iter().flatten().flatten().collect();
        Ok(Self { right_pictures, keys_and_mistakes, rows, small_pictures })
    }

    /// The mistakes that have to be drawn: those whose current redraw key has no row in the table,
    /// and those that lack a small picture.
    pub fn mistakes_to_draw(&self) -> impl Iterator<Item = &(u32, &'static Mistake)> {
        self.keys_and_mistakes.iter().filter(|(key, mistake)| {
            let has_picture =
                |picture: &MistakePicture| self.small_pictures.contains_key(picture.name);
            !self.rows.contains_key(key) || !mistake.pictures().iter().all(has_picture)
        })
    }

    /// Stores the row and the small pictures of a mistake that has been drawn. Prints the mistake's
    /// title if the mistake changes no picture.
    fn record(&mut self, key: u32, mistake: &Mistake, pictures: &DrawnPictures) {
        let hash = |(step, picture): &(Step, Option<RgbImage>)| {
            let hash = hash_picture(picture.as_ref()?);
            (!self.right_pictures.contains(&(step.name(), hash))).then_some(hash)
        };
        let hashes: Vec<_> = pictures.iter().map(hash).collect();
        if hashes.iter().all(Option::is_none) {
            println!("changes no picture: {}", title_and_file(mistake));
        }
        self.rows.insert(key, hashes);
        for mistake_picture in mistake.pictures() {
            self.small_pictures.remove(mistake_picture.name);
            let drawn_step = pictures.iter().find(|(step, _)| *step == mistake_picture.step);
            if let Some((_, Some(drawn_picture))) = drawn_step {
                self.small_pictures.insert(mistake_picture.name, make_small_picture(drawn_picture));
            }
        }
    }

    /// The small pictures of a step and their names, in the order of the list of mistakes.
    fn small_pictures_of_step(&self, step: Step) -> Vec<(&'static str, &RgbImage)> {
        let mistake_pictures =
            self.keys_and_mistakes.iter().flat_map(|(_, mistake)| mistake.pictures());
        mistake_pictures
            .filter(|picture| picture.step == step)
            .filter_map(|picture| Some((picture.name, self.small_pictures.get(picture.name)?)))
            .collect()
    }

    /// Formats the table.
    pub fn table_text(&self) -> String {
        let right_pictures = self.right_pictures.iter().map(|(name, hash)| {
            let pictures = Step::from_name(name).map(|step| self.small_pictures_of_step(step));
            let names = pictures.into_iter().flatten().map(|(name, _)| name);
            RightPicture { name, hash: *hash, small_pictures: names.collect() }
        });
        let rows = self.keys_and_mistakes.iter().map(|(key, _)| {
            let hashes = self.rows.get(key).cloned().unwrap_or_else(|| vec![None]);
            TableRow { key: *key, hashes }
        });
        MistakeTable { right_pictures: right_pictures.collect(), rows: rows.collect() }.to_string()
    }

    /// Writes the small pictures, then the table.
    fn write(&self) -> XtaskResult<()> {
        for step in Step::ALL {
            let pictures = self.small_pictures_of_step(step);
            let [columns, rows] = SMALL_SIZE;
            let mut column = RgbImage::new(columns, rows * pictures.len() as u32);
            for ((_, picture), k) in pictures.into_iter().zip(0..) {
                replace(&mut column, picture, 0, k * i64::from(rows));
            }
            let path = small_pictures_file_path(&workspace(), step);
            if !image::open(&path).is_ok_and(|old| old.into_rgb8() == column) {
                fs::write(&path, encode_png(&column)).map_err(XtaskError::of_file(&path))?;
            }
        }
        let path = workspace().join("book/crates/course/mistakes/table.txt");
        fs::write(&path, self.table_text()).map_err(XtaskError::of_file(&path))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mistakes_program::title_and_file;

    fn titles_of_mistakes_to_draw(drawn_mistakes: &DrawnMistakes) -> Vec<String> {
        drawn_mistakes.mistakes_to_draw().map(|(_, mistake)| title_and_file(mistake)).collect()
    }

    #[test]
    fn mistake_that_lacks_its_row_or_a_small_picture_is_to_be_drawn() {
        let read = || DrawnMistakes::read().expect("the list and the table can be read");
        let (mut without_row, mut without_picture) = (read(), read());
        let titles_of_undrawn_mistakes = titles_of_mistakes_to_draw(&without_row);
        let is_shown = |(_, mistake): &&(u32, &Mistake)| {
            mistake.presentation.is_some()
                && !titles_of_undrawn_mistakes.contains(&title_and_file(mistake))
        };
        let (key, mistake) = without_row
            .keys_and_mistakes
            .iter()
            .rfind(is_shown)
            .copied()
            .expect("the book shows a mistake that has been drawn");
        let expected = [title_and_file(mistake)];
        without_row.rows.remove(&key);
        without_picture.small_pictures.remove(mistake.pictures()[0].name);
        for drawn_mistakes in [without_row, without_picture] {
            let mut titles = titles_of_mistakes_to_draw(&drawn_mistakes);
            titles.retain(|title| !titles_of_undrawn_mistakes.contains(title));
            assert_eq!(titles, expected);
        }
    }
}
