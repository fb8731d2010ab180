use crate::format_number;

/// A number that the reader sets, by a control below a figure or by a handle in it.
#[derive(Clone)]
pub struct Parameter {
    /// The symbol, in the letters of the formulas; empty if there is none.
    pub symbol: &'static str,
    /// The name in words; empty if it is called by its handle.
    pub words: String,
    /// The default value, with which the book is printed.
    pub default: f64,
    /// The smallest and the largest value.
    pub range: [f64; 2],
    /// The number of allowed values from one whole number to the next.
    pub steps_per_unit: f64,
    /// The kind of control, and with it the meaning of the value.
    pub control: ControlKind,
    /// The object that it belongs to, where a page has the controls of one object at a
    /// time; otherwise empty.
    pub group: &'static str,
    /// Whether, at these values of all parameters, the page has a control for this one.
    pub has_control: fn(&Self, &[f64]) -> bool,
}

/// The kind of control that sets a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ControlKind {
    /// A number in this unit, such as °.
    Number(&'static str),
    /// One of these names, by its place in the list.
    Choice(&'static [&'static str]),
    /// 1 for on, 0 for off.
    Switch,
    /// The columns of a picture. It has no control: a page draws all, or fewer while
    /// something moves; a test draws fewer.
    Columns,
}

impl Parameter {
    /// A number with a symbol, words and a unit.
    pub fn new(
        [symbol, words, unit]: [&'static str; 3],
        default: f64,
        range: [f64; 2],
        steps_per_unit: f64,
    ) -> Self {
        Self {
            symbol,
            words: words.into(),
            default,
            range,
            steps_per_unit,
            control: ControlKind::Number(unit),
            group: "",
            has_control: |_, _| true,
        }
    }

    /// The x and y of a point that a handle sets, without words.
    pub fn point([x, y]: [f64; 2], ranges: [[f64; 2]; 2], steps_per_unit: f64) -> [Self; 2] {
        let [x_range, y_range] = ranges;
        [(x, x_range), (y, y_range)]
            .map(|(default, range)| Self::new([""; 3], default, range, steps_per_unit))
    }

    /// One of several names.
    pub fn choice(words: &'static str, default: f64, names: &'static [&'static str]) -> Self {
        let range = [0.0, (names.len() - 1) as f64];
        let control = ControlKind::Choice(names);
        Self { control, ..Self::new(["", words, ""], default, range, 1.0) }
    }

    /// A switch.
    pub fn switch(words: &'static str, is_on: bool) -> Self {
        let number = Self::new(["", words, ""], is_on.into(), [0.0, 1.0], 1.0);
        Self { control: ControlKind::Switch, ..number }
    }

    /// The allowed value that is nearest to `value`.
    pub fn nearest_allowed(&self, value: f64) -> f64 {
        let [min, max] = self.range;
        let rounded = (value * self.steps_per_unit).round() / self.steps_per_unit;
        // Adding 0 makes a 0 of −0.
        rounded.clamp(min, max) + 0.0
    }

    /// A value as the page writes it.
    pub fn format(&self, value: f64) -> String {
        match self.control {
            ControlKind::Number(unit) => format_number(value) + unit,
            ControlKind::Columns => format_number(value),
            ControlKind::Choice(names) => names[value as usize].to_string(),
            ControlKind::Switch => if value == 1.0 { "on" } else { "off" }.to_string(),
        }
    }
}

/// The values of N parameters, to be named one by one; a request with another number of
/// values got an error before.
pub fn array<const N: usize>(values: &[f64]) -> [f64; N] {
    values.try_into().expect("a value for each parameter")
}
