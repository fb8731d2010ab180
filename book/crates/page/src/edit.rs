use crate::expressions::{Refusal, TOO_LONG, draw_edited, parse_expression};
use course::{
    Mistake, Place, all_listed_places, find_mistakes_with_hash, hash_picture, json, locked_hashes,
};
use figures::Reply;
use image::RgbImage;

/// The most steps of a picture: with them it takes less than 200 ms.
const STEPS: i64 = 2_200_000;

/// Places of step 2 that say at which t a ray meets the ball, which its picture doesn't show.
const UNSEEN: [&str; 8] = ["s", "v", "a", "b", "c", "discriminant", "near", "far"];

/// The picture of a step with expressions of the reader's in it, to the words
/// `COLUMNS NAME EXPRESSION`, with U+001F before further `NAME EXPRESSION`, and the names that the
/// first may use; or what is wrong with which of them, and from which letter to which. Of a picture
/// in its full size it is told whether it is right or a known mistake's.
pub fn edit(words: &str) -> Reply {
    let (columns, lines) = words.split_once(' ').unwrap_or_default();
    let places = all_listed_places();
    // A page has each place once.
    if places.len() < lines.split('\u{1f}').count() {
        return Reply::default();
    }
    let lines = lines.split('\u{1f}').filter_map(|line| {
        let (name, text) = line.split_once(' ')?;
        Some((places.iter().find(|place| place.name == name)?.clone(), text))
    });
    let lines: Vec<_> = lines.collect();
    let (Some((place, _)), Ok(columns @ 16..=640)) = (lines.first(), columns.parse()) else {
        return Reply::default();
    };
    match draw(&lines, columns) {
        Ok(picture) => {
            let note = match (columns, picture.width()) {
                (640, 640) => describe(&lines, &picture),
                (640, _) => Some("Drawn smaller, as it takes long to compute.".to_owned()),
                _ => None,
            };
            let names = place.variables.iter().map(|(name, _)| json::quote(name));
            let answer = Reply::from_json_fields([
                ("size", json::list([picture.width(), picture.height()])),
                ("known", json::quote(&note.unwrap_or_default())),
                ("names", json::list(names)),
            ]);
            Reply { pixels: figures::rgba_bytes(&picture), ..answer }
        }
        Err((name, Refusal { range, sentence })) => Reply::from_json_fields([
            ("line", json::quote(name)),
            ("from", range.start.to_string()),
            ("to", range.end.to_string()),
            ("mistake", json::quote(&sentence)),
        ]),
    }
}

/// The picture with these lines, smaller where it would take too long.
fn draw(lines: &[(Place, &str)], columns: u32) -> Result<RgbImage, (&'static str, Refusal)> {
    let parse = |(place, text): &(Place, &str)| {
        parse_expression(place, text).map_err(|refusal| (place.name, refusal))
    };
    let lines = lines.iter().map(parse).collect::<Result<Vec<_>, _>>()?;
    // A hundredth of the pixels tells what all would take.
    let small_picture = draw_edited(&lines, 64, STEPS / 100);
    let is_long = small_picture.is_err_and(|(_, refusal)| refusal.sentence == TOO_LONG);
    draw_edited(&lines, if is_long { columns.min(320) } else { columns }, STEPS)
}

/// A sentence about a picture that is the right one, or that of a listed mistake in the line.
fn describe(lines: &[(Place, &str)], picture: &RgbImage) -> Option<String> {
    let (place, _) = lines.first()?;
    let (step, hash) = (place.step_name(), hash_picture(picture));
    if locked_hashes().any(|(name, right)| name == step && right == hash) {
        let is_seen = |(place, _): &(Place, _)| !UNSEEN.contains(&place.name);
        return Some(match lines.iter().any(is_seen) {
            true => "Not one pixel differs from the book's picture.".to_owned(),
            false => "This picture can't show what you changed here: it shows whether a ray meets \
                      the ball, not at which t. From step 3 on, you would see it."
                .to_owned(),
        });
    }
    let mut pixels = picture.pixels();
    let first = pixels.next();
    if 1 < lines.len() || pixels.all(|pixel| Some(pixel) == first) {
        return None;
    }
    let is_here = |mistake: &Mistake| {
        let old = mistake.old.split_whitespace().collect::<Vec<_>>().join(" ");
        mistake.file == format!("steps/{}", place.file)
            && (place.code.contains(&old) || place.find_range(&old).is_ok())
    };
    let mistakes = find_mistakes_with_hash(hash);
    let (mistake, _) = mistakes.iter().find(|(mistake, name)| *name == step && is_here(mistake))?;
    Some(format!("A known mistake gives the same pixels: {}.", mistake.title))
}
