use crate::Drawing;
use glam::DVec2;

/// Something in the book that answers when its reader moves a part of it.
#[derive(Clone, Copy, Debug)]
pub struct Live {
    /// What a chapter and the page call it.
    pub name: &'static str,
    /// The numbers that its reader sets.
    pub knobs: &'static [Knob],
    /// The places in it that its reader drags.
    pub handles: &'static [Handle],
    /// Whether there is something to show at these values, each of them allowed.
    pub is_allowed: fn(&[f64]) -> bool,
    /// What there is to see at these values.
    pub sight: fn(&[f64]) -> Sight,
    /// The numbers that move with it, by name.
    pub numbers: fn(&[f64]) -> Numbers,
    /// A figure that moves with it.
    pub beside: Option<Beside>,
}

/// The name of a figure, and what draws it at the values of another.
pub type Beside = (&'static str, fn(&[f64]) -> Drawing);

/// Numbers by their names, as the page writes them.
pub type Numbers = Vec<(String, String)>;

/// A number that the reader sets.
#[derive(Clone, Copy, Debug)]
pub struct Knob {
    /// Its symbol, in the letters of the formulas; empty where it has none.
    pub symbol: &'static str,
    /// What it is, in words.
    pub words: &'static str,
    /// What stands behind the number, such as °.
    pub unit: &'static str,
    /// Its value in the printed book.
    pub value: f64,
    /// The smallest and the largest value.
    pub range: [f64; 2],
    /// How many of its steps make 1.
    pub steps: f64,
    /// What the values 0, 1, 2, … are called, where they are no numbers.
    pub choices: &'static [&'static str],
    /// Whether, at these values, the page has a range or a switch for it.
    pub is_shown: fn(&[f64]) -> bool,
    /// What it belongs to, where a page shows the knobs of one thing at a time.
    pub group: &'static str,
}

/// A place that the reader drags, by pointer or by arrow keys.
#[derive(Clone, Copy, Debug)]
pub struct Handle {
    /// What it is, in words.
    pub words: &'static str,
    /// The knobs that it turns: sideways, and up and down.
    pub knobs: [usize; 2],
    /// Where it is, in the coordinates of the drawing or in pixels; outside of them,
    /// there is nothing to take.
    pub at: fn(&[f64]) -> DVec2,
    /// Sets the values so that it comes to a place, or near it.
    pub drag: fn(&mut [f64], DVec2),
    /// Whether its second knob counts downwards, as rows do.
    pub is_down: bool,
    /// Whether it asks, and changes nothing of what there is to see.
    pub is_asking: bool,
}

/// What there is to see: a drawing or a picture.
#[derive(Clone, Debug)]
pub enum Sight {
    /// Lines and labels.
    Drawing(Drawing),
    /// Pixels, red, green, blue and 255 for each, row by row.
    Picture {
        /// Columns and rows.
        size: [u32; 2],
        /// Four bytes a pixel.
        pixels: Vec<u8>,
    },
}

impl Knob {
    /// A number from a range, in steps of which so many make 1.
    pub const fn new(
        [symbol, words, unit]: [&'static str; 3],
        value: f64,
        range: [f64; 2],
        steps: f64,
    ) -> Self {
        Self {
            symbol,
            words,
            unit,
            value,
            range,
            steps,
            choices: &[],
            is_shown: |_| true,
            group: "",
        }
    }

    /// One of several choices.
    pub const fn choice(
        words: &'static str,
        value: f64,
        choices: &'static [&'static str],
    ) -> Self {
        let range = [0.0, (choices.len() - 1) as f64];
        Self {
            symbol: "",
            words,
            unit: "",
            value,
            range,
            steps: 1.0,
            choices,
            is_shown: |_| true,
            group: "",
        }
    }

    /// The same number, which the page leaves as it is.
    pub const fn fixed(self) -> Self {
        Self { is_shown: |_| false, ..self }
    }

    /// The same number, of a thing of this name.
    pub const fn of(self, group: &'static str) -> Self {
        Self { group, ..self }
    }

    /// The allowed value that is nearest to `value`.
    pub fn nearest(&self, value: f64) -> f64 {
        let [min, max] = self.range;
        // Adding 0 makes a 0 of −0.
        ((value * self.steps).round() / self.steps).clamp(min, max) + 0.0
    }

    /// A value as the page writes it.
    pub fn text(&self, value: f64) -> String {
        let choice = self.choices.get(value as usize);
        choice
            .map_or_else(|| number(value) + self.unit, |choice| choice.to_string())
    }
}

impl Handle {
    /// A place that turns two knobs; upwards counts upwards.
    pub const fn new(
        words: &'static str,
        knobs: [usize; 2],
        at: fn(&[f64]) -> DVec2,
        drag: fn(&mut [f64], DVec2),
    ) -> Self {
        Self { words, knobs, at, drag, is_down: false, is_asking: false }
    }
}

impl Live {
    /// The values in the printed book.
    pub fn values(&self) -> Vec<f64> {
        self.knobs.iter().map(|knob| knob.value).collect()
    }

    /// Whether its reader can ask a part of it.
    pub fn is_asked(&self) -> bool {
        self.handles.iter().any(|handle| handle.is_asking)
    }

    /// Moves a handle to a place; the values stay where nothing is allowed there.
    pub fn drag(&self, values: &[f64], handle: &Handle, to: DVec2) -> Vec<f64> {
        let mut new = values.to_vec();
        (handle.drag)(&mut new, to);
        self.allowed(new).unwrap_or_else(|| values.to_vec())
    }

    /// Moves a handle by some steps of its knobs, to the right and upwards.
    pub fn step(&self, values: &[f64], handle: &Handle, by: DVec2) -> Vec<f64> {
        let mut new = values.to_vec();
        let up = if handle.is_down { -by.y } else { by.y };
        for (knob, by) in handle.knobs.into_iter().zip([by.x, up]) {
            new[knob] += by / self.knobs[knob].steps;
        }
        // It ends where the handle comes to be.
        let to = (handle.at)(&new);
        (handle.drag)(&mut new, to);
        self.allowed(new).unwrap_or_else(|| values.to_vec())
    }

    /// The allowed values that are nearest to these; none where there is nothing to
    /// show.
    pub fn allowed(&self, values: Vec<f64>) -> Option<Vec<f64>> {
        let is_whole = values.len() == self.knobs.len()
            && values.iter().all(|value| value.is_finite());
        let knobs = self.knobs.iter().zip(values);
        let values: Vec<_> =
            knobs.map(|(knob, value)| knob.nearest(value)).collect();
        (is_whole && (self.is_allowed)(&values)).then_some(values)
    }
}

/// A number with at most four digits after the point, and a minus that is one.
pub fn number(number: f64) -> String {
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.replace('-', "−") }
}

/// Numbers as (x, y, z).
pub fn vector(all: &[f64]) -> String {
    let all: Vec<_> = all.iter().map(|one| number(*one)).collect();
    format!("({})", all.join(", "))
}
