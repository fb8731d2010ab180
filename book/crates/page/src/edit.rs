use crate::expressions::{
    Expression, Refusal, TOO_LONG, draw_edited, editable_places, parse_expression,
};
use course::{Mistake, Place, find_mistakes_with_hash, hash_picture, json, locked_hashes};
use figures::Reply;
use image::RgbImage;

/// The most steps of a picture: with them it takes less than 200 ms.
const STEPS: u64 = 2_500_000;

/// Places of step 2 that say at which t a ray meets the ball, which its picture doesn't show.
const UNSEEN: [&str; 8] = ["s", "v", "a", "b", "c", "discriminant", "near", "far"];

/// The names that an expression may use at the place NAME.
pub fn variables(name: &str) -> Reply {
    let Some(place) = find_place(name) else { return Reply::default() };
    let names = place.variables.iter().map(|(name, _)| json::quote(name));
    Reply::from_json_fields([("variables", json::list(names))])
}

/// The picture of a step with expressions of the reader's in it, to the words
/// `COLUMNS NAME EXPRESSION`, with U+001F before further `NAME EXPRESSION`; or what is wrong with
/// which of them, and from which letter to which. Of a picture in its full size it is told
/// whether it is right or a known mistake's.
pub fn edit(words: &str) -> Reply {
    let (columns, lines) = words.split_once(' ').unwrap_or_default();
    let lines = lines.split('\u{1f}').filter_map(|line| line.split_once(' '));
    let lines: Vec<_> = lines.filter_map(|(name, text)| Some((find_place(name)?, text))).collect();
    let (Some((place, _)), Ok(columns @ 16..=640)) = (lines.first(), columns.parse()) else {
        return Reply::default();
    };
    let draw = |columns, most_steps| {
        draw_edited(place.step_name(), parse_lines(&lines)?, columns, most_steps)
    };
    // A hundredth of the pixels tells what all would take.
    let is_long = draw(64, STEPS / 100).is_err_and(|(_, refusal)| refusal.sentence == TOO_LONG);
    let picture = draw(if is_long { columns.min(320) } else { columns }, STEPS);
    match picture {
        Ok(picture) => {
            let size = json::list([picture.width(), picture.height()]);
            let note = match (columns, picture.width()) {
                (640, 640) => describe(&lines, &picture),
                (640, _) => Some("Drawn smaller, as it takes long to compute.".to_owned()),
                _ => None,
            };
            let note = json::quote(&note.unwrap_or_default());
            let answer = Reply::from_json_fields([("size", size), ("known", note)]);
            Reply { pixels: figures::rgba_bytes(&picture), ..answer }
        }
        Err((name, Refusal { range, sentence })) => {
            let line = lines.iter().find(|(place, _)| place.name == name);
            let text = line.map_or("", |(_, text)| *text);
            // A page counts letters as JavaScript does.
            let letter_count = |end: usize| text[..end].encode_utf16().count().to_string();
            Reply::from_json_fields([
                ("line", json::quote(name)),
                ("from", letter_count(range.start)),
                ("to", letter_count(range.end)),
                ("mistake", json::quote(&sentence)),
            ])
        }
    }
}

type Edits = Vec<(Place, Expression)>;

fn parse_lines(lines: &[(Place, &str)]) -> Result<Edits, (&'static str, Refusal)> {
    let expressions = lines.iter().map(|(place, text)| {
        let expression = parse_expression(place, text).map_err(|refusal| (place.name, refusal))?;
        Ok((place.clone(), expression))
    });
    expressions.collect()
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
            && (place.code.contains(&old) || !place.find_ranges(&old).is_empty())
    };
    let mistakes = find_mistakes_with_hash(hash);
    let (mistake, _) = mistakes.iter().find(|(mistake, name)| *name == step && is_here(mistake))?;
    Some(format!("A known mistake gives the same pixels: {}.", mistake.title))
}

fn find_place(name: &str) -> Option<Place> {
    editable_places().into_iter().find(|place| place.name == name)
}
