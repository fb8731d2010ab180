use figures::{format_column, format_count, format_fixed, format_number, format_vector};
use glam::DVec3;

/// A number with the way it is written.
pub enum Value {
    /// At most four digits after the point.
    Number(f64),
    /// A fixed count of digits after the point.
    Fixed(usize, f64),
    /// A comma between thousands.
    Count(usize),
    /// (x, y, z).
    Vector(DVec3),
    /// A vector as a column of a formula.
    Column(DVec3),
}

impl Value {
    /// The value as it is written.
    pub fn text(&self) -> String {
        match *self {
            Self::Number(number) => format_number(number),
            Self::Fixed(digits, number) => format_fixed(number, digits),
            Self::Count(count) => format_count(count),
            Self::Vector(vector) => format_vector(vector),
            Self::Column(vector) => format_column(vector),
        }
    }
}

/// Values of a chapter, by name.
pub type Values = [(&'static str, fn() -> Value)];

/// Values of a chapter that are functions of a number, by name.
pub type Functions = [(&'static str, fn(f64) -> Value)];
