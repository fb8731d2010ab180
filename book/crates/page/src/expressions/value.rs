use glam::DVec3;
use std::mem::discriminant;

/// Value of a part of a line, which has that type.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs, reason = "they are called like their types")]
pub enum Value {
    F64(f64),
    Vector(DVec3),
    I32(i32),
    Bool(bool),
    Array([f64; 3]),
    /// No result: the reader's program stops here.
    Stop,
    /// The answer of a function to values that it doesn't take.
    Unfit,
}

/// A value of each type, with the name of the type, and words for it that a reader knows.
pub const SAMPLES: [(&str, Value, &str); 5] = [
    ("f64", Value::F64(1.0), "a number"),
    ("DVec3", Value::Vector(DVec3::ONE), "a vector"),
    ("i32", Value::I32(1), "a whole number"),
    ("bool", Value::Bool(true), "true or false"),
    ("[f64; 3]", Value::Array([1.0; 3]), "an array"),
];

impl Value {
    /// A value of the type of this name.
    pub fn from_type(name: &str) -> Option<Self> {
        SAMPLES.into_iter().find(|row| row.0 == name).map(|row| row.1)
    }

    /// Whether it is of the same type.
    pub fn is_like(&self, other: &Self) -> bool {
        discriminant(self) == discriminant(other)
    }

    /// The name of its type, and words for it.
    pub fn describe(&self) -> (&'static str, &'static str) {
        SAMPLES.iter().find(|row| row.1.is_like(self)).map_or(("", ""), |row| (row.0, row.2))
    }
}

macro_rules! convert {
    ($($type:ty: $name:ident)*) => {
        $(impl From<$type> for Value {
            fn from(value: $type) -> Self {
                Value::$name(value)
            }
        }

        impl TryFrom<Value> for $type {
            type Error = ();

            fn try_from(value: Value) -> Result<Self, ()> {
                if let Value::$name(value) = value { Ok(value) } else { Err(()) }
            }
        })*
    };
}

convert! { f64: F64 DVec3: Vector i32: I32 bool: Bool }
