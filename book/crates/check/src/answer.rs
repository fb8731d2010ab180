//! The answer about a picture: a verdict, a headline, details and causes.

use crate::explain::section_sentence;
use course::{Mistake, Step, draw_with_difference, json};
use image::RgbImage;
use std::fmt::{self, Display, Formatter};

/// The exit code if the arguments are wrong, or if the program can't do its task.
pub const FAILURE_EXIT_CODE: u8 = 2;

/// The verdict on a picture that was compared with ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal to ours in every pixel, and opaque.
    Right,
    /// A picture that a right program draws with a different size, field of view or number of
    /// samples.
    OtherOptions,
    /// Any other picture.
    NotRight,
}

impl Verdict {
    /// The verdict in a word or two, for tables and JSON.
    pub fn label(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::OtherOptions => "other options",
            Self::NotRight => "not right",
        }
    }

    /// The first sentence of an answer.
    fn sentence(self) -> &'static str {
        match self {
            Self::Right => "Right.",
            Self::OtherOptions => "With other options.",
            Self::NotRight => "Not right.",
        }
    }

    /// The program's exit code: 0 if the picture is right, otherwise 1.
    pub fn exit_code(self) -> u8 {
        match self {
            Self::Right => 0,
            Self::OtherOptions | Self::NotRight => 1,
        }
    }
}

/// A change to a right program or to its scene. With the change, the program draws exactly the
/// reader's picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// A mistake from the list.
    Mistake(&'static Mistake),
    /// A mistyped number in the scene, such as `the radius of the sphere = 2 instead of 1`.
    SceneNumber(String),
    /// A different camera, or a change with the same effect.
    Camera(String),
}

impl Cause {
    /// The step whose code contains the cause, if that step is known.
    fn step(&self) -> Option<Step> {
        match self {
            Self::Mistake(mistake) => Some(mistake.step),
            Self::SceneNumber(_) => None,
            Self::Camera(_) => Some(Step::Rays),
        }
    }

    /// The file that contains the cause, if that file is known. The path is relative to the
    /// workspace root.
    pub(crate) fn file(&self) -> Option<&str> {
        match self {
            Self::Mistake(mistake) => Some(&mistake.file),
            Self::SceneNumber(_) | Self::Camera(_) => None,
        }
    }

    /// The cause in a few words.
    fn description(&self) -> &str {
        match self {
            Self::Mistake(mistake) => mistake.title,
            Self::SceneNumber(description) | Self::Camera(description) => description,
        }
    }

    fn to_json(&self) -> String {
        let fields = [
            ("cause", Some(self.description())),
            ("step", self.step().map(Step::name)),
            ("file", self.file()),
        ];
        let known_fields = fields.into_iter().filter_map(|(name, value)| Some((name, value?)));
        json::object(known_fields.map(|(name, value)| (name, json::quote(value))))
    }
}

/// Writes the description. If the file is known, the path of the file follows in parentheses.
impl Display for Cause {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{}", self.description())?;
        self.file().map_or(Ok(()), |file| write!(f, " ({file})"))
    }
}

/// A reader's picture and ours, which have the same size.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedPictures {
    /// The reader's picture.
    pub yours: RgbImage,
    /// The right picture.
    pub ours: RgbImage,
}

/// Reasons to doubt that the reader typed other options, although a right program would draw the
/// reader's picture with those options.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct OptionDoubts {
    /// The listed mistakes that, with the default options, produce the reader's picture. Mistakes
    /// in the code that reads the options are left out.
    pub mistakes: Vec<&'static Mistake>,
    /// Whether the whole picture is one colour. Many options and mistakes produce such a picture.
    pub is_one_colour: bool,
}

/// The answer of `check` about a picture. Its `Display` is the text that the program prints.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The verdict.
    pub verdict: Verdict,
    /// One sentence for each unusual property of the file, such as a palette.
    pub file_notes: Vec<String>,
    /// The most helpful sentence.
    pub headline: String,
    /// The lines after the headline, usually about six.
    pub details: Vec<String>,
    /// All changes we know of that reproduce this picture exactly.
    pub causes: Vec<Cause>,
    /// The reader's picture and ours, for drawing the difference. None if the pictures are equal,
    /// if their sizes differ, or if other options explain the difference.
    pub compared_pictures: Option<ComparedPictures>,
    /// The line about the causes. None if there are no causes, or if this line is the headline.
    pub(crate) causes_line: Option<String>,
    pub(crate) option_doubts: OptionDoubts,
}

impl Answer {
    /// An answer that consists only of a verdict and a headline.
    #[cfg(test)]
    pub(crate) fn new(verdict: Verdict, headline: String) -> Self {
        Self {
            verdict,
            file_notes: vec![],
            headline,
            details: vec![],
            causes: vec![],
            compared_pictures: None,
            causes_line: None,
            option_doubts: OptionDoubts::default(),
        }
    }

