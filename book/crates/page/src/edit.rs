//! Replies to requests from the line editor.

use crate::expressions::{
    CompiledLine, Fault, LineRefusal, compile_line, draw_some_pixels, draw_step_of_first_line,
};
use crate::{EditedLine, RequestError};
use course::{
    Mistake, PICTURE_COLUMNS, Place, PlaceNote, Step, all_listed_places, find_mistakes_with_hash,
    hash_picture, hashes_of_right_pictures, json,
};
use figures::Reply;
use image::RgbImage;
use std::ops::{Range, RangeInclusive};

/// The picture widths that a page may ask for.
const ALLOWED_COLUMNS: RangeInclusive<u32> = 16..=FULL_WIDTH;

/// The width of the book's pictures.
const FULL_WIDTH: u32 = PICTURE_COLUMNS;

/// The maximum number of operations per picture. At full size, this is about 17 operations for each
/// pixel. In a browser, this many operations take about 150 ms, in addition to the time for the
/// book's own code.
const MAX_OPERATIONS: u64 = 4_000_000;

/// The horizontal and vertical distance between the pixels that [`describe_effect_on_later_steps`]
/// draws.
const PIXEL_SPACING: u32 = 12;

/// Draws a step with the reader's lines instead of the book's. If all lines are accepted, the reply
/// contains the picture, and the names that the first line may use. Otherwise, the reply says what
/// is wrong with one of the lines. If a picture of full size is right, or if a listed mistake draws
/// the same pixels, the reply says so.
pub fn edit(columns: u32, lines: &[EditedLine]) -> Result<Reply, RequestError> {
    Ok(Edit::new(columns, lines)?.reply())
}

/// A request to draw edited lines: the width of the picture, and each line with its place.
struct Edit<'a> {
    columns: u32,
    lines: Vec<(Place, &'a str)>,
}

impl<'a> Edit<'a> {
    /// Pairs each line with its place.
    fn new(columns: u32, lines: &'a [EditedLine]) -> Result<Self, RequestError> {
        if !ALLOWED_COLUMNS.contains(&columns) {
            return Err(RequestError::Columns(columns));
        }
        let places = all_listed_places();
        // A page shows each place at most once, so there can't be more lines than places.
        if lines.is_empty() || lines.len() > places.len() {
            return Err(RequestError::LineCount(lines.len()));
        }
        let pair_with_place = |line: &'a EditedLine| {
            let place = places.iter().find(|place| place.name == line.place);
            match place {
                Some(place) => Ok((place.clone(), &*line.text)),
                None => Err(RequestError::UnknownPlace(line.place.clone())),
            }
        };
        Ok(Self { columns, lines: lines.iter().map(pair_with_place).collect::<Result<_, _>>()? })
    }

    /// Compiles all lines.
    fn compile_lines(&self) -> Result<Vec<CompiledLine>, LineRefusal> {
        let compile = |(place, text): &(Place, &str)| {
            compile_line(place, text).map_err(|refusal| LineRefusal { place: place.name, refusal })
        };
        self.lines.iter().map(compile).collect()
    }

    /// Draws the picture. If the picture takes too many operations at full size, draws it at half
    /// the width and half the height.
    fn draw(&self) -> Result<RgbImage, LineRefusal> {
        let lines = self.compile_lines()?;
        let draw =
            |columns, max_operations| draw_step_of_first_line(&lines, columns, max_operations);
        let takes_too_long = |result: &Result<_, LineRefusal>| matches!(result, Err(error) if error.refusal.fault == Fault::OutOfOperations);
        if self.columns < FULL_WIDTH {
            return draw(self.columns, MAX_OPERATIONS);
        }
        // First draw a small picture, with a hundredth of the pixels. If the small picture takes
        // more than a fiftieth of the limit, the full size would take about twice the limit or
        // more, so don't try it.
        if !takes_too_long(&draw(FULL_WIDTH / 10, 2 * MAX_OPERATIONS / 100)) {
            let result = draw(FULL_WIDTH, MAX_OPERATIONS);
            if !takes_too_long(&result) {
                return result;
            }
        }
        draw(FULL_WIDTH / 2, MAX_OPERATIONS)
    }

    /// Replies with the picture and the names that the first line may use. If a line is refused,
    /// replies with the line's place, the fault, and the range at fault in UTF-16 code units.
    fn reply(&self) -> Reply {
        match self.draw() {
            Ok(picture) => {
                let note = match (self.columns, picture.width()) {
                    (FULL_WIDTH, FULL_WIDTH) => {
                        describe_known_picture(self, &picture).unwrap_or_default()
                    }
                    (FULL_WIDTH, _) => "Drawn smaller, as it takes long to compute.".to_owned(),
                    _ => String::new(),
                };
                let (place, _) = &self.lines[0];
                let names = place.variables.iter().map(|(name, _)| json::quote(name));
                let reply = Reply::from_json_fields([
                    ("size", json::list([picture.width(), picture.height()])),
                    ("note", json::quote(&note)),
                    ("names", json::list(names)),
                ]);
                Reply { pixels: figures::rgba_bytes(&picture), ..reply }
            }
            Err(LineRefusal { place, refusal }) => {
                let line = self.lines.iter().find(|(edited, _)| edited.name == place);
                let text = line.map_or("", |(_, text)| text);
                let range = utf16_range(text, &refusal.range);
                Reply::from_json_fields([
                    ("line", json::quote(place)),
                    ("from", range.start.to_string()),
                    ("to", range.end.to_string()),
                    ("fault", json::quote(&refusal.to_string())),
                ])
            }
        }
    }
}

