use crate::expressions::node::{Function, spend};
use crate::expressions::steps::step04_diffuse::Attenuation;
use crate::expressions::value::{Typed, Value};
use glam::DVec3;
use std::sync::LazyLock;

const OVERFLOW: &str = "Here your program would stop: the result is beyond its type.";
const DIVISION: &str = "Here your program would stop: it divides by 0, or beyond its type.";
const CLAMP: &str = "Here your program would stop: the lower limit is above the upper.";

/// The functions, operators, constants (functions of nothing) and fields that a line may use: a
/// name such as `f64::max`, `DVec3.x`, `+` or `as f64`, what it takes and gives, what it does.
pub static FUNCTIONS: LazyLock<Vec<Function>> = LazyLock::new(|| {
    let mut rows = vec![];
    add_numbers(&mut rows);
    add_whole_numbers(&mut rows);
    add_vectors(&mut rows);
    add_casts(&mut rows);
    rows
});

/// A function of Rust as a row of the table.
trait Row {
    fn row(self, name: &'static str) -> Function;
}

macro_rules! row {
    ($($type:ident $index:literal),*) => {
        impl<$($type: Typed + 'static,)* R: Typed + 'static> Row for fn($($type),*) -> R {
            fn row(self, name: &'static str) -> Function {
                Function {
                    name,
                    takes: vec![$($type::kind()),*],
                    gives: R::kind(),
                    apply: Box::new(move |_values: &[Value]| {
                        self($($type::unpack(&_values[$index])),*).pack()
                    }),
                }
            }
        }
    };
}
row!();
row!(A 0);
row!(A 0, B 1);
row!(A 0, B 1, C 2);

/// Adds functions under names of their own.
macro_rules! add {
    ($rows:ident: $($name:expr, $signature:ty, $function:expr;)*) => {
        $($rows.push(Row::row($function as $signature, $name));)*
    };
}

/// Adds methods of a type under the names that they have there.
macro_rules! add_methods {
    ($rows:ident: $type:ident, $signature:ty: $($name:ident)*) => {
        add! { $rows: $(
            concat!(stringify!($type), "::", stringify!($name)), $signature, $type::$name;
        )* }
    };
}

/// Adds constants of a type under the names that they have there.
macro_rules! add_constants {
    ($rows:ident: $type:ident: $($name:ident)*) => {
        add! { $rows: $(
            concat!(stringify!($type), "::", stringify!($name)), fn() -> _, || $type::$name;
        )* }
    };
}

macro_rules! add_comparisons {
    ($rows:ident: $($type:ty),*) => {
        $(add! { $rows:
            "==", fn(_, _) -> _, |a: $type, b: $type| a == b;
            "!=", fn(_, _) -> _, |a: $type, b: $type| a != b;
            "<", fn(_, _) -> _, |a: $type, b: $type| a < b;
            ">", fn(_, _) -> _, |a: $type, b: $type| a > b;
            "<=", fn(_, _) -> _, |a: $type, b: $type| a <= b;
            ">=", fn(_, _) -> _, |a: $type, b: $type| a >= b;
        })*
    };
}

fn add_numbers(rows: &mut Vec<Function>) {
    add_methods!(rows: f64, fn(_) -> _: abs floor ceil round trunc fract signum sqrt cbrt recip sin
        cos tan asin acos atan sinh cosh tanh exp exp2 exp_m1 ln log10 log2 ln_1p to_degrees
        to_radians is_nan is_finite is_sign_negative is_sign_positive);
    add_methods!(rows: f64, fn(_, _) -> _: min max powf powi atan2 hypot copysign midpoint);
    add_methods!(rows: f64, fn(_, _, _) -> _: mul_add);
    add_comparisons!(rows: f64, i32, u32, u64, bool);
    add_constants!(rows: f64: MAX MIN NAN EPSILON INFINITY NEG_INFINITY);
    add_constants!(rows: i32: MAX MIN);
    add_constants!(rows: u32: MAX);
    add! { rows:
        "%", fn(_, _) -> _, remainder;
        "-", fn(_) -> f64, |a: f64| -a;
        "-", fn(_) -> _, |a: i32| a.checked_neg().ok_or(OVERFLOW);
        "!", fn(_) -> bool, |a: bool| !a;
        "f64::rem_euclid", fn(_, _) -> _, |a, b| (remainder(a, b), a.rem_euclid(b)).1;
        "f64::clamp", fn(_, _, _) -> _, |a: f64, min: f64, max: f64| {
            if min <= max { Ok(a.clamp(min, max)) } else { Err(CLAMP) }
        };
        "f64::from", fn(_) -> f64, |a: f64| a;
        "f64::from", fn(_) -> _, |a: i32| f64::from(a);
        "f64::from", fn(_) -> _, |a: u32| f64::from(a);
        "f64::from", fn(_) -> _, |a: bool| f64::from(a);
        "i32::from", fn(_) -> _, |a: bool| i32::from(a);
        "u32::from", fn(_) -> _, |a: bool| u32::from(a);
        "std::f64::consts::PI", fn() -> _, || std::f64::consts::PI;
        "std::f64::consts::TAU", fn() -> _, || std::f64::consts::TAU;
        "std::f64::consts::SQRT_2", fn() -> _, || std::f64::consts::SQRT_2;
        "std::f64::consts::FRAC_PI_2", fn() -> _, || std::f64::consts::FRAC_PI_2;
    }
}

/// Remainder of a division, which takes time for the binary digits of the quotient.
fn remainder(a: f64, b: f64) -> f64 {
    let exponent = |number: f64| number.to_bits() >> 52 & 0x7ff;
    spend(2 + exponent(a).saturating_sub(exponent(b)) / 64);
    a % b
}

/// Adds whole numbers, which stop a program where they overflow, as in a development build.
fn add_whole_numbers(rows: &mut Vec<Function>) {
    macro_rules! add_whole {
        ($($type:ty, $name:literal;)*) => {
            $(add! { rows:
                "+", fn(_, _) -> _, |a: $type, b: $type| a.checked_add(b).ok_or(OVERFLOW);
                "-", fn(_, _) -> _, |a: $type, b: $type| a.checked_sub(b).ok_or(OVERFLOW);
                "*", fn(_, _) -> _, |a: $type, b: $type| a.checked_mul(b).ok_or(OVERFLOW);
                "/", fn(_, _) -> _, |a: $type, b: $type| a.checked_div(b).ok_or(DIVISION);
                "%", fn(_, _) -> _, |a: $type, b: $type| a.checked_rem(b).ok_or(DIVISION);
                concat!($name, "::min"), fn(_, _) -> _, |a: $type, b: $type| a.min(b);
                concat!($name, "::max"), fn(_, _) -> _, |a: $type, b: $type| a.max(b);
                concat!($name, "::pow"), fn(_, _) -> _, |a: $type, b: u32| {
                    a.checked_pow(b).ok_or(OVERFLOW)
                };
                concat!($name, "::clamp"), fn(_, _, _) -> _, |a: $type, min: $type, max: $type| {
                    if min <= max { Ok(a.clamp(min, max)) } else { Err(CLAMP) }
                };
            })*
        };
    }
    add_whole! { i32, "i32"; u32, "u32"; u64, "usize"; }
    add! { rows:
        "i32::abs", fn(_) -> _, |a: i32| a.checked_abs().ok_or(OVERFLOW);
        "i32::signum", fn(_) -> i32, i32::signum;
        "i32::rem_euclid", fn(_, _) -> _, |a: i32, b: i32| a.checked_rem_euclid(b).ok_or(DIVISION);
    }
}

fn add_vectors(rows: &mut Vec<Function>) {
    macro_rules! add_operators {
        ($($sign:literal $operator:tt)*) => {
            $(add! { rows:
                $sign, fn(_, _) -> f64, |a: f64, b: f64| a $operator b;
                $sign, fn(_, _) -> DVec3, |a: DVec3, b: DVec3| a $operator b;
                $sign, fn(_, _) -> DVec3, |a: DVec3, b: f64| a $operator b;
                $sign, fn(_, _) -> DVec3, |a: f64, b: DVec3| a $operator b;
            })*
        };
    }
    add_operators! { "+" + "-" - "*" * "/" / }
    add_methods!(rows: DVec3, fn(_) -> _: abs floor ceil round trunc fract signum sqrt sin cos exp
        exp2 ln log2 recip normalize normalize_or_zero length length_squared length_recip
        max_element min_element element_sum element_product is_normalized is_finite is_nan);
    add_methods!(rows: DVec3, fn(_, _) -> _: min max cross dot distance distance_squared
        angle_between reflect project_onto reject_from midpoint copysign with_x
        with_y with_z powf);
    add_methods!(rows: DVec3, fn(_, _, _) -> _: new lerp clamp mul_add);
    add! { rows:
        "==", fn(_, _) -> _, |a: DVec3, b: DVec3| a == b;
        "!=", fn(_, _) -> _, |a: DVec3, b: DVec3| a != b;
        "%", fn(_, _) -> _, remainders;
        "%", fn(_, _) -> _, |a, b: f64| remainders(a, DVec3::splat(b));
        "%", fn(_, _) -> _, |a: f64, b| remainders(DVec3::splat(a), b);
        "DVec3::rem_euclid", fn(_, _) -> _, |a, b| (remainders(a, b), a.rem_euclid(b)).1;
        "-", fn(_) -> DVec3, |a: DVec3| -a;
        "DVec3::splat", fn(_) -> _, DVec3::splat;
        "DVec3::from", fn(_) -> DVec3, |a: [f64; 3]| DVec3::from(a);
        "DVec3::from_array", fn(_) -> _, DVec3::from_array;
        "DVec3::to_array", fn(_) -> _, |a: DVec3| a.to_array();
        "DVec3.x", fn(_) -> _, |a: DVec3| a.x;
        "DVec3.y", fn(_) -> _, |a: DVec3| a.y;
        "DVec3.z", fn(_) -> _, |a: DVec3| a.z;
        "Attenuation.a", fn(_) -> _, |one: Attenuation| one.a;
        "Attenuation.b", fn(_) -> _, |one: Attenuation| one.b;
        "Attenuation.c", fn(_) -> _, |one: Attenuation| one.c;
        "Attenuation::divisor", fn(_, _) -> f64, |one: Attenuation, d: f64| one.divisor(d);
    }
    add_constants!(rows: DVec3: ZERO ONE NEG_ONE X Y Z NEG_X NEG_Y NEG_Z);
}

fn remainders(a: DVec3, b: DVec3) -> DVec3 {
    DVec3::new(remainder(a.x, b.x), remainder(a.y, b.y), remainder(a.z, b.z))
}

fn add_casts(rows: &mut Vec<Function>) {
    macro_rules! add_casts {
        ($($from:ty => $($to:ty, $name:literal)*;)*) => {
            $($(add! { rows: concat!("as ", $name), fn(_) -> $to, |a: $from| a as $to; })*)*
        };
    }
    add_casts! {
        f64 => f64, "f64" i32, "i32" u32, "u32" u64, "usize";
        i32 => f64, "f64" i32, "i32" u32, "u32" u64, "usize";
        u32 => f64, "f64" i32, "i32" u32, "u32" u64, "usize";
        u64 => f64, "f64" i32, "i32" u32, "u32" u64, "usize";
        bool => bool, "bool" i32, "i32" u32, "u32" u64, "usize";
    }
}
