//! The one table of a scene's numbers. From it come the controls and addresses of the page
//! "A scene of your own", and the numbers that `check` looks for.

use crate::{OwnScene, Step};
use glam::DVec3;
use step05_phong::{Attenuation, Matte};

/// One number of a scene or three: a radius, a position, a colour.
pub struct Quantity {
    /// The name in a sentence, before "of" and its owner.
    pub name: &'static str,
    /// The kind of thing that has it.
    pub owner: Owner,
    /// What a reader of the steps types, if they have it.
    pub typed: Option<Typed>,
    /// The one number or the three.
    pub numbers: &'static [Number],
    /// The ranges of these numbers for the ground, the largest sphere, where they differ.
    pub ground_ranges: Option<&'static [[f64; 2]]>,
    /// Whether it is seen only with shadows and mirrors.
    pub needs_mirrors: bool,
    /// Reads that of owner k, from 0; one number comes three times.
    pub get: fn(&OwnScene, usize) -> [f64; 3],
    /// Changes it; one number comes three times.
    pub set: fn(&mut OwnScene, usize, [f64; 3]),
}

/// A kind of thing that has quantities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// The camera.
    Camera,
    /// The scene as a whole.
    Scene,
    /// An object.
    Object,
    /// A light.
    Light,
}

/// What a reader types of a quantity.
#[derive(Clone, Copy)]
pub struct Typed {
    /// The first step that has it.
    pub since: Step,
    /// The smallest and the largest number that somebody may have typed, wrong ones too.
    pub range: [i32; 2],
    /// The number of such numbers from one whole number to the next.
    pub steps_per_unit: i32,
}

/// One number of a quantity, as a page has a control for it.
pub struct Number {
    /// The symbol, or nothing.
    pub symbol: &'static str,
    /// The name in words; with that of its owner, the name in an address.
    pub words: &'static str,
    /// The unit, such as °, or nothing.
    pub unit: &'static str,
    /// The smallest and the largest value.
    pub range: [f64; 2],
    /// The number of values from one whole number to the next.
    pub steps_per_unit: f64,
}

/// What a number or three of them stand for.
trait FromNumbers {
    fn from_numbers(numbers: [f64; 3]) -> Self;
    fn to_numbers(&self) -> [f64; 3];
}

macro_rules! from_numbers {
    ($($type:ty: |$numbers:pat_param| $from:expr, |$value:ident| $to:expr;)*) => {$(
        impl FromNumbers for $type {
            fn from_numbers($numbers: [f64; 3]) -> Self { $from }
            fn to_numbers(&self) -> [f64; 3] { let $value = self; $to }
        }
    )*};
}

from_numbers! {
    f64: |[number, ..]| number, |number| [*number; 3];
    i32: |[number, ..]| number as i32, |number| [f64::from(*number); 3];
    DVec3: |numbers| numbers.into(), |vector| vector.to_array();
    Matte: |rgb| Matte::of(rgb.into()), |matte| matte.diffuse.into();
    Attenuation: |[a, b, c]| Attenuation { a, b, c }, |one| [one.a, one.b, one.c];
}

/// The place of a number or three in the scene of one's own.
macro_rules! place {
    ($own:ident, $k:ident, Camera, $field:ident) => { $own.$field };
    ($own:ident, $k:ident, Scene, $field:ident) => { $own.scene.$field };
    ($own:ident, $k:ident, Object, mirror_part) => { $own.mirror_parts[$k] };
    ($own:ident, $k:ident, Object, $($field:ident).+) => { $own.scene.objects[$k].$($field).+ };
    ($own:ident, $k:ident, Light, $($field:ident).+) => { $own.scene.lights[$k].$($field).+ };
}

/// A row of the table, whose last entry is the field of its owner.
macro_rules! quantity {
    ($owner:ident, $name:literal, $typed:expr, $numbers:expr, $($field:ident).+) => {
        Quantity {
            name: $name,
            owner: Owner::$owner,
            typed: $typed,
            numbers: &$numbers,
            ground_ranges: None,
            needs_mirrors: false,
            get: |own, _k| place!(own, _k, $owner, $($field).+).to_numbers(),
            set: |own, _k, numbers| {
                place!(own, _k, $owner, $($field).+) = FromNumbers::from_numbers(numbers);
            },
        }
    };
}

