use crate::Drawing;
use glam::{DVec2, dvec2};
use image::RgbImage;
use std::collections::BTreeMap;

/// Something in the book that answers when its reader moves a part of it. One without
/// knobs is a figure that stays as it is.
#[derive(Clone, Debug)]
pub struct Live {
    /// What a chapter and the page call it.
    pub name: &'static str,
    /// What a figure shows, for those who can't see it; empty for a picture, of which
    /// the chapter says that.
    pub title: &'static str,
    /// What to look at in a figure; Markdown, with formulas.
    pub caption: &'static str,
    /// The numbers that its reader sets.
    pub knobs: Vec<Knob>,
    /// The places in it that its reader drags.
    pub handles: Vec<Handle>,
    /// Whether there is something to show at these values.
    pub is_allowed: fn(&[f64]) -> bool,
    /// What there is to see at these values.
    pub sight: fn(&[f64]) -> Sight,
    /// The numbers that move with it.
    pub numbers: fn(&[f64]) -> Numbers,
    /// A figure that moves with it.
    pub beside: Option<Beside>,
}

/// The name of a figure, and what draws it at the values of another.
pub type Beside = (&'static str, fn(&[f64]) -> Drawing);

/// Numbers by their names, as the page writes them.
pub type Numbers = BTreeMap<String, String>;

/// A number that the reader sets.
#[derive(Clone, Debug)]
pub struct Knob {
    /// Its symbol, in the letters of the formulas; empty where it has none.
    pub symbol: &'static str,
    /// What it is, in words; empty where a handle turns it.
    pub words: String,
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
    pub is_shown: fn(&Knob, &[f64]) -> bool,
    /// What it belongs to, where a page shows the knobs of one thing at a time.
    pub group: &'static str,
}

/// A place that the reader drags, by pointer or by arrow keys.
#[derive(Clone, Debug)]
pub struct Handle {
    /// What it is, in words.
    pub words: String,
    /// The knobs that it turns: sideways, and up and down.
    pub knobs: [usize; 2],
    /// Where it is, in the coordinates of the drawing or in pixels; outside of them,
    /// there is nothing to take.
    pub at: fn(&Handle, &[f64]) -> DVec2,
    /// To which values its two knobs bring it to a place, or near it.
    pub turn: fn(&Handle, &[f64], DVec2) -> DVec2,
    /// Whether its second knob counts downwards, as rows do.
    pub is_down: bool,
    /// Whether it asks, and changes nothing of what there is to see.
    pub is_asking: bool,
}

/// What there is to see.
#[derive(Clone, Debug)]
pub enum Sight {
    /// Lines and labels.
    Drawing(Drawing),
    /// Pixels.
    Picture(RgbImage),
}

impl Sight {
    /// Its width and height.
    pub fn size(&self) -> [f64; 2] {
        match self {
            Self::Drawing(drawing) => drawing.size(),
            Self::Picture(picture) => {
                <[u32; 2]>::from(picture.dimensions()).map(f64::from)
            }
        }
    }
}

impl Knob {
    /// A number from a range, in steps of which so many make 1.
    pub fn new(
        [symbol, words, unit]: [&'static str; 3],
        value: f64,
        range: [f64; 2],
        steps: f64,
    ) -> Self {
        Self {
            symbol,
            words: words.into(),
            unit,
            value,
            range,
            steps,
            choices: &[],
            is_shown: |_, _| true,
            group: "",
        }
    }

    /// A number that a handle turns.
    pub fn turned(value: f64, range: [f64; 2], steps: f64) -> Self {
        Self::new(["", "", ""], value, range, steps)
    }

    /// One of several choices.
    pub fn choice(
        words: &'static str,
        value: f64,
        choices: &'static [&'static str],
    ) -> Self {
        let range = [0.0, (choices.len() - 1) as f64];
        Self { choices, ..Self::new(["", words, ""], value, range, 1.0) }
    }

    /// A switch, which is on or off.
    pub fn switch(words: &'static str, is_on: bool) -> Self {
        Self::choice(words, f64::from(is_on), &["off", "on"])
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
    pub fn new(
        words: impl Into<String>,
        knobs: [usize; 2],
        at: fn(&Self, &[f64]) -> DVec2,
        turn: fn(&Self, &[f64], DVec2) -> DVec2,
    ) -> Self {
        let (is_down, is_asking) = (false, false);
        Self { words: words.into(), knobs, at, turn, is_down, is_asking }
    }

    /// Where it is at these values.
    pub fn place(&self, values: &[f64]) -> DVec2 {
        (self.at)(self, values)
    }

    /// The values of its two knobs.
    pub fn point(&self, values: &[f64]) -> DVec2 {
        let [x, y] = self.knobs.map(|knob| values[knob]);
        dvec2(x, y)
    }
}

impl Live {
    /// What shows `sight`, and has nothing to move yet.
    pub fn new(name: &'static str, sight: fn(&[f64]) -> Sight) -> Self {
        Self {
            name,
            title: "",
            caption: "",
            knobs: vec![],
            handles: vec![],
            is_allowed: |_| true,
            sight,
            numbers: |_| Numbers::new(),
            beside: None,
        }
    }

    /// The values in the printed book.
    pub fn values(&self) -> Vec<f64> {
        self.knobs.iter().map(|knob| knob.value).collect()
    }

    /// What there is to see in the printed book.
    pub fn printed(&self) -> Sight {
        (self.sight)(&self.values())
    }

    /// Whether its reader can ask a part of it.
    pub fn is_asked(&self) -> bool {
        self.handles.iter().any(|handle| handle.is_asking)
    }

    /// Moves a handle to a place; none where nothing is allowed there.
    pub fn drag(
        &self,
        values: &[f64],
        handle: &Handle,
        to: DVec2,
    ) -> Option<Vec<f64>> {
        let mut new = values.to_vec();
        let turned = (handle.turn)(handle, values, to).to_array();
        for (knob, value) in handle.knobs.into_iter().zip(turned) {
            new[knob] = value;
        }
        self.allowed(&new)
    }

    /// Moves a handle by some steps of its knobs, to the right and upwards.
    pub fn step(
        &self,
        values: &[f64],
        handle: &Handle,
        by: DVec2,
    ) -> Option<Vec<f64>> {
        let mut new = values.to_vec();
        let up = if handle.is_down { -by.y } else { by.y };
        for (knob, by) in handle.knobs.into_iter().zip([by.x, up]) {
            new[knob] += by / self.knobs[knob].steps;
        }
        // It ends where the handle comes to be.
        self.drag(&new, handle, handle.place(&new))
    }

    /// The allowed values that are nearest to these; none where there is nothing to
    /// show.
    pub fn allowed(&self, values: &[f64]) -> Option<Vec<f64>> {
        let is_whole = values.len() == self.knobs.len()
            && values.iter().all(|value| value.is_finite());
        let knobs = self.knobs.iter().zip(values);
        let values: Vec<_> =
            knobs.map(|(knob, value)| knob.nearest(*value)).collect();
        (is_whole && (self.is_allowed)(&values)).then_some(values)
    }
}

/// Names and what they stand for.
pub fn named<const N: usize>(numbers: [(&str, String); N]) -> Numbers {
    numbers.map(|(name, text)| (name.into(), text)).into()
}

/// A number with at most four digits after the point, and a minus that is one.
pub fn number(number: f64) -> String {
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.replace('-', "−") }
}

/// A number with at most so many digits after the point, up to four.
pub fn digits(digits: i32, value: f64) -> String {
    let tens = 10_f64.powi(digits);
    number((value * tens).round() / tens)
}

/// Numbers as (x, y, z).
pub fn vector<const N: usize>(all: impl Into<[f64; N]>) -> String {
    let all = all.into().map(number);
    format!("({})", all.join(", "))
}
