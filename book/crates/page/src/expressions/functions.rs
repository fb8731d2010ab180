//! The functions, methods and operators that a line may use.

use crate::expressions::operation::OperationKind;
use crate::expressions::value::Value;
use course::ValueType;
use glam::DVec3;
use std::borrow::Cow;
use std::f64::consts;

/// A function, method or operator with given parameter types. In the table, each overload has an
/// entry of its own.
pub struct Function {
    /// The kind of operation that calls the function. A method can also be called by its path.
    pub kind: OperationKind,
    /// The name of the function in such an operation. For the method `f64::max`, this is `max`.
    pub name: &'static str,
    /// The types of the parameters. A constant has no parameters. For a method or a field, the
    /// first is the type of the receiver.
    pub parameters: &'static [ValueType],
    /// The type of the result.
    pub result: ValueType,
    /// Computes the result. Returns None if the reader's program would panic.
    pub apply: fn(&[Value]) -> Option<Value>,
}

impl Function {
    /// Returns the path of a function, method or constant, and None for anything else.
    pub fn qualified_name(&self) -> Option<Cow<'static, str>> {
        match (self.kind, self.parameters) {
            (OperationKind::Path, _) => Some(self.name.into()),
            (OperationKind::Method, [owner, ..]) => {
                Some(format!("{}::{}", owner.name(), self.name).into())
            }
            _ => None,
        }
    }

    /// Whether an operation of this kind and with this name refers to this function, assuming that
    /// the operands have the right types.
    pub fn is_named(&self, kind: OperationKind, name: &str) -> bool {
        match kind {
            OperationKind::Path => self.qualified_name().is_some_and(|qualified| qualified == name),
            _ => self.kind == kind && self.name == name,
        }
    }
}

/// All functions in the table.
pub fn functions() -> impl Iterator<Item = &'static Function> {
    FUNCTIONS.iter().copied().flatten()
}

/// Finds the function for an operation of this kind, with this name and operands of these types.
pub fn find_function(
    kind: OperationKind,
    name: &str,
    types: &[ValueType],
) -> Option<&'static Function> {
    functions().find(|function| function.parameters == types && function.is_named(kind, name))
}

/// Returns how many operations the remainder of two `values` costs. A remainder is computed bit by
/// bit, so it takes long if the quotient is large.
pub fn remainder_operations(values: &[Value]) -> u64 {
    let operations = |a: f64, b: f64| if a.abs() > 1e15 * b.abs() { 41 } else { 1 };
    let of_vectors = |a: DVec3, b: DVec3| (0..3).map(|axis| operations(a[axis], b[axis])).sum();
    match *values {
        [Value::F64(a), Value::F64(b)] => operations(a, b),
        [Value::Vector(a), Value::F64(b)] => of_vectors(a, DVec3::splat(b)),
        [Value::F64(a), Value::Vector(b)] => of_vectors(DVec3::splat(a), b),
        [Value::Vector(a), Value::Vector(b)] => of_vectors(a, b),
        _ => 1,
    }
}

/// Functions that have a result only for some arguments. For any other arguments, the reader's
/// program would panic.
macro_rules! partial_functions {
    ($(
        $kind:ident $name:expr,
        ($($value:ident: $type:ident),*) -> $result:ident = $body:expr;
    )*) => {
        &[$(Function {
            kind: OperationKind::$kind,
            name: $name,
            parameters: &[$(ValueType::$type),*],
            result: ValueType::$result,
            apply: |values| match *values {
                [$(Value::$type($value)),*] => $body.map(Value::$result),
                _ => None,
            },
        }),*]
    };
}

macro_rules! functions {
    ($($kind:ident $name:expr, $parameters:tt -> $result:ident = $body:expr;)*) => {
        partial_functions! { $($kind $name, $parameters -> $result = Some($body);)* }
    };
}

/// Several methods of one type. All have the same parameter types and the same result type.
macro_rules! methods {
    ($type:ident $parameters:tt $values:tt -> $result:ident: $($name:ident)*) => {
        functions! { $(
            Method stringify!($name), $parameters -> $result = $type::$name $values;
        )* }
    };
}

macro_rules! constants {
    ($type:ident -> $result:ident: $($name:ident)*) => {
        functions! { $(
            Path concat!(stringify!($type), "::", stringify!($name)), () -> $result = $type::$name;
        )* }
    };
}

macro_rules! math_constants {
    ($($name:ident)*) => {
        functions! { $(
            Path concat!("std::f64::consts::", stringify!($name)), () -> F64 = consts::$name;
        )* }
    };
}

