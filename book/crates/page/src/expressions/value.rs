//! The values of a line and its parts.

use course::ValueType;
use glam::DVec3;

/// The value of a line or of a part of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs, reason = "each variant is named after its type")]
pub enum Value {
    F64(f64),
    Vector(DVec3),
    I32(i32),
    Bool(bool),
    Array([f64; 3]),
}

impl Value {
    /// The type of the value.
    pub fn value_type(self) -> ValueType {
        match self {
            Value::F64(_) => ValueType::F64,
            Value::Vector(_) => ValueType::Vector,
            Value::I32(_) => ValueType::I32,
            Value::Bool(_) => ValueType::Bool,
            Value::Array(_) => ValueType::Array,
        }
    }
}

/// Describes a type in words that a reader knows.
pub fn describe_type(value_type: ValueType) -> &'static str {
    match value_type {
        ValueType::F64 => "a number",
        ValueType::Vector => "a vector",
        ValueType::I32 => "a whole number",
        ValueType::Bool => "true or false",
        ValueType::Array => "an array",
    }
}

/// Describes a list of types in words, for example as `two vectors and one number`.
pub fn describe_types(types: &[ValueType]) -> String {
    let groups = types.chunk_by(|a, b| a == b).map(|group| match (group.len(), group[0]) {
        (1, ValueType::Bool) => describe_type(ValueType::Bool).to_owned(),
        (1, value_type) => {
            format!("one {}", describe_type(value_type).split_once(' ').map_or("", |words| words.1))
        }
        (count, ValueType::F64) => format!("{} numbers", count_word(count)),
        (count, ValueType::Vector) => format!("{} vectors", count_word(count)),
        (count, value_type) => format!("{} times {}", count_word(count), describe_type(value_type)),
    });
    let groups: Vec<_> = groups.collect();
    if groups.is_empty() { "no value".to_owned() } else { groups.join(" and ") }
}

/// Returns a verb and a number word, such as `are two`, for a sentence that counts something.
pub fn verb_and_count(count: usize) -> String {
    format!("{} {}", if count < 2 { "is" } else { "are" }, count_word(count))
}

fn count_word(count: usize) -> String {
    let words = ["none", "one", "two", "three", "four", "five", "six"];
    words.get(count).map_or(count.to_string(), |word| (*word).to_owned())
}

/// Capitalises the first letter, as at the beginning of a sentence.
pub fn capitalise(words: &str) -> String {
    let (first_letter, remaining_letters) = words.split_at(words.ceil_char_boundary(1));
    first_letter.to_ascii_uppercase() + remaining_letters
}

/// The error for a value that doesn't have the expected type.
pub struct TypeMismatch;

macro_rules! convert {
    ($($type:ty: $name:ident)*) => {
        $(impl From<$type> for Value {
            fn from(value: $type) -> Self {
                Value::$name(value)
            }
        }

        impl TryFrom<Value> for $type {
            type Error = TypeMismatch;

            fn try_from(value: Value) -> Result<Self, TypeMismatch> {
                if let Value::$name(value) = value { Ok(value) } else { Err(TypeMismatch) }
            }
        })*
    };
}

convert! { f64: F64 DVec3: Vector i32: I32 bool: Bool }
