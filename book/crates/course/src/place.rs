use std::ops::Range;

/// An expression in the steps that a reader may edit: a block of places.txt.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Number in the order of places.txt, from 0 on.
    pub index: usize,
    /// Name in the address of an edit.
    pub name: &'static str,
    /// Path of the file, seen from the folder of the steps.
    pub file: &'static str,
    /// Code of the book there, in one row.
    pub code: &'static str,
    /// The type of its value, in Rust.
    pub kind: &'static str,
    /// Names that an expression may use there, and their types.
    pub variables: Vec<(&'static str, &'static str)>,
}

/// All blocks of places.txt, in its order.
pub fn all_listed_places() -> Vec<Place> {
    let (mut file, mut places) = ("", Vec::<Place>::new());
    for line in include_str!("../places.txt").lines() {
        if let Some(path) = line.strip_prefix("@ ") {
            file = path;
        } else if let Some(place) = parse_place(places.len(), file, line) {
            places.push(place);
        } else if let Some(place) = places.last_mut() {
            let Some((kind, names)) = line.trim().split_once(' ') else { continue };
            place.variables.extend(names.split("; ").map(|name| (name, kind)));
        }
    }
    places
}

/// The place of a line such as `a: f64 = v.dot(v)`.
fn parse_place(index: usize, file: &'static str, line: &'static str) -> Option<Place> {
    let (head, code) = line.split_once(" = ")?;
    let (name, kind) = head.split_once(": ")?;
    Some(Place { index, name, file, code, kind, variables: vec![] })
}

impl Place {
    /// The name of its step.
    pub fn step_name(&self) -> &'static str {
        self.file.split('/').next().unwrap_or_default()
    }

    /// Finds its code in a text, however its rows are broken.
    pub fn find_ranges(&self, text: &str) -> Vec<Range<usize>> {
        let first = self.code.split(' ').next().unwrap_or_default();
        let starts = text.match_indices(first).map(|(start, _)| start);
        let ranges = starts.filter_map(|start| {
            let mut remaining = &text[start..];
            for word in self.code.split(' ') {
                remaining = remaining.trim_start().strip_prefix(word)?;
            }
            Some(start..text.len() - remaining.len())
        });
        ranges.collect()
    }

    /// A sentence where it can't be edited, as its file, of this text, has changed; `sources`
    /// is the text of all files of the steps.
    pub fn find_fault(&self, text: &str, sources: &str) -> Option<String> {
        let Self { name, file, code, .. } = self;
        let count = self.find_ranges(text).len();
        if count != 1 {
            return Some(format!("{name}: `{code}` is {count} times in {file}."));
        }
        let has = |text: &str, word: &str| {
            let mut words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
            words.any(|one| one == word)
        };
        let is_unknown = |variable: &&str| {
            let mut parts = variable.split('.');
            let first = parts.next().and_then(|first| first.split(['(', ':']).next());
            let mut fields = parts.filter(|part| !part.contains(['(', ')']));
            !has(text, first.unwrap_or_default()) || fields.any(|field| !has(sources, field))
        };
        let mut variables = self.variables.iter().map(|(variable, _)| *variable);
        let unknown = variables.find(is_unknown)?;
        Some(format!("{name}: there is no `{unknown}` in {file}."))
    }
}