macro_rules! operators {
    ($($operator:tt)*) => {
        functions! { $(
            Operator stringify!($operator), (a: F64, b: F64) -> F64 = a $operator b;
            Operator stringify!($operator), (a: Vector, b: Vector) -> Vector = a $operator b;
            Operator stringify!($operator), (a: Vector, b: F64) -> Vector = a $operator b;
            Operator stringify!($operator), (a: F64, b: Vector) -> Vector = a $operator b;
        )* }
    };
}

macro_rules! comparisons {
    ($($operator:tt)*) => {
        functions! { $(
            Operator stringify!($operator), (a: F64, b: F64) -> Bool = a $operator b;
            Operator stringify!($operator), (a: I32, b: I32) -> Bool = a $operator b;
        )* }
    };
}

static FUNCTIONS: &[&[Function]] = &[
    methods!(f64 (a: F64) (a) -> F64: abs floor ceil round trunc fract signum sqrt cbrt recip sin
        cos tan asin acos atan sinh cosh tanh exp exp2 ln log10 log2 to_degrees to_radians),
    methods!(f64 (a: F64) (a) -> Bool: is_nan is_finite is_sign_negative is_sign_positive),
    methods!(f64 (a: F64, b: F64) (a, b) -> F64: min max powf atan2 hypot copysign midpoint),
    methods!(f64 (a: F64, b: I32) (a, b) -> F64: powi),
    methods!(f64 (a: F64, b: F64, c: F64) (a, b, c) -> F64: mul_add),
    methods!(DVec3 (a: Vector) (a) -> Vector: abs floor ceil round trunc fract signum sqrt sin cos
        exp recip normalize normalize_or_zero),
    methods!(DVec3 (a: Vector) (a) -> F64: length length_squared length_recip max_element
        min_element element_sum element_product),
    methods!(DVec3 (a: Vector, b: Vector) (a, b) -> Vector: min max cross reflect project_onto
        reject_from midpoint),
    methods!(DVec3 (a: Vector, b: Vector) (a, b) -> F64: dot distance distance_squared
        angle_between),
    methods!(DVec3 (a: Vector, b: F64) (a, b) -> Vector: powf with_x with_y with_z),
    methods!(DVec3 (a: Vector, b: Vector, c: F64) (a, b, c) -> Vector: lerp),
    methods!(DVec3 (a: Vector, b: Vector, c: Vector) (a, b, c) -> Vector: clamp mul_add),
    constants!(f64 -> F64: MAX MIN NAN EPSILON INFINITY NEG_INFINITY),
    constants!(DVec3 -> Vector: ZERO ONE NEG_ONE X Y Z NEG_X NEG_Y NEG_Z),
    operators!(+ - * / %),
    comparisons!(== != < > <= >=),
    functions! {
        Operator "&&", (a: Bool, b: Bool) -> Bool = a && b;
        Operator "||", (a: Bool, b: Bool) -> Bool = a || b;
        Operator "!", (a: Bool) -> Bool = !a;
        Operator "!", (a: I32) -> I32 = !a;
        Operator "-", (a: F64) -> F64 = -a;
        Operator "-", (a: Vector) -> Vector = -a;
        Method "rem_euclid", (a: F64, b: F64) -> F64 = a.rem_euclid(b);
        Cast "f64", (a: F64) -> F64 = a;
        Cast "f64", (a: I32) -> F64 = a.into();
        Cast "i32", (a: F64) -> I32 = a as i32;
        Cast "i32", (a: I32) -> I32 = a;
        Cast "i32", (a: Bool) -> I32 = a.into();
        Path "f64::from", (a: I32) -> F64 = a.into();
        Path "f64::from", (a: F64) -> F64 = a;
        Path "f64::from", (a: Bool) -> F64 = a.into();
        Path "DVec3::new", (x: F64, y: F64, z: F64) -> Vector = DVec3::new(x, y, z);
        Path "DVec3::splat", (a: F64) -> Vector = DVec3::splat(a);
        Path "DVec3::from", (a: Array) -> Vector = a.into();
        Path "DVec3::from_array", (a: Array) -> Vector = DVec3::from_array(a);
        Method "to_array", (a: Vector) -> Array = a.to_array();
        Array "", (x: F64, y: F64, z: F64) -> Array = [x, y, z];
        Index "0", (a: Array) -> F64 = a[0];
        Index "1", (a: Array) -> F64 = a[1];
        Index "2", (a: Array) -> F64 = a[2];
        Index "0", (a: Vector) -> F64 = a.x;
        Index "1", (a: Vector) -> F64 = a.y;
        Index "2", (a: Vector) -> F64 = a.z;
        Field "x", (a: Vector) -> F64 = a.x;
        Field "y", (a: Vector) -> F64 = a.y;
        Field "z", (a: Vector) -> F64 = a.z;
        Operator "==", (a: Vector, b: Vector) -> Bool = a == b;
        Operator "!=", (a: Vector, b: Vector) -> Bool = a != b;
        Operator "==", (a: Bool, b: Bool) -> Bool = a == b;
        Operator "!=", (a: Bool, b: Bool) -> Bool = a != b;
    },
    math_constants!(PI TAU E FRAC_PI_2 FRAC_PI_3 FRAC_PI_4 FRAC_PI_6 FRAC_PI_8 FRAC_1_PI FRAC_2_PI
        SQRT_2 FRAC_1_SQRT_2 LN_2 LN_10),
    // These functions have no result where a debug build of the reader's program would panic. The
    // integer operators panic on overflow and on division by 0. `clamp` panics unless `min <= max`.
    partial_functions! {
        Operator "+", (a: I32, b: I32) -> I32 = a.checked_add(b);
        Operator "-", (a: I32, b: I32) -> I32 = a.checked_sub(b);
        Operator "*", (a: I32, b: I32) -> I32 = a.checked_mul(b);
        Operator "/", (a: I32, b: I32) -> I32 = a.checked_div(b);
        Operator "%", (a: I32, b: I32) -> I32 = a.checked_rem(b);
        Operator "-", (a: I32) -> I32 = a.checked_neg();
        Method "rem_euclid", (a: I32, b: I32) -> I32 = a.checked_rem_euclid(b);
        Method "clamp", (a: F64, min: F64, max: F64) -> F64
            = (min <= max).then(|| a.clamp(min, max));
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use OperationKind::{Cast, Field, Index, Method, Operator, Path};
    use ValueType::{F64, I32, Vector};

    #[test]
    fn function_is_found_by_its_kind_name_and_types() {
        let result = |kind, name, types: &[_]| {
            find_function(kind, name, types).map(|function| function.result)
        };
        assert_eq!(result(Operator, "*", &[F64, Vector]), Some(Vector));
        assert_eq!(result(Operator, "*", &[I32, I32]), Some(I32));
        assert_eq!(result(Operator, "*", &[I32, F64]), None);
        assert_eq!(result(Path, "DVec3::ZERO", &[]), Some(Vector));
        assert_eq!(result(Cast, "i32", &[F64]), Some(I32));
        assert_eq!(result(Index, "0", &[Vector]), Some(F64));
        assert_eq!(result(Path, "[0]", &[Vector]), None);
    }

    #[test]
    fn method_is_found_by_its_path_too() {
        let is_found = |kind, name, types: &[_]| find_function(kind, name, types).is_some();
        assert!(is_found(Method, "dot", &[Vector, Vector]));
        assert!(is_found(Path, "DVec3::dot", &[Vector, Vector]));
        assert!(!is_found(Path, "dot", &[Vector, Vector]));
        assert!(!is_found(Path, "f64::dot", &[F64, F64]));
        assert!(!is_found(Field, "length", &[Vector]));
        // `splat` is an associated function, but not a method.
        assert!(is_found(Path, "DVec3::splat", &[F64]));
        assert!(!is_found(Method, "splat", &[F64]));
    }

    #[test]
    fn function_has_no_result_where_the_program_would_stop() {
        let apply = |name, a, b| {
            let function = find_function(Operator, name, &[I32, I32]).expect("a function");
            (function.apply)(&[Value::I32(a), Value::I32(b)])
        };
        assert_eq!(apply("+", i32::MAX, 0), Some(Value::I32(i32::MAX)));
        assert_eq!(apply("+", i32::MAX, 1), None);
        assert_eq!(apply("/", 7, 0), None);
        assert_eq!(apply("%", i32::MIN, -1), None);
    }

    #[test]
    fn remainder_of_a_large_quotient_counts_as_more() {
        let operations = |a, b| remainder_operations(&[Value::F64(a), Value::F64(b)]);
        assert_eq!((operations(1e15, 1.0), operations(-1e16, 1.0)), (1, 41));
        let [small, large] = [DVec3::ONE, DVec3::new(1.0, 1e16, 1e16)].map(Value::Vector);
        assert_eq!(remainder_operations(&[small, Value::F64(1.0)]), 3);
        assert_eq!(remainder_operations(&[large, small]), 83);
        assert_eq!(remainder_operations(&[Value::I32(7), Value::I32(2)]), 1);
    }
}
