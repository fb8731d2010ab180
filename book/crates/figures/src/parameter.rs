//! A number that the reader can set.

use crate::format::format_number;
use crate::{ParameterId, ParameterValues, PointId};

/// A number that the reader can set with a control below the figure, or with a handle in the
/// figure.
///
/// All that a page knows about a parameter comes from this struct: the builder prints the control,
/// and the reply to an `About` request contains the rest.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The name under which the parameter's value is stored.
    pub id: ParameterId,
    /// The symbol, written as in the formulas. Empty if there is none.
    pub symbol: &'static str,
    /// The words that readers see after the symbol.
    pub label: String,
    /// The unit, such as °. Empty if there is none.
    pub unit: &'static str,
    /// The default value. Printed pages show the figure with this value.
    pub default: f64,
    /// The smallest and the largest allowed value.
    pub range: [f64; 2],
    /// The number of steps from one whole number to the next. Neighbouring allowed values are one
    /// step apart.
    pub steps_per_unit: f64,
    /// The meaning of the value, which determines the kind of control.
    pub kind: ParameterKind,
    /// The direction in which a handle moves when the value grows. None if the parameter isn't a
    /// coordinate.
    pub axis: Option<Axis>,
    /// Whether the page shows a control for this parameter when the figure has these values.
    pub has_control: fn(&Self, &ParameterValues) -> bool,
}

/// The meaning of a parameter's value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterKind {
    /// A number.
    Number,
    /// The index of one of these names.
    Choice(&'static [&'static str]),
    /// 1 if the switch is on, 0 if it is off.
    Switch,
}

/// A direction in a drawing or a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// To the right.
    Right,
    /// Upwards, like y in the world.
    Up,
    /// Downwards, like the rows of a picture.
    Down,
}

impl Axis {
    /// The name of the axis in a reply.
    pub fn name(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Up => "up",
            Self::Down => "down",
        }
    }
}

impl Parameter {
    /// A parameter that is a number, without a symbol or a unit.
    pub fn number(
        id: ParameterId,
        label: impl Into<String>,
        default: f64,
        range: [f64; 2],
        steps_per_unit: f64,
    ) -> Self {
        Self {
            id,
            symbol: "",
            label: label.into(),
            unit: "",
            default,
            range,
            steps_per_unit,
            kind: ParameterKind::Number,
            axis: None,
            has_control: |_, _| true,
        }
    }

    /// Sets the symbol.
    pub fn with_symbol(self, symbol: &'static str) -> Self {
        Self { symbol, ..self }
    }

    /// Sets the unit.
    pub fn with_unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// Makes the parameter a coordinate along this axis.
    pub fn with_axis(self, axis: Axis) -> Self {
        Self { axis: Some(axis), ..self }
    }

    /// The parameters for the x and y of a point.
    pub fn point(
        id: PointId,
        [x, y]: [f64; 2],
        [x_range, y_range]: [[f64; 2]; 2],
        steps_per_unit: f64,
    ) -> [Self; 2] {
        let label = format!("of {}", id.0);
        let x = Self::number(id.x(), &*label, x, x_range, steps_per_unit);
        let y = Self::number(id.y(), label, y, y_range, steps_per_unit);
        [x.with_symbol("x").with_axis(Axis::Right), y.with_symbol("y").with_axis(Axis::Up)]
    }

    /// A parameter that is a choice between several names.
    pub fn choice(
        id: ParameterId,
        label: &'static str,
        default: f64,
        names: &'static [&'static str],
    ) -> Self {
        let range = [0.0, (names.len() - 1) as f64];
        let kind = ParameterKind::Choice(names);
        Self { kind, ..Self::number(id, label, default, range, 1.0) }
    }

    /// A parameter that is a switch. `is_on` is the default.
    pub fn switch(id: ParameterId, label: &'static str, is_on: bool) -> Self {
        let number = Self::number(id, label, is_on.into(), [0.0, 1.0], 1.0);
        Self { kind: ParameterKind::Switch, ..number }
    }

    /// The difference between two neighbouring allowed values.
    pub fn step(&self) -> f64 {
        1.0 / self.steps_per_unit
    }

    /// The allowed value nearest to `value`.
    pub fn nearest_allowed(&self, value: f64) -> f64 {
        let [min, max] = self.range;
        let rounded = (value * self.steps_per_unit).round() / self.steps_per_unit;
        // Adding 0 turns −0 into 0.
        rounded.clamp(min, max) + 0.0
    }

    /// Formats a value as the page shows it.
    pub fn format(&self, value: f64) -> String {
        match self.kind {
            ParameterKind::Number => format_number(value) + self.unit,
            ParameterKind::Choice(names) => names[value as usize].to_string(),
            ParameterKind::Switch => if value == 1.0 { "on" } else { "off" }.to_string(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ID: ParameterId = ParameterId::new("id");

    #[test]
    fn nearest_allowed_value_is_a_step_within_the_range() {
        let parameter = Parameter::number(ID, "", 0.0, [-1.0, 2.0], 4.0);
        for (value, allowed) in [(0.3, 0.25), (-7.0, -1.0), (2.1, 2.0), (1.0, 1.0)] {
            assert_eq!(parameter.nearest_allowed(value), allowed, "{value}");
        }
        assert!(parameter.nearest_allowed(-0.1).is_sign_positive());
    }

    #[test]
    fn value_is_formatted_by_its_kind() {
        let angle = Parameter::number(ID, "angle", 0.0, [-90.0, 90.0], 1.0).with_unit("°");
        assert_eq!(angle.format(-30.0), "−30°");
        assert_eq!(Parameter::choice(ID, "side", 0.0, &["left", "right"]).format(1.0), "right");
        assert_eq!(Parameter::switch(ID, "light", true).format(0.0), "off");
    }
}
