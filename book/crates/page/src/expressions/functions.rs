//! The functions, methods and operators that a line may use.

use crate::expressions::value::Value;
use course::ValueType;
use glam::DVec3;
use std::f64::consts;

/// A function with given parameter types. Overloads have separate entries.
pub struct Function {
    /// Its path, such as `f64::max`, for a function, method or constant; `DVec3.x` for a field; the
    /// sign for an operator; `as f64` for a cast.
    pub name: &'static str,
    /// The types of its parameters; none for a constant.
    pub parameters: &'static [ValueType],
    /// The type of its result.
    pub result: ValueType,
    /// Computes the result. Returns None if the reader's program would panic.
    pub apply: fn(&[Value]) -> Option<Value>,
}

/// All functions in the table.
pub fn functions() -> impl Iterator<Item = &'static Function> {
    FUNCTIONS.iter().copied().flatten()
}

/// Whether there is a function with this name, whatever its parameters.
pub fn is_known(name: &str) -> bool {
    functions().any(|function| function.name == name)
}

/// Finds the function with this name and these parameter types.
pub fn find_function(name: &str, types: &[ValueType]) -> Option<&'static Function> {
    functions().find(|function| function.name == name && function.parameters == types)
}

/// The number of operations that the remainder of two `values` counts as. A remainder is computed
/// bit by bit, so it takes long if the quotient is large.
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

/// Functions that have no result for some arguments: those for which the program would panic.
macro_rules! partial_functions {
    ($($name:expr, ($($value:ident: $type:ident),*) -> $result:ident = $body:expr;)*) => {
        &[$(Function {
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
    ($($name:expr, $parameters:tt -> $result:ident = $body:expr;)*) => {
        partial_functions! { $($name, $parameters -> $result = Some($body);)* }
    };
}

/// Methods and associated functions of a type, named by their paths.
macro_rules! methods {
    ($type:ident $parameters:tt $values:tt -> $result:ident: $($name:ident)*) => {
        functions! { $(
            concat!(stringify!($type), "::", stringify!($name)), $parameters
                -> $result = $type::$name $values;
        )* }
    };
}

macro_rules! constants {
    ($type:ident -> $result:ident: $($name:ident)*) => {
        functions! { $(
            concat!(stringify!($type), "::", stringify!($name)), () -> $result = $type::$name;
        )* }
    };
}

macro_rules! math_constants {
    ($($name:ident)*) => {
        functions! { $(
            concat!("std::f64::consts::", stringify!($name)), () -> F64 = consts::$name;
        )* }
    };
}

macro_rules! operators {
    ($($sign:tt)*) => {
        functions! { $(
            stringify!($sign), (a: F64, b: F64) -> F64 = a $sign b;
            stringify!($sign), (a: Vector, b: Vector) -> Vector = a $sign b;
            stringify!($sign), (a: Vector, b: F64) -> Vector = a $sign b;
            stringify!($sign), (a: F64, b: Vector) -> Vector = a $sign b;
        )* }
    };
}

macro_rules! comparisons {
    ($($sign:tt)*) => {
        functions! { $(
            stringify!($sign), (a: F64, b: F64) -> Bool = a $sign b;
            stringify!($sign), (a: I32, b: I32) -> Bool = a $sign b;
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
        "&&", (a: Bool, b: Bool) -> Bool = a && b;
        "||", (a: Bool, b: Bool) -> Bool = a || b;
        "!", (a: Bool) -> Bool = !a;
        "!", (a: I32) -> I32 = !a;
        "-", (a: F64) -> F64 = -a;
        "-", (a: Vector) -> Vector = -a;
        "f64::rem_euclid", (a: F64, b: F64) -> F64 = a.rem_euclid(b);
        "as f64", (a: F64) -> F64 = a;
        "as f64", (a: I32) -> F64 = a.into();
        "as i32", (a: F64) -> I32 = a as i32;
        "as i32", (a: I32) -> I32 = a;
        "as i32", (a: Bool) -> I32 = a.into();
        "f64::from", (a: I32) -> F64 = a.into();
        "f64::from", (a: F64) -> F64 = a;
        "f64::from", (a: Bool) -> F64 = a.into();
        "DVec3::new", (x: F64, y: F64, z: F64) -> Vector = DVec3::new(x, y, z);
        "DVec3::splat", (a: F64) -> Vector = DVec3::splat(a);
        "DVec3::from", (a: Array) -> Vector = a.into();
        "DVec3::from_array", (a: Array) -> Vector = DVec3::from_array(a);
        "DVec3::to_array", (a: Vector) -> Array = a.to_array();
        "[…]", (x: F64, y: F64, z: F64) -> Array = [x, y, z];
        "[0]", (a: Array) -> F64 = a[0];
        "[1]", (a: Array) -> F64 = a[1];
        "[2]", (a: Array) -> F64 = a[2];
        "[0]", (a: Vector) -> F64 = a.x;
        "[1]", (a: Vector) -> F64 = a.y;
        "[2]", (a: Vector) -> F64 = a.z;
        "DVec3.x", (a: Vector) -> F64 = a.x;
        "DVec3.y", (a: Vector) -> F64 = a.y;
        "DVec3.z", (a: Vector) -> F64 = a.z;
        "==", (a: Vector, b: Vector) -> Bool = a == b;
        "!=", (a: Vector, b: Vector) -> Bool = a != b;
        "==", (a: Bool, b: Bool) -> Bool = a == b;
        "!=", (a: Bool, b: Bool) -> Bool = a != b;
    },
    math_constants!(PI TAU E FRAC_PI_2 FRAC_PI_3 FRAC_PI_4 FRAC_PI_6 FRAC_PI_8 FRAC_1_PI FRAC_2_PI
        SQRT_2 FRAC_1_SQRT_2 LN_2 LN_10),
    // Integer operators panic on overflow, as in a development build.
    partial_functions! {
        "+", (a: I32, b: I32) -> I32 = a.checked_add(b);
        "-", (a: I32, b: I32) -> I32 = a.checked_sub(b);
        "*", (a: I32, b: I32) -> I32 = a.checked_mul(b);
        "/", (a: I32, b: I32) -> I32 = a.checked_div(b);
        "%", (a: I32, b: I32) -> I32 = a.checked_rem(b);
        "-", (a: I32) -> I32 = a.checked_neg();
        "i32::rem_euclid", (a: I32, b: I32) -> I32 = a.checked_rem_euclid(b);
        "f64::clamp", (a: F64, min: F64, max: F64) -> F64 = (min <= max).then(|| a.clamp(min, max));
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use ValueType::{F64, I32, Vector};

    #[test]
    fn function_is_found_by_its_name_and_types() {
        let result = |name, types: &[_]| find_function(name, types).map(|found| found.result);
        assert_eq!(result("*", &[F64, Vector]), Some(Vector));
        assert_eq!(result("*", &[I32, I32]), Some(I32));
        assert_eq!(result("*", &[I32, F64]), None);
        assert_eq!(result("DVec3::dot", &[Vector, Vector]), Some(F64));
        assert_eq!(result("f64::dot", &[F64, F64]), None);
        assert_eq!(result("DVec3::ZERO", &[]), Some(Vector));
    }

    #[test]
    fn function_has_no_result_where_the_program_would_stop() {
        let apply = |name, a, b| {
            let function = find_function(name, &[I32, I32]).expect("a function");
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
