use crate::expressions::steps::step04_diffuse::Attenuation;
use crate::expressions::types::Type;
use glam::DVec3;
use std::sync::Arc;

/// Value of a part of a line. A usize has 64 bits, as on the reader's machine.
#[derive(Clone, Debug)]
#[allow(missing_docs, reason = "they are called like their types")]
pub enum Value {
    F64(f64),
    I32(i32),
    U32(u32),
    Usize(u64),
    /// A number such as 2 before its type is known.
    Whole(i64),
    Bool(bool),
    DVec3(DVec3),
    Attenuation(Attenuation),
    Array(Arc<[Value]>),
    /// Why the reader's program stops here.
    Stop(&'static str),
}

/// A type of the machine that is one of a line.
pub trait Typed {
    /// The type in a line.
    fn kind() -> Type;
    /// The value in a line.
    fn pack(self) -> Value;
    /// The value that a line has; the types of a line were checked before.
    fn unpack(value: &Value) -> Self;
}

macro_rules! typed {
    ($($type:ty: $name:ident, $default:expr;)*) => {
        $(impl Typed for $type {
            fn kind() -> Type {
                Type::$name
            }
            fn pack(self) -> Value {
                Value::$name(self)
            }
            fn unpack(value: &Value) -> Self {
                if let Value::$name(value) = value { *value } else { $default }
            }
        })*
    };
}

typed! {
    f64: F64, 0.0;
    i32: I32, 0;
    u32: U32, 0;
    u64: Usize, 0;
    bool: Bool, false;
    DVec3: DVec3, DVec3::ZERO;
    Attenuation: Attenuation, Attenuation { a: 0.0, b: 0.0, c: 0.0 };
}

impl Typed for [f64; 3] {
    fn kind() -> Type {
        Type::Array(Box::new(Type::F64), 3)
    }
    fn pack(self) -> Value {
        Value::Array(self.map(Value::F64).into())
    }
    fn unpack(value: &Value) -> Self {
        let Value::Array(values) = value else { return [0.0; 3] };
        [0, 1, 2].map(|index| values.get(index).map_or(0.0, f64::unpack))
    }
}

/// Result of whole numbers, which may overflow.
impl<T: Typed> Typed for Result<T, &'static str> {
    fn kind() -> Type {
        T::kind()
    }
    fn pack(self) -> Value {
        self.map_or_else(Value::Stop, T::pack)
    }
    fn unpack(value: &Value) -> Self {
        Ok(T::unpack(value))
    }
}
