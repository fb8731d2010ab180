//! The places: expressions in the steps' source code that a reader may edit on a page. They are
//! listed in `places.txt`.
//!
//! A line `@ FILE` names the source file of the places that follow. If the source file imports
//! `DVec3`, the line is `@ FILE uses DVec3`.
//!
//! The first line of a place, such as `a: f64 = v.dot(v)`, consists of the place's name, the type
//! of the value, and the book's code. Two kinds of indented lines may follow the first line:
//!
//! - `TYPE NAME; NAME; …` lists variables of this type that a reader's expression may use.
//! - `note: …` says what the surrounding code does with the value.
//!
//! Lines that start with `#` are comments.
//!
//! The build script of the package `page` compiles this file as well. So this file depends on std
//! alone.

use std::error::Error;
use std::fmt::{self, Display, Formatter};
use std::ops::Range;

/// A place: an expression in the steps that a reader may edit.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The place's index in places.txt.
    pub index: usize,
    /// The place's name in edit requests.
    pub name: &'static str,
    /// The path of the source file, relative to the folder `steps`.
    pub file: &'static str,
    /// Whether the file imports `glam::DVec3`.
    pub has_vectors: bool,
    /// The book's code for the expression, on one line.
    pub code: &'static str,
    /// The type of the expression.
    pub value_type: ValueType,
    /// The variables that a reader's expression may use, with their types.
    pub variables: Vec<(&'static str, ValueType)>,
    /// Notes on what the surrounding code does with the value.
    pub notes: Vec<PlaceNote>,
}

/// The Rust type of an edited expression, or of a part of such an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueType {
    /// `f64`.
    F64,
    /// `DVec3`.
    Vector,
    /// `i32`.
    I32,
    /// `bool`.
    Bool,
    /// `[f64; 3]`.
    Array,
}

impl ValueType {
    /// All types.
    pub const ALL: [Self; 5] = [Self::F64, Self::Vector, Self::I32, Self::Bool, Self::Array];

    /// The type's name in Rust.
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::Vector => "DVec3",
            Self::I32 => "i32",
            Self::Bool => "bool",
            Self::Array => "[f64; 3]",
        }
    }

    /// Finds a type by its name in Rust.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|value_type| value_type.name() == name)
    }
}

/// A note on what the surrounding code does with the value of a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaceNote {
    /// A method is called on the value. So a literal such as `1.0` needs a suffix: Rust has to know
    /// the literal's type before it can look up the method.
    MethodFollows,
    /// The value is the right operand of `&&`, which binds more tightly than `||`. So an expression
    /// with `||` needs parentheses.
    AfterAnd,
    /// The step's picture shows whether a ray hits the ball, but not at which `t`. So an edit that
    /// changes only `t` is visible only in the pictures of later steps.
    OnlyMovesHit,
    /// Nothing follows the expression on the same line, so a reader may add a comment.
    EndsLine,
    /// Nothing follows the expression on its line or in its block. So a reader may add a comment
    /// after the expression, and `let` statements before the expression.
    EndsBlock,
}

impl PlaceNote {
    const ALL: [Self; 5] =
        [Self::MethodFollows, Self::AfterAnd, Self::OnlyMovesHit, Self::EndsLine, Self::EndsBlock];

    /// The text of the note in places.txt.
    fn text_in_list(self) -> &'static str {
        match self {
            Self::MethodFollows => "a method is called on the value",
            Self::AfterAnd => "the right operand of &&",
            Self::OnlyMovesHit => "the picture doesn't show the t of a hit",
            Self::EndsLine => "nothing follows on its line",
            Self::EndsBlock => "the value of a block",
        }
    }
}

/// Returns all places, in the order of places.txt.
///
/// # Panics
///
/// Panics if a line in places.txt is malformed. Then the build of `page` fails, because the build
/// script of `page` calls this function.
pub fn all_listed_places() -> Vec<Place> {
    match parse_places(include_str!("../../places.txt")) {
        Ok(places) => places,
        Err(error) => panic!("places.txt, {error}"),
    }
}