    /// Returns the answer as lines of text. The first line has the verdict and the most important
    /// sentence.
    pub fn lines(&self) -> Vec<String> {
        let (notes, headline) = (&self.file_notes[..], &[self.headline.clone()][..]);
        // If the picture is wrong, the notes on the file often explain why, so the notes come
        // first.
        let (first, second) = match self.verdict {
            Verdict::NotRight => (notes, headline),
            Verdict::Right | Verdict::OtherOptions => (headline, notes),
        };
        let mut lines = [first, second, &self.details].concat();
        lines[0] = format!("{} {}", self.verdict.sentence(), lines[0]);
        lines
    }

    /// Returns the answer's line that names a section of the book, and the address of this section
    /// on the book's pages. Returns None if no line names a section.
    pub fn section_link(&self) -> Option<(String, String)> {
        let Cause::Mistake(mistake) = self.causes.first()? else { return None };
        Some((section_sentence(mistake)?, mistake.section_address("html")?))
    }

    /// A summary for a row of a table: the notes on the file and, unless the picture is right, the
    /// headline and the causes.
    pub(crate) fn summary(&self) -> String {
        let headline = (self.verdict != Verdict::Right).then_some(&self.headline);
        let sentences = self.file_notes.iter().chain(headline).chain(&self.causes_line);
        let sentences: Vec<_> = sentences.map(|sentence| &**sentence).collect();
        sentences.join(" ")
    }

    /// Draws the reader's picture, ours and the difference side by side. Returns None if
    /// [`Self::compared_pictures`] is None.
    pub fn draw_comparison(&self) -> Option<RgbImage> {
        let ComparedPictures { yours, ours } = self.compared_pictures.as_ref()?;
        Some(draw_with_difference(yours, ours))
    }

    /// Formats the answer as JSON, leaving out notes and causes if there are none.
    pub fn to_json(&self) -> String {
        let quote_all = |texts: &[String]| json::list(texts.iter().map(|text| json::quote(text)));
        let mut fields = vec![("verdict", json::quote(self.verdict.label()))];
        if !self.file_notes.is_empty() {
            fields.push(("notes", quote_all(&self.file_notes)));
        }
        fields.push(("headline", json::quote(&self.headline)));
        fields.push(("details", quote_all(&self.details)));
        if !self.causes.is_empty() {
            fields.push(("causes", json::list(self.causes.iter().map(Cause::to_json))));
        }
        json::object(fields)
    }
}

impl Display for Answer {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{}", self.lines().join("\n"))
    }
}

/// Joins the first `max_items` items of a list. If the list is longer, the text ends in the
/// number of items left out, such as `2 more`.
pub(crate) fn join_first(mut items: Vec<String>, max_items: usize, separator: &str) -> String {
    let more = items.len().saturating_sub(max_items);
    items.truncate(max_items);
    if more > 0 {
        items.push(format!("{more} more"));
    }
    items.join(separator)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(verdict: Verdict) -> Answer {
        let file_notes = vec!["The file has a palette.".to_owned()];
        let details = vec!["Column 1.".to_owned()];
        Answer { file_notes, details, ..Answer::new(verdict, "It is blue.".to_owned()) }
    }

    #[test]
    fn notes_come_first_only_if_the_picture_is_not_right() {
        let wrong = answer(Verdict::NotRight);
        let text = "Not right. The file has a palette.\nIt is blue.\nColumn 1.";
        assert_eq!(wrong.to_string(), text);
        assert_eq!(wrong.summary(), "The file has a palette. It is blue.");
        let right = answer(Verdict::Right);
        assert_eq!(right.to_string(), "Right. It is blue.\nThe file has a palette.\nColumn 1.");
        assert_eq!(right.summary(), "The file has a palette.");
        let options = answer(Verdict::OtherOptions);
        let text = "With other options. It is blue.\nThe file has a palette.\nColumn 1.";
        assert_eq!(options.to_string(), text);
    }

    #[test]
    fn json_leaves_out_notes_and_causes_if_there_are_none() {
        let answer = Answer::new(Verdict::Right, "Equal.".to_owned());
        assert_eq!(answer.to_json(), r#"{"verdict":"right","headline":"Equal.","details":[]}"#);
        let causes = vec![Cause::Camera("x of D_u".to_owned())];
        let json = Answer { causes, ..answer }.to_json();
        assert!(
            json.ends_with(r#""causes":[{"cause":"x of D_u","step":"step01_rays"}]}"#),
            "{json}"
        );
    }

    #[test]
    fn items_beyond_the_maximum_are_counted() {
        let join = |items: &[&str]| {
            join_first(items.iter().map(|&item| item.to_owned()).collect(), 2, "; ")
        };
        assert_eq!(join(&[]), "");
        assert_eq!(join(&["a", "b"]), "a; b");
        assert_eq!(join(&["a", "b", "c", "d"]), "a; b; 2 more");
    }
}
