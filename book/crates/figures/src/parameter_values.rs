//! The names of parameters, and the values that a figure's parameters have.

use glam::{DVec2, DVec3, dvec2};
use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};
use std::ops::Index;

/// The name of a parameter, unique within its figure.
///
/// The name is displayed as one word, such as `red-sphere-radius`. Pages refer to the parameter by
/// this word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ParameterId {
    object: Option<&'static str>,
    name: &'static str,
}

impl ParameterId {
    /// The name of a parameter that belongs to the figure as a whole.
    pub const fn new(name: &'static str) -> Self {
        Self { object: None, name }
    }

    /// The name of a parameter that belongs to one of the figure's objects.
    pub const fn of(object: &'static str, name: &'static str) -> Self {
        Self { object: Some(object), name }
    }

    /// Whether the id is displayed as `word`.
    pub fn is_displayed_as(self, word: &str) -> bool {
        let object = self.object.into_iter().flat_map(|object| object.bytes().chain([b'-']));
        // A request may name 180 parameters, and each name is compared with one id after another.
        // Comparing the lengths first is quick, and rules out most ids.
        let length = self.object.map_or(0, |object| object.len() + 1) + self.name.len();
        let is_equal = |(a, b)| a == if b == b' ' { b'-' } else { b };
        word.len() == length && word.bytes().zip(object.chain(self.name.bytes())).all(is_equal)
    }

    /// The object that the parameter belongs to. None if the parameter belongs to the figure as a
    /// whole.
    pub fn object(self) -> Option<&'static str> {
        self.object
    }

    /// The parameter's name, without the object.
    pub fn name(self) -> &'static str {
        self.name
    }
}

impl Display for ParameterId {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        if let Some(object) = self.object {
            write!(f, "{}-", object.replace(' ', "-"))?;
        }
        f.write_str(&self.name.replace(' ', "-"))
    }
}

/// A point whose coordinates are parameters. The field is the point's name in words, such as "the
/// start S".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointId(pub &'static str);

impl PointId {
    /// The name of the parameter for the point's x.
    pub const fn x(self) -> ParameterId {
        ParameterId::of(self.0, "x")
    }

    /// The name of the parameter for the point's y.
    pub const fn y(self) -> ParameterId {
        ParameterId::of(self.0, "y")
    }

    /// The name of the parameter for the point's z, if the point has a z.
    pub const fn z(self) -> ParameterId {
        ParameterId::of(self.0, "z")
    }
}

/// A value for each parameter of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterValues(BTreeMap<ParameterId, f64>);

impl ParameterValues {
    /// Sets the value of a parameter.
    pub fn set(&mut self, id: ParameterId, value: f64) {
        self.0.insert(id, value);
    }

    /// Whether a switch is on.
    pub fn is_on(&self, id: ParameterId) -> bool {
        self[id] == 1.0
    }

    /// The element of `options` that is selected in a choice.
    pub fn choice<T: Copy>(&self, id: ParameterId, options: &[T]) -> T {
        options[self[id] as usize]
    }

    /// The x and y of a point.
    pub fn point(&self, point: PointId) -> DVec2 {
        dvec2(self[point.x()], self[point.y()])
    }

    /// All three coordinates of a point.
    pub fn point_in_space(&self, point: PointId) -> DVec3 {
        self.point(point).extend(self[point.z()])
    }

    /// Whether all values are finite.
    pub fn are_finite(&self) -> bool {
        self.0.values().all(|value| value.is_finite())
    }
}

impl Index<ParameterId> for ParameterValues {
    type Output = f64;

    /// # Panics
    ///
    /// Panics if the figure has no such parameter.
    fn index(&self, id: ParameterId) -> &f64 {
        self.0.get(&id).unwrap_or_else(|| panic!("the figure has no parameter {id}"))
    }
}

impl FromIterator<(ParameterId, f64)> for ParameterValues {
    fn from_iter<T: IntoIterator<Item = (ParameterId, f64)>>(pairs: T) -> Self {
        // `collect` would sort the pairs first, and the code for sorting would add 6 kB to a
        // WebAssembly module.
        let mut values = BTreeMap::new();
        values.extend(pairs);
        Self(values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn id_is_displayed_as_one_word() {
        for (id, word) in [
            (ParameterId::new("field of view"), "field-of-view"),
            (ParameterId::of("red sphere", "radius"), "red-sphere-radius"),
            (PointId("the start S").y(), "the-start-S-y"),
        ] {
            assert_eq!(id.to_string(), word);
            assert!(id.is_displayed_as(word) && !id.is_displayed_as(&word[1..]), "{word}");
            assert!(!id.is_displayed_as(&format!("{word}-x")), "{word}");
        }
    }

    #[test]
    fn point_switch_and_choice_are_read_by_id() {
        let (point, side) = (PointId("P"), ParameterId::new("side"));
        let values: ParameterValues =
            [(point.x(), 3.0), (point.y(), 4.0), (side, 1.0)].into_iter().collect();
        assert_eq!(values.point(point), dvec2(3.0, 4.0));
        assert!(values.is_on(side));
        assert_eq!(values.choice(side, &["left", "right"]), "right");
    }

    #[test]
    fn values_with_infinity_or_nan_are_not_finite() {
        let side = ParameterId::new("side");
        let mut values: ParameterValues = [(side, 1.0)].into_iter().collect();
        assert!(values.are_finite());
        for value in [f64::INFINITY, f64::NAN] {
            values.set(side, value);
            assert!(!values.are_finite(), "{value}");
        }
    }
}
