//! The list of mistakes that readers make. It consists of one text file per step, in the folder
//! `mistakes` of this package.
//!
//! Blank lines separate each file into blocks, and nearly every block describes a mistake. The
//! first line of such a block is the mistake's title. Every other line of the block starts with a
//! mark that says what the line contains:
//!
//! - `-`: the right code,
//! - `+`: the wrong code that readers write instead.
//!
//! There are two other kinds of blocks:
//!
//! - a single line `@ FILE`, which names the source file of the mistakes below it,
//! - a comment, in which every line starts with `#`.
//!
//! If the book shows a mistake, the mistake's block has four more kinds of lines:
//!
//! - `!`: the name of a picture, then the name of the step that draws the picture; the step's name
//!   is left out if the step is the text file's own step; a block may have several such lines,
//! - `?`: why the code is wrong,
//! - `/`: the section to read again,
//! - `"`: what the picture shows.

use crate::{Step, mistake_files};
use std::sync::OnceLock;
use thiserror::Error;

/// A mistake that readers make: the right code in a file, and the wrong code that readers write
/// instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// A short description.
    pub title: &'static str,
    /// The step whose crate contains the file.
    pub step: Step,
    /// The path of the source file, relative to the workspace root.
    pub file: String,
    /// The right code. Whitespace at the start of its lines is ignored.
    pub old: String,
    /// The wrong code that readers write instead.
    pub new: String,
    /// How the book presents the mistake. None if the book doesn't show the mistake.
    pub presentation: Option<MistakePresentation>,
}

/// How the book presents a mistake.
#[derive(Clone, Debug, PartialEq)]
pub struct MistakePresentation {
    /// The pictures that show the mistake. There is at least one.
    pub pictures: Vec<MistakePicture>,
    /// A sentence that says why the code is wrong, or what would be right.
    pub reason: &'static str,
    /// The heading of the section that the reader should read again. This section is in a chapter
    /// about the mistake's step.
    pub section: &'static str,
    /// A sentence about what the picture shows.
    pub effect: &'static str,
}

/// One of the book's pictures of a mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MistakePicture {
    /// The picture's name: lower-case words joined by `-`.
    pub name: &'static str,
    /// The step that draws this picture if the mistake is made.
    pub step: Step,
}

/// Returns all mistakes, in the order of the lists. The lists are parsed only once. In the module
/// that a page loads, this function returns an empty slice until the page has provided the lists.
///
/// # Panics
///
/// Panics if a line in the lists can't be parsed. The lists are part of the project, and the
/// project's tests parse all of them.
pub fn mistakes() -> &'static [Mistake] {
    match parse_mistake_lists() {
        Ok(mistakes) => mistakes,
        Err(error) => panic!("{error}"),
    }
}

/// Like [`mistakes`], but returns an error if a line in the lists can't be parsed. In WebAssembly,
/// the list is empty until `provide_mistake_files` has been called.
pub fn parse_mistake_lists() -> Result<&'static [Mistake], MistakeListError> {
    static MISTAKES: OnceLock<Result<Vec<Mistake>, MistakeListError>> = OnceLock::new();
    let Some(texts) = mistake_files() else { return Ok(&[]) };
    let parsed = MISTAKES.get_or_init(|| {
        let lists = Step::ALL.into_iter().zip(texts.lists);
        let mistakes = lists.map(|(step, list)| parse_list(step, list));
        Ok(mistakes.collect::<Result<Vec<_>, _>>()?.concat())
    });
    parsed.as_deref().map_err(Clone::clone)
}

/// The error if a line in the lists can't be parsed.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("mistakes/{}.txt, line {line}: {fault}", .step.name())]
pub struct MistakeListError {
    step: Step,
    line: usize,
    fault: MistakeListFault,
}

