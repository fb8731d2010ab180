use crate::expressions::steps::step04_diffuse::Attenuation;
use crate::expressions::value::Value;
use course::Kind;
use glam::DVec3;

/// A row of the table: a name, what it may be called with, and what it does.
///
/// A name has parentheses where it is called, and a point before it where it belongs to a
/// value. Of each word in the second part, the last letter is the kind of the result: number,
/// whole number, vector, truth or attenuation.
type Function = (&'static str, &'static str, Apply);

/// Computes a result from up to three values, packed into vectors.
pub type Apply = fn([DVec3; 3]) -> DVec3;

/// Methods that take and give what their types say, and are called as in Rust.
macro_rules! methods {
    ($types:literal: $($name:ident)*; $apply:ident) => {
        &[$((concat!(".", stringify!($name), "()"), $types, $apply!($name))),*]
    };
}
macro_rules! one_number {
    ($name:ident) => {
        |[a, ..]| DVec3::splat(a.x.$name())
    };
}
macro_rules! two_numbers {
    ($name:ident) => {
        |[a, b, _]| DVec3::splat(a.x.$name(b.x))
    };
}
macro_rules! one_vector {
    ($name:ident) => {
        |[a, ..]| a.$name()
    };
}
macro_rules! two_vectors {
    ($name:ident) => {
        |[a, b, _]| a.$name(b)
    };
}
macro_rules! number_from_vector {
    ($name:ident) => {
        |[a, ..]| DVec3::splat(a.$name())
    };
}
macro_rules! number_from_vectors {
    ($name:ident) => {
        |[a, b, _]| DVec3::splat(a.$name(b))
    };
}

const TABLE: [&[Function]; 9] = [
    OPERATORS,
    CONSTANTS,
    MIXED,
    methods!("nn": abs floor ceil round trunc fract signum sqrt cbrt recip sin cos tan asin
        acos atan exp ln log10 log2 to_degrees to_radians; one_number),
    methods!("nnn": min max powf atan2 hypot rem_euclid copysign; two_numbers),
    methods!("vv": abs floor ceil round trunc fract signum sqrt sin cos exp recip normalize
        normalize_or_zero; one_vector),
    methods!("vvv": min max cross rem_euclid reflect project_onto reject_from; two_vectors),
    methods!("vn": length length_squared length_recip max_element min_element element_sum
        element_product; number_from_vector),
    methods!("vvn": dot distance distance_squared angle_between; number_from_vectors),
];

const OPERATORS: &[Function] = &[
    ("||", "ttt", |[a, b, _]| a.max(b)),
    ("&&", "ttt", |[a, b, _]| a.min(b)),
    ("==", "nnt vvt wwt ttt", |[a, b, _]| pack_bool(a == b)),
    ("!=", "nnt vvt wwt ttt", |[a, b, _]| pack_bool(a != b)),
    ("<=", "nnt wwt", |[a, b, _]| pack_bool(a.x <= b.x)),
    (">=", "nnt wwt", |[a, b, _]| pack_bool(a.x >= b.x)),
    ("<", "nnt wwt", |[a, b, _]| pack_bool(a.x < b.x)),
    (">", "nnt wwt", |[a, b, _]| pack_bool(a.x > b.x)),
    ("+", "nnn nvv vnv vvv", |[a, b, _]| a + b),
    ("-", "nnn nvv vnv vvv", |[a, b, _]| a - b),
    ("*", "nnn nvv vnv vvv", |[a, b, _]| a * b),
    ("/", "nnn nvv vnv vvv", |[a, b, _]| a / b),
    ("%", "nnn nvv vnv vvv", |[a, b, _]| a % b),
    // Whole numbers as in a release build: they wrap. What is divided by 0 is 0.
    ("+", "www", |[a, b, _]| pack_i32(unpack_i32(a).wrapping_add(unpack_i32(b)))),
    ("-", "www", |[a, b, _]| pack_i32(unpack_i32(a).wrapping_sub(unpack_i32(b)))),
    ("*", "www", |[a, b, _]| pack_i32(unpack_i32(a).wrapping_mul(unpack_i32(b)))),
    ("/", "www", |[a, b, _]| pack_i32(unpack_i32(a).checked_div(unpack_i32(b)).unwrap_or(0))),
    ("%", "www", |[a, b, _]| pack_i32(unpack_i32(a).checked_rem(unpack_i32(b)).unwrap_or(0))),
    // Unary operators, by the names that the parser has for them.
    ("-value", "nn vv ww", |[a, ..]| -a),
    ("!value", "tt", |[a, ..]| 1.0 - a),
    ("as f64", "nn wn", |[a, ..]| a),
    ("as i32", "nw ww tw", |[a, ..]| pack_i32(unpack_i32(a))),
];