/// Parses a list in the format of places.txt.
fn parse_places(text: &'static str) -> Result<Vec<Place>, PlaceListError> {
    let mut file = None;
    let mut places = Vec::<Place>::new();
    for (index, line) in text.lines().enumerate() {
        let fail = |fault| PlaceListError { line: index + 1, fault };
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        if let Some(path) = line.strip_prefix("@ ") {
            file = Some(path);
        } else if line.starts_with(' ') {
            let place = places.last_mut().ok_or(fail(PlaceListFault::NoPlace))?;
            place.add_variables_or_note(line.trim_start()).map_err(fail)?;
        } else {
            let file = file.ok_or(fail(PlaceListFault::NoFile))?;
            places.push(parse_first_line_of_place(places.len(), file, line).map_err(fail)?);
        }
    }
    Ok(places)
}

/// Parses the first line of a place, such as `a: f64 = v.dot(v)`. `file` is what follows `@ ` in
/// the line that names the place's file.
fn parse_first_line_of_place(
    index: usize,
    file: &'static str,
    line: &'static str,
) -> Result<Place, PlaceListFault> {
    let (head, code) = line.split_once(" = ").ok_or(PlaceListFault::NoCode)?;
    let (name, type_name) = head.split_once(": ").ok_or(PlaceListFault::NoCode)?;
    let path = file.strip_suffix(" uses DVec3");
    Ok(Place {
        index,
        name,
        file: path.unwrap_or(file),
        has_vectors: path.is_some(),
        code,
        value_type: parse_type(type_name)?,
        variables: vec![],
        notes: vec![],
    })
}

fn parse_type(name: &'static str) -> Result<ValueType, PlaceListFault> {
    ValueType::from_name(name).ok_or(PlaceListFault::UnknownType(name))
}

impl Place {
    /// Finds the place's code in `text`, where the code may be broken across lines.
    pub fn find_range(&self, text: &str) -> Result<Range<usize>, OccurrenceError> {
        let Self { name, file, code, .. } = *self;
        let first_word = code.split(' ').next().unwrap_or_default();
        let starts = text.match_indices(first_word).map(|(start, _)| start);
        let ranges = starts.filter_map(|start| {
            let mut remaining = &text[start..];
            for word in code.split(' ') {
                remaining = remaining.trim_start().strip_prefix(word)?;
            }
            Some(start..text.len() - remaining.len())
        });
        match &ranges.collect::<Vec<_>>()[..] {
            [range] => Ok(range.clone()),
            ranges => Err(OccurrenceError { name, file, code, count: ranges.len() }),
        }
    }

    /// Adds to the place the variables or the note in `line`, an indented line of the list.
    fn add_variables_or_note(&mut self, line: &'static str) -> Result<(), PlaceListFault> {
        if let Some(words) = line.strip_prefix("note: ") {
            let note = PlaceNote::ALL.into_iter().find(|note| note.text_in_list() == words);
            self.notes.push(note.ok_or(PlaceListFault::UnknownNote(words))?);
        } else {
            let (type_name, names) = line.split_once(' ').ok_or(PlaceListFault::NoNames)?;
            let value_type = parse_type(type_name)?;
            self.variables.extend(names.split("; ").map(|name| (name, value_type)));
        }
        Ok(())
    }
}

/// The error for a place whose code doesn't occur exactly once in the source file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OccurrenceError {
    name: &'static str,
    file: &'static str,
    code: &'static str,
    count: usize,
}

impl Display for OccurrenceError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { name, file, code, count } = self;
        write!(f, "{name} in places.txt: `{code}` has to occur once in {file}, not {count} times")
    }
}

impl Error for OccurrenceError {}

