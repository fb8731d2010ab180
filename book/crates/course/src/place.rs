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

    /// Finds its code in a text, however its rows are broken; a sentence where it is not there
    /// once.
    pub fn find_range(&self, text: &str) -> Result<Range<usize>, String> {
        let Self { name, file, code, .. } = self;
        let first = code.split(' ').next().unwrap_or_default();
        let starts = text.match_indices(first).map(|(start, _)| start);
        let ranges = starts.filter_map(|start| {
            let mut remaining = &text[start..];
            for word in code.split(' ') {
                remaining = remaining.trim_start().strip_prefix(word)?;
            }
            Some(start..text.len() - remaining.len())
        });
        match &ranges.collect::<Vec<_>>()[..] {
            [range] => Ok(range.clone()),
            ranges => Err(format!("{name}: `{code}` is {} times in {file}.", ranges.len())),
        }
    }
}
