use course::{Step, draw_panels, json};
use image::RgbImage;

/// Verdict on a picture, in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal to ours in every pixel, and nothing of it is transparent.
    Right,
    /// As a right program draws it with another size, field of view or number of samples.
    OtherOptions,
    /// Another picture.
    NotRight,
    /// No picture, or nothing to compare it with.
    Unreadable,
    /// No file of a picture that was asked for.
    Missing,
}

impl Verdict {
    /// The verdict in the words of tables and JSON.
    pub fn words(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::OtherOptions => "other options",
            Self::NotRight => "not right",
            Self::Unreadable => "unreadable",
            Self::Missing => "missing",
        }
    }

    /// The exit code of the program: 0 if right, 1 if not, 2 if nothing was compared.
    pub fn exit_code(self) -> u8 {
        match self {
            Self::Right => 0,
            Self::Unreadable | Self::Missing => 2,
            _ => 1,
        }
    }
}

/// Something that we know and that gives the reader's picture in every pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// A listed mistake, or what is another number, in a few words.
    pub words: String,
    /// The step of the listed mistake, or whose number it is, as far as that is known.
    pub step: Option<Step>,
    /// The file of the listed mistake, seen from the root of the workspace; None of a number.
    pub file: Option<String>,
    /// Lines about what is written there.
    pub details: String,
}

impl Cause {
    /// The words, and the file in brackets where it is known.
    pub fn words_and_file(&self) -> String {
        match &self.file {
            Some(file) => format!("{} ({file})", self.words),
            None => self.words.clone(),
        }
    }

    fn to_json(&self) -> String {
        let fields = [
            ("mistake", Some(&*self.words)),
            ("step", self.step.map(Step::name)),
            ("file", self.file.as_deref()),
        ];
        json::object(
            fields.into_iter().filter_map(|(name, value)| Some((name, json::quote(value?)))),
        )
    }
}

/// Answer of `check` about a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The verdict.
    pub verdict: Verdict,
    /// About eight lines, of which the first says the most.
    pub text: String,
    /// The sentence that helps most, for a table; empty if all is right.
    pub feedback: String,
    /// All causes that we know.
    pub causes: Vec<Cause>,
    /// The reader's picture and ours, where they differ and have one size.
    pub compared: Option<[RgbImage; 2]>,
}

impl Answer {
    /// An answer of words alone, whose first line helps most.
    pub fn new(verdict: Verdict, text: impl Into<String>) -> Self {
        let text = text.into();
        let feedback = text.lines().next().unwrap_or_default().to_owned();
        Self { verdict, text, feedback, causes: vec![], compared: None }
    }

    /// Says why nothing was compared.
    pub fn error(reason: impl std::fmt::Display) -> Self {
        Self::new(Verdict::Unreadable, reason.to_string())
    }

    /// The reader's picture, ours and the difference side by side, where they differ and have
    /// one size.
    pub fn draw_difference(&self) -> Option<RgbImage> {
        self.compared.as_ref().map(|[yours, ours]| draw_panels(yours, ours))
    }

    /// The answer as JSON.
    pub fn to_json(&self) -> String {
        json::object(self.json_fields())
    }

    /// The answer as fields of a JSON object; `mistakes` only where some are known.
    pub(crate) fn json_fields(&self) -> Vec<(&'static str, String)> {
        let mut fields = vec![("verdict", json::quote(self.verdict.words()))];
        if !self.causes.is_empty() {
            fields.push(("mistakes", json::list(self.causes.iter().map(Cause::to_json))));
        }
        fields.push(("text", json::quote(&self.text)));
        fields
    }
}

/// The first of some words, and how many more there are.
pub(crate) fn join_first(mut words: Vec<String>, most: usize, between: &str) -> String {
    let more = words.len().saturating_sub(most);
    words.truncate(most);
    words.extend((0 < more).then(|| format!("{more} more")));
    words.join(between)
}
