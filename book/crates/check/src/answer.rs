use course::{Step, draw_panels, json};
use image::RgbImage;

/// Verdict on a picture, in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal to ours in every pixel, and nothing of it is transparent.
    Right,
    /// Drawn by a right program with another size, field of view or number of samples.
    RightWithOtherOptions,
    /// Another picture.
    NotRight,
    /// No picture, or nothing to compare it with.
    Unreadable,
    /// No file.
    Missing,
}

impl Verdict {
    /// The verdict in the words of tables and JSON.
    pub fn words(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::RightWithOtherOptions => "other options",
            Self::NotRight => "not right",
            Self::Unreadable => "unreadable",
            Self::Missing => "missing",
        }
    }

    /// The exit code of the program: 0 if right, 1 if not, 2 if nothing was compared.
    pub fn exit_code(self) -> u8 {
        match self {
            Self::Right => 0,
            Self::RightWithOtherOptions | Self::NotRight => 1,
            Self::Unreadable | Self::Missing => 2,
        }
    }
}

/// The only cause that we know to give the picture; None each where several do.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cause {
    /// The step whose code is at fault.
    pub step: Option<Step>,
    /// The file, seen from the root of the workspace.
    pub file: Option<String>,
    /// The mistake, in a few words.
    pub mistake: Option<String>,
    /// All mistakes that we know and that give the picture.
    pub all: Vec<String>,
}

/// Answer of `check` about a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The verdict.
    pub verdict: Verdict,
    /// About eight lines, of which the first says the most.
    pub text: String,
    /// The cause, as far as we know it.
    pub cause: Cause,
    /// The reader's picture and ours, where they differ and have one size.
    pub compared: Option<[RgbImage; 2]>,
}

impl Answer {
    /// An answer of words alone.
    pub fn new(verdict: Verdict, text: impl Into<String>) -> Self {
        Self { verdict, text: text.into(), cause: Cause::default(), compared: None }
    }

    /// Says why nothing was compared.
    pub fn error(reason: impl std::fmt::Display) -> Self {
        Self::new(Verdict::Unreadable, format!("error: {reason}"))
    }

    /// The reader's picture, ours and the difference side by side, where they differ and have
    /// one size.
    pub fn draw_difference(&self) -> Option<RgbImage> {
        self.compared.as_ref().map(|[yours, ours]| draw_panels(yours, ours))
    }

    /// The answer as fields of a JSON object; those of the cause only where they are known.
    pub fn json_fields(&self) -> Vec<(&'static str, String)> {
        let Cause { step, file, mistake, .. } = &self.cause;
        let fields = [
            ("verdict", Some(self.verdict.words())),
            ("step", step.map(Step::name)),
            ("file", file.as_deref()),
            ("mistake", mistake.as_deref()),
            ("text", Some(&*self.text)),
        ];
        let fields = fields.into_iter();
        fields.filter_map(|(name, value)| Some((name, json::quote(value?)))).collect()
    }
}