/// What is wrong with a line in the lists.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
enum MistakeListFault {
    #[error("a line with `@` names a file, and needs blank lines around it")]
    File,
    #[error("a mistake needs a line `@ FILE` above it")]
    NoFile,
    #[error("a mistake needs lines with `-` and lines with `+` below its title")]
    NoCode,
    #[error("a line below a title must begin with `-`, `+`, `!`, `?`, `/` or `\"`, and a space")]
    UnknownMark,
    #[error("there is no step `{0}`: write `! NAME` or `! NAME STEP`")]
    UnknownStep(&'static str),
    #[error("the mistake already has a line with `{0}`")]
    Twice(char),
    #[error("a mistake needs all four of the marks `!`, `?`, `/` and `\"`, or none of them")]
    NotShown,
}

/// The number of a line in a list, and the line's text.
type NumberedLine = (usize, &'static str);

/// Parses the list of mistakes in a step.
fn parse_list(step: Step, list: &'static str) -> Result<Vec<Mistake>, MistakeListError> {
    let mut mistakes = vec![];
    let mut file = None;
    let lines: Vec<NumberedLine> = (1..).zip(list.lines()).collect();
    for block in lines.split(|(_, line)| line.is_empty()) {
        let Some(((line, first), marked_lines)) = block.split_first() else { continue };
        let fail = |fault| MistakeListError { step, line: *line, fault };
        match first.strip_prefix("@ ") {
            Some(path) if marked_lines.is_empty() => {
                file = Some(format!("steps/{}/src/{path}", step.name()));
            }
            Some(_) => return Err(fail(MistakeListFault::File)),
            None if block.iter().all(|(_, line)| line.starts_with('#')) => {}
            None => {
                let file = file.clone().ok_or(fail(MistakeListFault::NoFile))?;
                let mut parsed_lines = MarkedLines::default();
                for (line, text) in marked_lines {
                    let fail = |fault| MistakeListError { step, line: *line, fault };
                    parsed_lines.add_line(step, text).map_err(fail)?;
                }
                mistakes.push(parsed_lines.into_mistake(first, step, file).map_err(fail)?);
            }
        }
    }
    Ok(mistakes)
}

/// The lines below a mistake's title, grouped by their marks. The marks are cut off.
#[derive(Default)]
struct MarkedLines {
    old: Vec<&'static str>,
    new: Vec<&'static str>,
    pictures: Vec<MistakePicture>,
    reason: Option<&'static str>,
    section: Option<&'static str>,
    effect: Option<&'static str>,
}

impl MarkedLines {
    fn add_line(&mut self, step: Step, line: &'static str) -> Result<(), MistakeListFault> {
        // For an empty line of code, the mark stands alone, without a space.
        let (mark, words) = line.split_once(' ').unwrap_or((line, ""));
        match mark {
            "-" => self.old.push(words),
            "+" => self.new.push(words),
            "!" => self.pictures.push(parse_picture(step, words)?),
            "?" => set_once(&mut self.reason, '?', words)?,
            "/" => set_once(&mut self.section, '/', words)?,
            "\"" => set_once(&mut self.effect, '"', words)?,
            _ => return Err(MistakeListFault::UnknownMark),
        }
        Ok(())
    }

    fn into_mistake(
        self,
        title: &'static str,
        step: Step,
        file: String,
    ) -> Result<Mistake, MistakeListFault> {
        let Self { old, new, pictures, reason, section, effect } = self;
        if old.is_empty() || new.is_empty() {
            return Err(MistakeListFault::NoCode);
        }
        let presentation = match (reason, section, effect) {
            (None, None, None) if pictures.is_empty() => None,
            (Some(reason), Some(section), Some(effect)) if !pictures.is_empty() => {
                Some(MistakePresentation { pictures, reason, section, effect })
            }
            _ => return Err(MistakeListFault::NotShown),
        };
        Ok(Mistake { title, step, file, old: old.join("\n"), new: new.join("\n"), presentation })
    }
}

/// Stores the words of a line whose mark may occur only once per mistake. Returns an error if an
/// earlier line has the same mark.
fn set_once(
    line: &mut Option<&'static str>,
    mark: char,
    words: &'static str,
) -> Result<(), MistakeListFault> {
    match line.replace(words) {
        Some(_) => Err(MistakeListFault::Twice(mark)),
        None => Ok(()),
    }
}

/// Parses the words of a line with `!`: `NAME` or `NAME STEP`.
fn parse_picture(
    default_step: Step,
    words: &'static str,
) -> Result<MistakePicture, MistakeListFault> {
    let Some((name, step)) = words.split_once(' ') else {
        return Ok(MistakePicture { name: words, step: default_step });
    };
    let step = Step::from_name(step).ok_or(MistakeListFault::UnknownStep(step))?;
    Ok(MistakePicture { name, step })
}

impl Mistake {
    /// The book's pictures of the mistake. There are none if the book doesn't show the mistake.
    pub fn pictures(&self) -> &[MistakePicture] {
        self.presentation.as_ref().map(|presentation| &*presentation.pictures).unwrap_or_default()
    }

    /// Returns the address of the section that the reader should read again, such as
    /// `step01_rays.html#the-camera`. `extension` is the extension of the chapters' files. Returns
    /// None if the book doesn't show the mistake.
    pub fn section_address(&self, extension: &str) -> Option<String> {
        let heading = self.presentation.as_ref()?.section;
        let is_of_program = self.file.ends_with("/program.rs");
        let chapter = if is_of_program { "step01_program" } else { self.step.name() };
        // Convert only ASCII letters to lower case: Unicode's tables would make the WebAssembly
        // module `check` a twentieth larger.
        let id = heading.to_ascii_lowercase().replace(' ', "-");
        let id: String = id.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '-').collect();
        Some(format!("{chapter}.{extension}#{id}"))
    }

    /// The steps whose pictures the mistake may change: the mistake's step and all later steps.
    pub fn affected_steps(&self) -> impl Iterator<Item = Step> {
        Step::ALL.into_iter().skip(self.step as usize)
    }

    /// Formats the mistake as a diff: first the right code, with `- ` in front of each line, then
    /// the wrong code, with `+ ` in front of each line.
    pub fn format_as_diff(&self) -> String {
        let old = self.old.lines().map(|line| format!("- {line}"));
        let new = self.new.lines().map(|line| format!("+ {line}"));
        old.chain(new).collect::<Vec<_>>().join("\n")
    }

    /// Strips the indentation of every line of `file_text`, then replaces the right code with the
    /// wrong code. `file_text` is the text of the mistake's file. If the right code doesn't occur
    /// exactly once in `file_text`, the error is the number of occurrences.
    pub fn apply_and_strip_indentation(&self, file_text: &str) -> Result<String, usize> {
        let (file_text, old) =
            (trim_start_of_each_line(file_text), trim_start_of_each_line(&self.old));
        match file_text.matches(&old).count() {
            1 => Ok(file_text.replace(&old, &self.new)),
            count => Err(count),
        }
    }
}

/// Removes the whitespace at the start of each line.
fn trim_start_of_each_line(text: &str) -> String {
    let lines: Vec<_> = text.split('\n').map(str::trim_start).collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAMPLE_LIST: &str = "# A comment.

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
? It should be a.
/ The ray
\" Everything is blue.
";

    fn parse_sample_list(step: Step) -> [Mistake; 2] {
        let mistakes = parse_list(step, SAMPLE_LIST).expect("the list is well-formed");
        mistakes.try_into().expect("the list has two mistakes")
    }

    #[test]
    fn error_names_the_line_that_cannot_be_parsed() {
        let error = |list| parse_list(Step::Rays, list).expect_err(list);
        assert_eq!(
            error("# A comment.\n\n@ ray.rs\n\na title\n- a\n+ b\n* c").to_string(),
            "mistakes/step01_rays.txt, line 8: a line below a title must begin with `-`, `+`, \
             `!`, `?`, `/` or `\"`, and a space"
        );
        let start = "a title\n- a\n+ b\n! c";
        for (block, line, fault) in [
            ("@ camera.rs\n@ ray.rs", 3, MistakeListFault::File),
            ("a title", 3, MistakeListFault::NoCode),
            ("a title\n- a", 3, MistakeListFault::NoCode),
            ("a title\n-a\n+ b", 4, MistakeListFault::UnknownMark),
            (&format!("{start} step06"), 6, MistakeListFault::UnknownStep("step06")),
            (&format!("{start}\n? d\n? e"), 8, MistakeListFault::Twice('?')),
            (&format!("{start}\n? d\n/ e"), 3, MistakeListFault::NotShown),
            ("a title\n- a\n+ b\n? c\n/ d\n\" e", 3, MistakeListFault::NotShown),
        ] {
            let list = String::from("@ ray.rs\n\n") + block;
            let expected = MistakeListError { step: Step::Rays, line, fault };
            assert_eq!(error(list.leak()), expected, "{block}");
        }
        assert_eq!(error("a title\n- a\n+ b").fault, MistakeListFault::NoFile);
    }

    #[test]
    fn block_is_a_mistake_in_the_file_named_above_it() {
        let [short, long] = parse_sample_list(Step::Nearest);
        assert_eq!(short.title, "a short one");
        assert_eq!(short.file, "steps/step03_nearest/src/camera.rs");
        assert_eq!(short.old, "let a = 1;\n    let b = 2;");
        assert_eq!(short.new, "let a = 2;");
        assert_eq!(short.presentation, None);
        assert_eq!(long.file, "steps/step03_nearest/src/ray.rs");
        let picture = |name, step| MistakePicture { name, step };
        let presentation = MistakePresentation {
            pictures: vec![picture("shown", Step::Nearest), picture("later", Step::Phong)],
            reason: "It should be a.",
            section: "The ray",
            effect: "Everything is blue.",
        };
        assert_eq!(long.presentation, Some(presentation));
    }

    #[test]
    fn mistake_affects_its_step_and_the_later_ones() {
        let [mistake, _] = parse_sample_list(Step::Diffuse);
        let steps: Vec<_> = mistake.affected_steps().collect();
        assert_eq!(steps, [Step::Diffuse, Step::Phong]);
    }

    #[test]
    fn mistake_is_applied_if_the_right_code_occurs_once() {
        let [mistake, _] = parse_sample_list(Step::Rays);
        assert_eq!(mistake.format_as_diff(), "- let a = 1;\n-     let b = 2;\n+ let a = 2;");
        let once = "fn f() {\n    let a = 1;\n    let b = 2;\n}";
        assert_eq!(
            mistake.apply_and_strip_indentation(once).as_deref(),
            Ok("fn f() {\nlet a = 2;\n}")
        );
        assert_eq!(mistake.apply_and_strip_indentation(&format!("{once}\n{once}")), Err(2));
        assert_eq!(mistake.apply_and_strip_indentation("let a = 1;"), Err(0));
    }
}