/// Converts a byte range of a text to a range of UTF-16 code units, in which JavaScript counts.
fn utf16_range(text: &str, bytes: &Range<usize>) -> Range<usize> {
    let code_units = |end: usize| text[..end].encode_utf16().count();
    code_units(bytes.start)..code_units(bytes.end)
}

/// Says that a picture is right, or which listed mistake draws the same pixels. Returns None for
/// any other picture.
///
/// - If the picture is right, the lines may still change something that the picture can't show. If
///   the place of each line has the note [`PlaceNote::OnlyMovesHit`], the sentence describes the
///   effect of the lines on later steps, unless drawing these steps takes too many operations.
/// - A mistake is considered only if a single line is edited, and if the mistake changes the code
///   at the place of this line.
/// - A picture of a single colour isn't compared with the mistakes.
fn describe_known_picture(edit: &Edit, picture: &RgbImage) -> Option<String> {
    let lines = &edit.lines;
    let (place, _) = lines.first()?;
    let (step, hash) = (place.step().name(), hash_picture(picture));
    if hashes_of_right_pictures().any(|(name, right)| name == step && right == hash) {
        let only_moves_hit =
            |(place, _): &(Place, _)| place.notes.contains(&PlaceNote::OnlyMovesHit);
        let later = lines
            .iter()
            .all(only_moves_hit)
            .then(|| describe_effect_on_later_steps(edit))
            .flatten();
        let sentence = "Not one pixel differs from the book's picture.";
        return later.or_else(|| Some(sentence.to_owned()));
    }
    let mut pixels = picture.pixels();
    let first = pixels.next();
    if lines.len() > 1 || pixels.all(|pixel| Some(pixel) == first) {
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

/// Describes the effect of the lines on the steps after step 2. The picture of step 2 can't show
/// this effect, because the picture depends only on whether a ray meets the ball, not on the t of
/// the hit.
///
/// Draws some pixels of one later step after the other, with the reader's lines and with the
/// book's. The answer names the first step whose pixels differ, or that would stop because of the
/// lines. If there is no such step, the answer says that no pixel differs. Returns None if the
/// lines are refused for any other reason, such as too many operations.
fn describe_effect_on_later_steps(edit: &Edit) -> Option<String> {
    let lines = edit.compile_lines().ok()?;
    let cannot_show_sentence = "This picture can't show what you changed here: it shows whether a \
                                ray meets the ball, not at which t.";
    // In step 2, a ray evaluates the lines once. In a later step, it may evaluate them once for
    // each of the nine balls. So a pixel may take nine times as many operations here as a pixel of
    // a full-size picture.
    let max_operations = 9 * MAX_OPERATIONS / u64::from(PIXEL_SPACING * PIXEL_SPACING);
    let draw = |step: Step, lines: &[CompiledLine]| {
        draw_some_pixels(step, lines, PIXEL_SPACING, FULL_WIDTH, max_operations)
    };
    for step in [Step::Nearest, Step::Diffuse, Step::Phong] {
        let number = step.number();
        let picture = match draw(step, &lines) {
            Ok(picture) => picture,
            Err(LineRefusal { refusal, .. }) => match refusal.fault {
                Fault::Assertion(sentence) => {
                    return Some(format!(
                        "{cannot_show_sentence} Step {number} would stop: {sentence}."
                    ));
                }
                Fault::NoResult => {
                    return Some(format!("{cannot_show_sentence} Step {number} would stop."));
                }
                _ => return None,
            },
        };
        if picture != draw(step, &[]).ok()? {
            return Some(format!(
                "{cannot_show_sentence} The picture of step {number} would show it."
            ));
        }
    }
    let count = FULL_WIDTH.div_ceil(PIXEL_SPACING) * (FULL_WIDTH * 9 / 16).div_ceil(PIXEL_SPACING);
    Some(format!(
        "Not one pixel differs from the book's picture. In each of steps 3 to 5, {},{:03} pixels \
         were tried, and none differs there, either.",
        count / 1000,
        count % 1000
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes edited lines. Each line is given as the name of its place and its text.
    fn edited_lines<const N: usize>(lines: [(&str, &str); N]) -> [EditedLine; N] {
        lines.map(|(place, text)| EditedLine { place: place.to_owned(), text: text.to_owned() })
    }

    /// Replies to a request to draw these lines. Each line is a pair: the name of the line's place,
    /// and the line's text.
    fn reply<const N: usize>(columns: u32, lines: [(&str, &str); N]) -> Reply {
        edit(columns, &edited_lines(lines)).expect("the request is valid")
    }

    #[test]
    fn edit_with_impossible_columns_or_lines_is_an_error() {
        let error = |columns, lines: &[EditedLine]| edit(columns, lines).expect_err("an error");
        let lines = edited_lines([("a", "1.0"), ("nowhere", "1.0")]);
        for columns in [0, 15, 641] {
            assert_eq!(error(columns, &lines[..1]), RequestError::Columns(columns));
        }
        assert_eq!(error(640, &[]), RequestError::LineCount(0));
        assert_eq!(error(640, &vec![lines[0].clone(); 1000]), RequestError::LineCount(1000));
        assert_eq!(error(640, &lines), RequestError::UnknownPlace("nowhere".to_owned()));
    }

    #[test]
    fn reply_has_one_fault_or_one_picture() {
        let (fault, picture) = (reply(16, [("a", "1")]), reply(16, [("a", "1.0")]));
        assert_eq!(
            fault.text,
            r#"{"line":"a","from":0,"to":1,"fault":"Write 1.0: Rust doesn't mix whole numbers with others."}"#
        );
        assert!(fault.pixels.is_empty() && picture.text.starts_with(r#"{"size":[16,9],"#));
        assert_eq!(picture.pixels.len(), 16 * 9 * 4);
    }

    #[test]
    fn range_of_a_fault_is_in_utf16_code_units() {
        let from_and_to = |text: &str| {
            let reply = reply(16, [("a", "1.0"), ("disc", text)]);
            let (_, range_and_fault) = reply.text.split_once("\"from\":").expect("a fault");
            range_and_fault.split(",\"fault\"").next().map(str::to_owned).expect("its range")
        };
        assert_eq!(from_and_to("b − 4.0"), "2,\"to\":3");
        assert_eq!(from_and_to("b θ"), "2,\"to\":3");
        // This emoji has four bytes and two code units.
        assert_eq!(from_and_to("b 🙂"), "2,\"to\":4");
        assert_eq!(from_and_to("🙂 /* − */ \u{7}"), "11,\"to\":12");
        assert_eq!(from_and_to(&"🙂".repeat(100)), "0,\"to\":200");
    }

    #[test]
    fn branches_with_vectors_are_drawn_at_full_size() {
        for (place, line) in [
            (
                "diffuse",
                "if n.dot(l) > 0.5 { material.diffuse } else if n.dot(l) > 0.0 \
             { material.diffuse * 0.4 } else { DVec3::ZERO }",
            ),
            (
                "sky",
                "if v.x * v.x + v.y * v.y < 0.04 { DVec3::new(1.0, 0.9, 0.2) } \
             else { 0.7 + 0.3 * v }",
            ),
        ] {
            let text = reply(640, [(place, line)]).text;
            assert!(text.contains("\"size\":[640,360]"), "{line}: {text}");
        }
    }

    #[test]
    fn long_line_is_drawn_smaller() {
        for operators in [20, 60] {
            let line = format!("v{}", "+v".repeat(operators));
            let text = reply(640, [("sky", &line)]).text;
            assert!(text.contains("\"size\":[320,180]"), "{line}: {text}");
            assert!(text.contains("Drawn smaller"), "{line}: {text}");
        }
    }
}
