//! The list of mistakes, and the marks in its files. A block of lines is a mistake: its
//! title, `-` what stands there, `+` what is written instead. `@` names the file of those
//! below. Where the book shows it: `!` the name of its picture (and of a step, if that is
//! another than the file's), `?` why it is wrong, `/` the section to go back to, `"` what
//! one sees.

use crate::Step;
use crate::mistake_files::mistake_texts;

/// Mistake that a reader may make: a place of a file, and the text written there instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// Short description.
    pub title: &'static str,
    /// The first step whose program it is in.
    pub step: Step,
    /// The file of that step, seen from the root of the workspace.
    pub file: String,
    /// Right text; blanks at the beginning of a line do not count.
    pub old: String,
    /// Text that is written instead.
    pub new: String,
    /// The name of each picture in the book, lower-case words with `-` between them, and the step
    /// that is drawn with the mistake in it: after `! name`, or else that of its file. It has none
    /// where the book does not show it, and none of the words below then.
    pub pictures: Vec<(&'static str, Step)>,
    /// How it comes about or what is right, in one sentence.
    pub reason: &'static str,
    /// The heading of its section, in a chapter of its step.
    pub section: &'static str,
    /// Sentence about what its picture shows.
    pub effect: &'static str,
}

/// All mistakes, in the order of the lists.
pub fn mistakes() -> Vec<Mistake> {
    let mut mistakes = vec![];
    for (step, list) in Step::ALL.into_iter().zip(mistake_texts()) {
        let mut file = String::new();
        for block in list.split("\n\n").map(|block| block.trim_matches('\n')) {
            match block.strip_prefix("@ ") {
                Some(path) => file = format!("steps/{}/src/{path}", step.name()),
                None => mistakes.extend(parse_mistake(step, &file, block)),
            }
        }
    }
    mistakes
}

/// The mistake that a block of a list tells.
fn parse_mistake(step: Step, file: &str, block: &'static str) -> Option<Mistake> {
    let (title, marked_lines) = block.split_once('\n')?;
    let marked = |mark: char| {
        let lines = marked_lines.lines().filter_map(move |line| line.strip_prefix(mark));
        lines.map(|line| line.strip_prefix(' ').unwrap_or(line))
    };
    let text = |mark| marked(mark).collect::<Vec<_>>().join("\n");
    let first_marked = |mark| marked(mark).next().unwrap_or_default();
    let pictures = marked('!').map(|picture| {
        let (name, drawn) = picture.split_once(' ').unwrap_or((picture, step.name()));
        // A word that is no step stays a part of the name, which no name may have.
        Step::from_name(drawn).map_or((picture, step), |drawn| (name, drawn))
    });
    Some(Mistake {
        title,
        step,
        file: file.to_owned(),
        old: text('-'),
        new: text('+'),
        pictures: pictures.collect(),
        reason: first_marked('?'),
        section: first_marked('/'),
        effect: first_marked('"'),
    })
}

impl Mistake {
    /// The steps whose pictures it may spoil, in their order: its own and those after it.
    pub fn affected_steps(&self) -> impl Iterator<Item = Step> {
        Step::ALL.into_iter().skip(self.step as usize)
    }

    /// Lines of the right text, each after a `-`, and those written instead, after `+`.
    pub fn old_and_new_lines(&self) -> String {
        let old = self.old.lines().map(|line| format!("- {line}"));
        let new = self.new.lines().map(|line| format!("+ {line}"));
        old.chain(new).collect::<Vec<_>>().join("\n")
    }

    /// The text of its file with the mistake in it and no line indented, if its place is there
    /// once.
    pub fn apply_and_unindent(&self, file_text: &str) -> Option<String> {
        let bare = |file_text: &str| {
            let lines: Vec<_> = file_text.split('\n').map(str::trim_start).collect();
            lines.join("\n")
        };
        let (file_text, old) = (bare(file_text), bare(&self.old));
        let is_once = file_text.matches(&old).count() == 1;
        is_once.then(|| file_text.replace(&old, &self.new))
    }
}