/// All quantities of a scene, those of one owner after each other.
pub const QUANTITIES: &[Quantity] = &[
    quantity!(Camera, "the field of view", None, [FIELD_OF_VIEW], fov_degrees),
    quantity!(Camera, "the position", None, POSITION_OF_CAMERA, position),
    quantity!(Camera, "the target", None, TARGET, target),
    quantity!(Camera, "the roll", None, [ROLL], roll_degrees),
    quantity!(Scene, "L_a", LAMP, rgb(RGB, 1.0), ambient_light),
    Quantity {
        ground_ranges: Some(&[[-20.0, 20.0], [-60.0, 0.0], [-30.0, 10.0]]),
        ..quantity!(Object, "the position", CENTRE, xyz(XYZ, CENTRE_RANGES), sphere.centre)
    },
    Quantity {
        ground_ranges: Some(&[[10.0, 60.0]]),
        ..quantity!(Object, "the radius", RADIUS, [RADIUS_NUMBER], sphere.radius)
    },
    quantity!(Object, "R_s", HIGHLIGHT, [REFLECTANCE], material.specular),
    quantity!(Object, "n", typed(Step::Phong, [0, 1000], 1), [SHININESS], material.shininess),
    quantity!(Object, "the colour", COLOUR, rgb(RGB, 1.0), material.matte),
    Quantity { needs_mirrors: true, ..quantity!(Object, "k", None, [MIRROR_PART], mirror_part) },
    quantity!(Light, "the position", LAMP_POSITION, xyz(XYZ, LAMP_RANGES), point_light.position),
    quantity!(Light, "L_d", LAMP, rgb(RGB, 2.0), point_light.diffuse),
    quantity!(Light, "L_s", HIGHLIGHT, rgb(RGB_OF_HIGHLIGHTS, 2.0), specular),
    quantity!(Light, "(a, b, c)", FADING, FADING_NUMBERS, point_light.attenuation),
];

const FIELD_OF_VIEW: Number =
    Number { unit: "°", ..number("θ", "field of view", [1.0, 179.0], 1.0) };
const CAMERA_RANGES: [[f64; 2]; 3] = [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 12.0]];
const POSITION_OF_CAMERA: [Number; 3] =
    xyz(["position sideways", "position upwards", "position backwards"], CAMERA_RANGES);
const TARGET: [Number; 3] =
    xyz(["target sideways", "target upwards", "target backwards"], CAMERA_RANGES);
const ROLL: Number = Number { unit: "°", ..number("", "roll", [-180.0, 180.0], 1.0) };
const MIRROR_PART: Number = number("k", "mirror image", [0.0, 1.0], 100.0);
const REFLECTANCE: Number = number("Rₛ", "mirrored", [0.0, 1.0], 100.0);
const SHININESS: Number = number("n", "shininess", [1.0, 300.0], 1.0);
const RADIUS_NUMBER: Number = number("r", "radius", [0.05, 3.0], 100.0);
const CENTRE_RANGES: [[f64; 2]; 3] = [[-6.0, 6.0], [-3.0, 5.0], [-16.0, 6.0]];
const LAMP_RANGES: [[f64; 2]; 3] = [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 6.0]];
/// The first is above 0, so that a + bd + cd² is.
const FADING_NUMBERS: [Number; 3] = [
    number("a", "constant fading", [0.1, 2.0], 100.0),
    number("b", "linear fading", [0.0, 1.0], 1000.0),
    number("c", "quadratic fading", [0.0, 1.0], 1000.0),
];

const XYZ: [&str; 3] = ["sideways", "upwards", "towards you"];
const RGB: [&str; 3] = ["red", "green", "blue"];
const RGB_OF_HIGHLIGHTS: [&str; 3] =
    ["red in highlights", "green in highlights", "blue in highlights"];

const CENTRE: Option<Typed> = typed(Step::Sphere, [-50, 50], 100);
const RADIUS: Option<Typed> = typed(Step::Sphere, [0, 60], 100);
const COLOUR: Option<Typed> = typed(Step::Nearest, [0, 5], 100);
const LAMP_POSITION: Option<Typed> = typed(Step::Diffuse, [-20, 20], 100);
const LAMP: Option<Typed> = typed(Step::Diffuse, [0, 5], 100);
const FADING: Option<Typed> = typed(Step::Diffuse, [0, 2], 1000);
const HIGHLIGHT: Option<Typed> = typed(Step::Phong, [0, 5], 100);

const fn typed(since: Step, range: [i32; 2], steps_per_unit: i32) -> Option<Typed> {
    Some(Typed { since, range, steps_per_unit })
}

const fn number(
    symbol: &'static str,
    words: &'static str,
    range: [f64; 2],
    steps_per_unit: f64,
) -> Number {
    Number { symbol, words, unit: "", range, steps_per_unit }
}

/// The three coordinates of a position, in hundredths.
const fn xyz([right, up, back]: [&'static str; 3], [x, y, z]: [[f64; 2]; 3]) -> [Number; 3] {
    [number("x", right, x, 100.0), number("y", up, y, 100.0), number("z", back, z, 100.0)]
}

/// The three channels of a colour, each from 0 to `max`, in hundredths.
const fn rgb([red, green, blue]: [&'static str; 3], max: f64) -> [Number; 3] {
    let range = [0.0, max];
    [number("", red, range, 100.0), number("", green, range, 100.0), number("", blue, range, 100.0)]
}
