//! The list of mistakes that readers make. It consists of one text file for each step, in the
//! folder `mistakes` of this package.
//!
//! Blank lines separate a file into blocks, and nearly every block describes a mistake. The first
//! line is its title. Each of the other lines starts with a mark that says what the line contains:
//!
//! - `-` the right code,
//! - `+` the code that is written instead.
//!
//! There are two other kinds of blocks, both of a single line. A line that starts with `@` names
//! the source file that the mistakes below it are in, and any other line is a comment.
//!
//! If the book shows a mistake, its block has four more kinds of lines:
//!
//! - `!` the name of a picture, and the step that draws it unless that is the file's step; there
//!   may be several of these lines,
//! - `?` why the code is wrong,
//! - `/` the section to read again,
//! - `"` what the picture shows.

use crate::Step;
use crate::mistake_files::mistake_texts;
use std::sync::OnceLock;

/// A mistake that readers make: some code in a file, and what they write instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// A short description.
    pub title: &'static str,
    /// The step whose crate contains the file.
    pub step: Step,
    /// The file, as a path relative to the workspace root.
    pub file: String,
    /// The right code. Whitespace at the start of a line doesn't count.
    pub old: String,
    /// The code that is written instead.
    pub new: String,
    /// What the book says about the mistake, if it shows the mistake.
    pub shown: Option<ShownMistake>,
}

/// How the book shows a mistake.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownMistake {
    /// The pictures of the mistake, at least one.
    pub pictures: Vec<MistakePicture>,
    /// A sentence that says why the code is wrong, or what is right.
    pub reason: &'static str,
    /// The heading of the section to read again, in a chapter about the mistake's step.
    pub section: &'static str,
    /// A sentence about what the picture shows.
    pub effect: &'static str,
}

/// A picture in the book that shows a mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MistakePicture {
    /// The name: lower-case words joined by `-`.
    pub name: &'static str,
    /// The step that draws it with the mistake.
    pub step: Step,
}

/// Returns all mistakes, in the order of the lists, which are parsed only once. In a page's module,
/// there are none until the page has provided the lists.
pub fn mistakes() -> &'static [Mistake] {
    static MISTAKES: OnceLock<Vec<Mistake>> = OnceLock::new();
    let Some(texts) = mistake_texts() else { return &[] };
    MISTAKES.get_or_init(|| {
        let lists = Step::ALL.into_iter().zip(texts.lists);
        lists.flat_map(|(step, list)| parse_list(step, list)).collect()
    })
}

/// Parses a step's list.
fn parse_list(step: Step, list: &'static str) -> Vec<Mistake> {
    let mut mistakes = vec![];
    let mut file = String::new();
    for block in list.split("\n\n").map(|block| block.trim_matches('\n')) {
        match block.strip_prefix("@ ") {
            Some(path) => file = format!("steps/{}/src/{path}", step.name()),
            None => mistakes.extend(parse_mistake(step, &file, block)),
        }
    }
    mistakes
}

/// Parses a block of a list. Returns None for a comment, which is a single line.
fn parse_mistake(step: Step, file: &str, block: &'static str) -> Option<Mistake> {
    let (title, marked_lines) = block.split_once('\n')?;
    let marked = |mark: char| {
        let lines = marked_lines.lines().filter_map(move |line| line.strip_prefix(mark));
        lines.map(|line| line.strip_prefix(' ').unwrap_or(line))
    };
    let text = |mark| marked(mark).collect::<Vec<_>>().join("\n");
    let first_marked = |mark| marked(mark).next().unwrap_or_default();
    let pictures: Vec<_> = marked('!').map(|words| parse_picture(step, words)).collect();
    let shown = (!pictures.is_empty()).then(|| ShownMistake {
        pictures,
        reason: first_marked('?'),
        section: first_marked('/'),
        effect: first_marked('"'),
    });
    Some(Mistake { title, step, file: file.to_owned(), old: text('-'), new: text('+'), shown })
}