const CONSTANTS: &[Function] = &[
    ("true", "t", |_| DVec3::ONE),
    ("false", "t", |_| DVec3::ZERO),
    ("DVec3::ZERO", "v", |_| DVec3::ZERO),
    ("DVec3::ONE", "v", |_| DVec3::ONE),
    ("DVec3::NEG_ONE", "v", |_| DVec3::NEG_ONE),
    ("DVec3::X", "v", |_| DVec3::X),
    ("DVec3::Y", "v", |_| DVec3::Y),
    ("DVec3::Z", "v", |_| DVec3::Z),
    ("DVec3::NEG_X", "v", |_| DVec3::NEG_X),
    ("DVec3::NEG_Y", "v", |_| DVec3::NEG_Y),
    ("DVec3::NEG_Z", "v", |_| DVec3::NEG_Z),
    ("f64::MAX", "n", |_| DVec3::MAX),
    ("f64::EPSILON", "n", |_| DVec3::splat(f64::EPSILON)),
    ("f64::INFINITY", "n", |_| DVec3::INFINITY),
    ("std::f64::consts::PI", "n", |_| DVec3::splat(std::f64::consts::PI)),
    ("std::f64::consts::TAU", "n", |_| DVec3::splat(std::f64::consts::TAU)),
];

const MIXED: &[Function] = &[
    (".divisor()", "ann", |[a, d, _]| DVec3::splat(Attenuation::unpack(a).divisor(d.x))),
    (".a", "an", |[a, ..]| DVec3::splat(a.x)),
    (".b", "an", |[a, ..]| DVec3::splat(a.y)),
    (".c", "an", |[a, ..]| DVec3::splat(a.z)),
    ("DVec3::new()", "nnnv", |[a, b, c]| DVec3::new(a.x, b.x, c.x)),
    ("DVec3::splat()", "nv", |[a, ..]| a),
    ("f64::from()", "nn wn tn", |[a, ..]| a),
    (".x", "vn", |[a, ..]| DVec3::splat(a.x)),
    (".y", "vn", |[a, ..]| DVec3::splat(a.y)),
    (".z", "vn", |[a, ..]| DVec3::splat(a.z)),
    (".with_x()", "vnv", |[a, b, _]| a.with_x(b.x)),
    (".with_y()", "vnv", |[a, b, _]| a.with_y(b.x)),
    (".with_z()", "vnv", |[a, b, _]| a.with_z(b.x)),
    (".powi()", "nwn", |[a, b, _]| DVec3::splat(a.x.powi(unpack_i32(b)))),
    (".powf()", "vnv", |[a, b, _]| a.powf(b.x)),
    (".lerp()", "vvnv", |[a, b, c]| a.lerp(b, c.x)),
    (".clamp()", "nnnn", |[a, b, c]| DVec3::splat(clamp_or_nan(a.x, b.x, c.x))),
    (".clamp()", "vvvv", |[a, b, c]| a.clamp(b, c)),
    (".mul_add()", "nnnn", |[a, b, c]| DVec3::splat(a.x.mul_add(b.x, c.x))),
    (".abs()", "ww", |[a, ..]| pack_i32(unpack_i32(a).wrapping_abs())),
    (".signum()", "ww", |[a, ..]| pack_i32(unpack_i32(a).signum())),
    (".min()", "www", |[a, b, _]| a.min(b)),
    (".max()", "www", |[a, b, _]| a.max(b)),
    (".pow()", "www", |[a, b, _]| pack_i32(unpack_i32(a).wrapping_pow(unpack_i32(b) as u32))),
];

/// Rust's clamp, but no number where that panics.
fn clamp_or_nan(number: f64, min: f64, max: f64) -> f64 {
    if min <= max { number.clamp(min, max) } else { f64::NAN }
}

fn pack_bool(is_true: bool) -> DVec3 {
    DVec3::splat(is_true.into())
}

fn pack_i32(number: i32) -> DVec3 {
    DVec3::splat(number.into())
}

fn unpack_i32(value: DVec3) -> i32 {
    value.x as i32
}

/// The names that begin with `prefix`.
pub fn function_names_with_prefix(prefix: &str) -> impl Iterator<Item = &'static str> {
    let names = TABLE.into_iter().flatten().map(|(name, ..)| *name);
    names.filter(move |name| name.starts_with(prefix))
}

/// The ways to call `name`: the kinds of what it takes, that of its result, what it does.
pub fn signatures_of(name: &str) -> impl Iterator<Item = (Vec<Kind>, Kind, Apply)> {
    let rows = TABLE.into_iter().flatten().filter(move |row| row.0 == name);
    rows.flat_map(|(_, types, apply)| {
        types.split(' ').map(|letters| {
            let mut kinds: Vec<_> = letters.chars().map(kind_from_letter).collect();
            let result = kinds.pop().unwrap_or(Kind::Number);
            (kinds, result, *apply)
        })
    })
}

fn kind_from_letter(letter: char) -> Kind {
    match letter {
        'n' => Kind::Number,
        'w' => Kind::Whole,
        'v' => Kind::Vector,
        'a' => Kind::Attenuation,
        't' => Kind::Truth,
        _ => unreachable!("{letter} is no kind"),
    }
}
