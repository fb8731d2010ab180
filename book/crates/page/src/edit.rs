use crate::expressions::{ParseError, draw_edited, editable_places, parse_expression};
use course::{Mistake, Place, find_mistakes_with_hash, hash_picture, json, locked_hashes};
use figures::Reply;
use image::RgbImage;

/// The names that an expression may use at the place NAME.
pub fn variables(name: &str) -> Reply {
    let Some(place) = find_place(name) else { return Reply::default() };
    let names = place.variables.iter().map(|(name, _)| json::quote(name));
    Reply::from_json_fields([("variables", json::list(names))])
}

/// The picture of a step with an expression of the reader's in it, to the words
/// `NAME COLUMNS EXPRESSION`; or what is wrong with the expression, and from which letter to
/// which. Of a picture in its full size it is told whether it is right or a known mistake's.
pub fn edit(words: &str) -> Reply {
    let mut words = words.splitn(3, ' ');
    let mut word = || words.next().unwrap_or_default();
    let (place, columns, text) = (find_place(word()), word().parse(), word());
    let (Some(place), Ok(columns @ 16..=640)) = (place, columns) else {
        return Reply::default();
    };
    match parse_expression(&place, text) {
        Ok(expression) => {
            let picture = draw_edited(&place, expression, columns);
            let size = json::list([picture.width(), picture.height()]);
            let known = if columns == 640 { describe(&place, text, &picture) } else { None };
            let known = json::quote(&known.unwrap_or_default());
            let answer = Reply::from_json_fields([("size", size), ("known", known)]);
            Reply { pixels: figures::rgba_bytes(&picture), ..answer }
        }
        Err(ParseError { range, sentence }) => {
            // A page counts letters as JavaScript does.
            let at = |at: usize| text[..at].encode_utf16().count().to_string();
            Reply::from_json_fields([
                ("from", at(range.start)),
                ("to", at(range.end)),
                ("mistake", json::quote(&sentence)),
            ])
        }
    }
}

/// A sentence about a picture that is the right one, or that of a mistake in the list.
fn describe(place: &Place, text: &str, picture: &RgbImage) -> Option<String> {
    let (step, hash) = (place.step_name(), hash_picture(picture));
    if locked_hashes().any(|(name, right)| name == step && right == hash) {
        return Some("Not one pixel differs from the book's picture.".to_owned());
    }
    let mut mistakes = find_mistakes_with_hash(hash);
    mistakes.retain(|(_, name)| name == step);
    // What was written here comes before what gives the same pixels elsewhere.
    let file = format!("steps/{}", place.file);
    let is_here = |mistake: &Mistake| text.contains(&mistake.new) && mistake.file == file;
    mistakes.sort_by_key(|(mistake, _)| (!is_here(mistake), mistake.file != file));
    let (mistake, _) = mistakes.first()?;
    Some(format!("A known mistake gives the same pixels: {}.", mistake.title))
}

fn find_place(name: &str) -> Option<Place> {
    editable_places().into_iter().find(|place| place.name == name)
}
