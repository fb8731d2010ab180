use crate::expressions::drawing::spend;
use crate::expressions::value::Value::{self, Array, Bool, F64, I32, Stop, Unfit, Vector};
use glam::DVec3;
use std::f64::consts;

/// Gives the value for these, or tells that it doesn't take such.
pub type Apply = fn(&[Value]) -> Value;

/// Whether there is a function of this name.
pub fn is_known(name: &str) -> bool {
    FUNCTIONS.iter().copied().flatten().any(|(known, _)| *known == name)
}

/// The function of this name that takes values of these types.
pub fn find_function(name: &str, values: &[Value]) -> Option<Apply> {
    let mut functions = FUNCTIONS.iter().copied().flatten().copied();
    functions.find_map(|(known, apply)| {
        (known == name && !matches!(apply(values), Unfit)).then_some(apply)
    })
}

/// Functions, each of values that match a pattern.
macro_rules! functions {
    ($($name:expr, $pattern:pat => $result:expr;)*) => {
        &[$(($name, |values| match *values { $pattern => $result, _ => Unfit })),*]
    };
}

/// Functions of a type, under their paths.
macro_rules! methods {
    ($type:ident $pattern:tt $values:tt $result:ident: $($name:ident)*) => {
        functions! { $(
            concat!(stringify!($type), "::", stringify!($name)), $pattern
                => $result($type::$name $values);
        )* }
    };
}

macro_rules! constants {
    ($type:ident $result:ident: $($name:ident)*) => {
        functions! { $(
            concat!(stringify!($type), "::", stringify!($name)), [] => $result($type::$name);
        )* }
    };
}

/// Operators; those of whole numbers stop a program that overflows, as in a development build.
macro_rules! operators {
    ($($name:literal $sign:tt $checked:ident;)*) => {
        functions! { $(
            $name, [F64(a), F64(b)] => F64(a $sign b);
            $name, [Vector(a), Vector(b)] => Vector(a $sign b);
            $name, [Vector(a), F64(b)] => Vector(a $sign b);
            $name, [F64(a), Vector(b)] => Vector(a $sign b);
            $name, [I32(a), I32(b)] => a.$checked(b).map_or(Stop, I32);
        )* }
    };
}

macro_rules! comparisons {
    ($($name:literal $sign:tt)*) => {
        functions! { $(
            $name, [F64(a), F64(b)] => Bool(a $sign b);
            $name, [I32(a), I32(b)] => Bool(a $sign b);
        )* }
    };
}

/// Functions and methods, both such as `f64::max`, fields such as `DVec3.x`, operators, casts such as
/// `as f64`, `if`; constants are functions of nothing.
pub static FUNCTIONS: &[&[(&str, Apply)]] = &[
    methods!(f64 [F64(a)] (a) F64: abs floor ceil round trunc fract signum sqrt cbrt recip sin cos
        tan asin acos atan sinh cosh tanh exp exp2 ln log10 log2 to_degrees to_radians),
    methods!(f64 [F64(a)] (a) Bool: is_nan is_finite is_sign_negative is_sign_positive),
    methods!(f64 [F64(a), F64(b)] (a, b) F64: min max powf atan2 hypot copysign midpoint),
    methods!(f64 [F64(a), I32(b)] (a, b) F64: powi),
    methods!(f64 [F64(a), F64(b), F64(c)] (a, b, c) F64: mul_add),
    methods!(DVec3 [Vector(a)] (a) Vector: abs floor ceil round trunc fract signum sqrt sin cos exp
        recip normalize normalize_or_zero),
    methods!(DVec3 [Vector(a)] (a) F64: length length_squared length_recip max_element min_element
        element_sum element_product),
    methods!(DVec3 [Vector(a), Vector(b)] (a, b) Vector: min max cross reflect project_onto
        reject_from midpoint),
    methods!(DVec3 [Vector(a), Vector(b)] (a, b) F64: dot distance distance_squared angle_between),
    methods!(DVec3 [Vector(a), F64(b)] (a, b) Vector: powf with_x with_y with_z),
    methods!(DVec3 [Vector(a), Vector(b), F64(c)] (a, b, c) Vector: lerp),
    methods!(DVec3 [Vector(a), Vector(b), Vector(c)] (a, b, c) Vector: clamp mul_add),
    constants!(f64 F64: MAX MIN NAN EPSILON INFINITY NEG_INFINITY),
    constants!(DVec3 Vector: ZERO ONE NEG_ONE X Y Z NEG_X NEG_Y NEG_Z),
    operators! {
        "+" + checked_add;
        "-" - checked_sub;
        "*" * checked_mul;
        "/" / checked_div;
    },
    comparisons! { "==" == "!=" != "<" < ">" > "<=" <= ">=" >= },
    functions! {
        "if", [Bool(_), a, b] => if a.is_like(&b) { b } else { Unfit };
        "&&", [Bool(_), Bool(b)] => Bool(b);
        "||", [Bool(_), Bool(b)] => Bool(b);
        "!", [Bool(a)] => Bool(!a);
        "-", [F64(a)] => F64(-a);
        "-", [Vector(a)] => Vector(-a);
        "-", [I32(a)] => a.checked_neg().map_or(Stop, I32);
        "%", [F64(a), F64(b)] => F64(remainder(a, b));
        "%", [I32(a), I32(b)] => a.checked_rem(b).map_or(Stop, I32);
        "f64::rem_euclid", [F64(a), F64(b)] => F64((remainder(a, b), a.rem_euclid(b)).1);
        "i32::rem_euclid", [I32(a), I32(b)] => a.checked_rem_euclid(b).map_or(Stop, I32);
        "f64::clamp", [F64(a), F64(min), F64(max)] => {
            if min <= max { F64(a.clamp(min, max)) } else { Stop }
        };
        "as f64", [F64(a)] => F64(a);
        "as f64", [I32(a)] => F64(a.into());
        "as i32", [F64(a)] => I32(a as i32);
        "as i32", [I32(a)] => I32(a);
        "as i32", [Bool(a)] => I32(a.into());
        "f64::from", [I32(a)] => F64(a.into());
        "f64::from", [Bool(a)] => F64(a.into());
        "DVec3::new", [F64(x), F64(y), F64(z)] => Vector(DVec3::new(x, y, z));
        "DVec3::splat", [F64(a)] => Vector(DVec3::splat(a));
        "DVec3::from", [Array(a)] => Vector(a.into());
        "[…]", [F64(x), F64(y), F64(z)] => Array([x, y, z]);
        "[0]", [Array([a, _, _])] => F64(a);
        "[1]", [Array([_, a, _])] => F64(a);
        "[2]", [Array([_, _, a])] => F64(a);
        "[0]", [Vector(a)] => F64(a.x);
        "[1]", [Vector(a)] => F64(a.y);
        "[2]", [Vector(a)] => F64(a.z);
        "DVec3.x", [Vector(a)] => F64(a.x);
        "DVec3.y", [Vector(a)] => F64(a.y);
        "DVec3.z", [Vector(a)] => F64(a.z);
        "std::f64::consts::PI", [] => F64(consts::PI);
        "std::f64::consts::TAU", [] => F64(consts::TAU);
    },
];

/// Remainder of a division, which takes long where the quotient is large.
fn remainder(a: f64, b: f64) -> f64 {
    if 1e15 * b.abs() < a.abs() {
        spend(40);
    }
    a % b
}