/// The error for a malformed line in places.txt.
#[derive(Clone, Debug, PartialEq, Eq)]
struct PlaceListError {
    line: usize,
    fault: PlaceListFault,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum PlaceListFault {
    NoFile,
    NoPlace,
    NoCode,
    NoNames,
    UnknownType(&'static str),
    UnknownNote(&'static str),
}

impl Display for PlaceListError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: ", self.line)?;
        match self.fault {
            PlaceListFault::NoFile => write!(f, "a place needs a line `@ FILE` above it"),
            PlaceListFault::NoPlace => write!(f, "an indented line needs a place above it"),
            PlaceListFault::NoCode => write!(f, "a place is `NAME: TYPE = CODE`"),
            PlaceListFault::NoNames => write!(f, "a type needs names after it"),
            PlaceListFault::UnknownType(name) => {
                write!(f, "a value can't have the type `{name}` here")
            }
            PlaceListFault::UnknownNote(words) => write!(f, "there is no note `{words}`"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIST: &str = "\
# a comment
@ step02_sphere/src/sphere.rs uses DVec3
a: f64 = v.dot(v)
    DVec3 s; ray.at(t)
    note: a method is called on the value

@ step02_sphere/src/quadratic.rs
misses: bool = d < 0.0
";

    #[test]
    fn list_is_parsed() {
        let places = parse_places(LIST).expect("the list is well-formed");
        let [a, misses] = &places[..] else { panic!("{places:?}") };
        assert_eq!((a.name, a.code, a.value_type), ("a", "v.dot(v)", ValueType::F64));
        assert_eq!((a.file, a.has_vectors), ("step02_sphere/src/sphere.rs", true));
        assert_eq!(a.variables, [("s", ValueType::Vector), ("ray.at(t)", ValueType::Vector)]);
        assert_eq!(a.notes, [PlaceNote::MethodFollows]);
        assert_eq!((misses.index, misses.file), (1, "step02_sphere/src/quadratic.rs"));
        assert_eq!((misses.has_vectors, misses.variables.len()), (false, 0));
    }

    #[test]
    fn fault_in_the_list_names_its_line() {
        for (list, message) in [
            ("\na: f64 = 1.0", "line 2: a place needs a line `@ FILE` above it"),
            ("@ x\n    f64 a", "line 2: an indented line needs a place above it"),
            ("@ x\na: f64", "line 2: a place is `NAME: TYPE = CODE`"),
            ("@ x\na: f32 = 1.0", "line 2: a value can't have the type `f32` here"),
            ("@ x\na: f64 = b\n  f64", "line 3: a type needs names after it"),
            ("@ x\na: f64 = b\n  note: c", "line 3: there is no note `c`"),
        ] {
            let error = parse_places(list).expect_err("the list is malformed");
            assert_eq!(error.to_string(), message);
        }
    }

    #[test]
    fn places_occur_once_and_their_end_notes_and_imports_are_right() {
        for place in all_listed_places() {
            let path = crate::workspace().join("steps").join(place.file);
            let text = std::fs::read_to_string(path).expect("the file can be read");
            let range = place.find_range(&text).unwrap_or_else(|error| panic!("{error}"));
            let (code_before, code_after) = (text[..range.start].trim_end(), &text[range.end..]);
            let ends_line = code_after.starts_with(['\r', '\n']);
            let ends_block =
                code_after.trim_start().starts_with('}') && code_before.ends_with(['{', ';']);
            let note = match (ends_line, ends_block) {
                (true, true) => Some(PlaceNote::EndsBlock),
                (true, false) => Some(PlaceNote::EndsLine),
                (false, _) => None,
            };
            let is_about_end =
                |note: &PlaceNote| matches!(note, PlaceNote::EndsLine | PlaceNote::EndsBlock);
            let notes_about_end = place.notes.iter().copied().filter(is_about_end);
            assert_eq!(Vec::from_iter(notes_about_end), Vec::from_iter(note), "{}", place.name);
            let imports = text.lines().filter(|line| line.starts_with("use glam::"));
            let has_vectors = imports.collect::<String>().contains("DVec3");
            assert_eq!(place.has_vectors, has_vectors, "`uses DVec3` of {}", place.file);
        }
    }

    #[test]
    fn range_is_found_if_the_code_occurs_once() {
        let [mut place, _] = parse_places(LIST)
            .expect("the list is well-formed")
            .try_into()
            .expect("the list has two places");
        place.code = "2.0 * s";
        assert_eq!(place.find_range("x = 2.0\n    * s;"), Ok(4..15));
        let error =
            |text| place.find_range(text).expect_err("there is no single range").to_string();
        let start = "a in places.txt: `2.0 * s` has to occur once in step02_sphere/src/sphere.rs";
        assert_eq!(error("2.0 + s"), format!("{start}, not 0 times"));
        assert_eq!(error("2.0 * s + 2.0 * s"), format!("{start}, not 2 times"));
    }
}