/// Parses `name` or `name step`. If the last word isn't a step, it stays in the name. That is an
/// error in the list, which a test finds because names contain no spaces.
fn parse_picture(default_step: Step, words: &'static str) -> MistakePicture {
    let name_and_step = words.rsplit_once(' ');
    let name_and_step = name_and_step.and_then(|(name, step)| Some((name, Step::from_name(step)?)));
    let (name, step) = name_and_step.unwrap_or((words, default_step));
    MistakePicture { name, step }
}

impl Mistake {
    /// The pictures of the mistake in the book, or none if the book doesn't show it.
    pub fn pictures(&self) -> &[MistakePicture] {
        self.shown.as_ref().map(|shown| &*shown.pictures).unwrap_or_default()
    }

    /// The steps whose pictures the mistake may change: its own and all later ones.
    pub fn affected_steps(&self) -> impl Iterator<Item = Step> {
        Step::ALL.into_iter().skip(self.step as usize)
    }

    /// Formats the mistake as a diff: first the right code, with `- ` in front of each line, then
    /// the code that is written instead, with `+ ` in front of each line.
    pub fn old_and_new_lines(&self) -> String {
        let old = self.old.lines().map(|line| format!("- {line}"));
        let new = self.new.lines().map(|line| format!("+ {line}"));
        old.chain(new).collect::<Vec<_>>().join("\n")
    }

    /// Returns the text of the mistake's file with the mistake in it, and without indentation. If
    /// the right code doesn't occur exactly once in `file_text`, returns the number of times it
    /// does.
    pub fn apply_and_unindent(&self, file_text: &str) -> Result<String, usize> {
        let (file_text, old) = (unindent(file_text), unindent(&self.old));
        match file_text.matches(&old).count() {
            1 => Ok(file_text.replace(&old, &self.new)),
            count => Err(count),
        }
    }
}

/// Removes the whitespace at the start of each line.
fn unindent(text: &str) -> String {
    let lines: Vec<_> = text.split('\n').map(str::trim_start).collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIST: &str = "# A comment.

@ camera.rs

a short one
- let a = 1;
-     let b = 2;
+ let a = 2;

@ ray.rs

one that the book shows
- a
+ b
! shown
! later step05_phong
! no step
? It should be a.
/ The ray
\" Everything is blue.
";

    #[test]
    fn block_is_a_mistake_of_the_file_above_it() {
        let [short, long] = &parse_list(Step::Nearest, LIST)[..] else { panic!("two mistakes") };
        assert_eq!(short.title, "a short one");
        assert_eq!(short.file, "steps/step03_nearest/src/camera.rs");
        assert_eq!(short.old, "let a = 1;\n    let b = 2;");
        assert_eq!(short.new, "let a = 2;");
        assert_eq!(short.shown, None);
        assert_eq!(long.file, "steps/step03_nearest/src/ray.rs");
        let picture = |name, step| MistakePicture { name, step };
        let shown = ShownMistake {
            pictures: vec![
                picture("shown", Step::Nearest),
                picture("later", Step::Phong),
                picture("no step", Step::Nearest),
            ],
            reason: "It should be a.",
            section: "The ray",
            effect: "Everything is blue.",
        };
        assert_eq!(long.shown, Some(shown));
    }

    #[test]
    fn mistake_affects_its_step_and_the_later_ones() {
        let [mistake, _] = &parse_list(Step::Diffuse, LIST)[..] else { panic!("two mistakes") };
        let steps: Vec<_> = mistake.affected_steps().collect();
        assert_eq!(steps, [Step::Diffuse, Step::Phong]);
    }

    #[test]
    fn mistake_is_applied_if_its_text_is_there_once() {
        let [mistake, _] = &parse_list(Step::Rays, LIST)[..] else { panic!("two mistakes") };
        assert_eq!(mistake.old_and_new_lines(), "- let a = 1;\n-     let b = 2;\n+ let a = 2;");
        let once = "fn f() {\n    let a = 1;\n    let b = 2;\n}";
        assert_eq!(mistake.apply_and_unindent(once).as_deref(), Ok("fn f() {\nlet a = 2;\n}"));
        assert_eq!(mistake.apply_and_unindent(&format!("{once}\n{once}")), Err(2));
        assert_eq!(mistake.apply_and_unindent("let a = 1;"), Err(0));
    }
}
