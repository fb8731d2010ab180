use std::ops::Range;

/// A fault in a chapter: its line, and a sentence about it.
pub type Fault = (usize, String);

/// The text of a chapter with the parts to replace in it, and what is wrong with it.
pub struct Edits<'a> {
    /// The text as its author wrote it.
    pub text: &'a str,
    replacements: Vec<(Range<usize>, String)>,
    faults: Vec<(usize, String)>,
}

impl<'a> Edits<'a> {
    pub fn new(text: &'a str) -> Self {
        Self { text, replacements: vec![], faults: vec![] }
    }

    /// Replaces a part that no other replacement touches. An error is a fault of it.
    pub fn replace(&mut self, range: Range<usize>, text: Result<String, String>) {
        match text {
            Ok(text) => self.replacements.push((range, text)),
            Err(fault) => {
                self.add_fault(range.start, fault);
                self.replacements.push((range, String::new()));
            }
        }
    }

    pub fn add_fault(&mut self, position: usize, sentence: impl Into<String>) {
        self.faults.push((position, sentence.into()));
    }

    /// The text with all parts replaced, and its faults from top to bottom.
    pub fn apply(mut self) -> (String, Vec<Fault>) {
        self.replacements.sort_by_key(|(range, _)| range.start);
        let mut replaced = String::new();
        let mut copied_end = 0;
        for (range, replacement) in &self.replacements {
            replaced += &self.text[copied_end..range.start];
            copied_end = range.end;
            // A comma stays on the line of the formula before it.
            let mark = self.text[copied_end..].chars().next();
            match mark.filter(|mark| ",.;:?)".contains(*mark)) {
                Some(mark) if replacement.ends_with("</math>") => {
                    replaced += &format!("<span class=\"tight\">{replacement}{mark}</span>");
                    copied_end += mark.len_utf8();
                }
                _ => replaced += replacement,
            }
        }
        replaced += &self.text[copied_end..];
        self.faults.sort();
        let line = |position: usize| 1 + self.text[..position].matches('\n').count();
        let faults = self.faults.into_iter().map(|(position, what)| (line(position), what));
        (replaced, faults.collect())
    }
}
