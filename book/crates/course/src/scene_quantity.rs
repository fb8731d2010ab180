//! The one table of a scene's numbers. From it come the controls and addresses of the page
//! "A scene of your own", and the numbers that `check` looks for.

use crate::{OwnScene, Step};
use step05_phong::{Attenuation, Matte};

/// One number of a scene or three: a radius, a position, a colour.
pub struct Quantity {
    /// The name in a sentence, before "of" and its owner.
    pub name: &'static str,
    /// The kind of thing that has it.
    pub owner: Owner,
    /// The place in the steps where it is typed, if they have it.
    pub typed: Option<Typed>,
    /// Whether it is seen only with shadows and mirrors.
    pub needs_mirrors: bool,
    /// The one number or the three.
    pub numbers: &'static [Number],
    /// The ranges of these numbers for the ground, the largest sphere.
    pub ground_ranges: Option<&'static [[f64; 2]]>,
    /// Reads that of owner k, from 0; one number comes three times.
    pub get: fn(&OwnScene, usize) -> [f64; 3],
    /// Changes it; of one number, the first of the three counts.
    pub set: fn(&mut OwnScene, usize, [f64; 3]),
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

/// What a reader types of a quantity.
#[derive(Clone, Copy)]
pub struct Typed {
    /// The first step that has it.
    pub since: Step,
    /// The file in which it is typed, such as `step03_nearest/objects.rs`.
    pub file: &'static str,
    /// The smallest and the largest number that somebody may have typed, wrong ones too.
    pub range: [i32; 2],
    /// The number of such numbers from one whole number to the next.
    pub steps_per_unit: i32,
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

const fn number(
    symbol: &'static str,
    words: &'static str,
    range: [f64; 2],
    steps_per_unit: f64,
) -> Number {
    Number { symbol, words, unit: "", range, steps_per_unit }
}

const fn degrees(symbol: &'static str, words: &'static str, range: [f64; 2]) -> Number {
    Number { unit: "°", ..number(symbol, words, range, 1.0) }
}

/// What is typed in step 2 and again, for each object, in step 3.
const fn typed_shape(range: [i32; 2]) -> Option<Typed> {
    Some(Typed { since: Step::Sphere, file: OBJECTS_FILE, range, steps_per_unit: 100 })
}

const fn typed_light(range: [i32; 2], steps_per_unit: i32) -> Option<Typed> {
    let file = "step04_diffuse/scene.rs";
    Some(Typed { since: Step::Diffuse, file, range, steps_per_unit })
}

const fn typed_highlight(range: [i32; 2], steps_per_unit: i32) -> Option<Typed> {
    Some(Typed { since: Step::Phong, file: "step05_phong/scene.rs", range, steps_per_unit })
}

const OBJECTS_FILE: &str = "step03_nearest/objects.rs";

/// The three coordinates of a position, in hundredths.
const fn coordinates(words: [&'static str; 3], [x, y, z]: [[f64; 2]; 3]) -> [Number; 3] {
    let [right, up, back] = words;
    [number("x", right, x, 100.0), number("y", up, y, 100.0), number("z", back, z, 100.0)]
}

/// The three channels of a colour, each from 0 to `max`, in hundredths.
const fn channels([red, green, blue]: [&'static str; 3], max: f64) -> [Number; 3] {
    [
        number("", red, [0.0, max], 100.0),
        number("", green, [0.0, max], 100.0),
        number("", blue, [0.0, max], 100.0),
    ]
}

const RGB: [&str; 3] = ["red", "green", "blue"];

const XYZ: [&str; 3] = ["sideways", "upwards", "towards you"];

/// A colour of an object; most of the others differ from it in little.
const COLOUR: Quantity = Quantity {
    name: "the colour",
    owner: Owner::Object,
    typed: Some(Typed {
        since: Step::Nearest,
        file: OBJECTS_FILE,
        range: [0, 5],
        steps_per_unit: 100,
    }),
    needs_mirrors: false,
    numbers: &channels(RGB, 1.0),
    ground_ranges: None,
    get: |own, k| own.scene.objects[k].material.matte.diffuse.into(),
    set: |own, k, rgb| own.scene.objects[k].material.matte = Matte::of(rgb.into()),
};

/// A colour of a light; most quantities of lights differ from it in little.
const DIFFUSE: Quantity = Quantity {
    name: "L_d",
    owner: Owner::Light,
    typed: typed_light([0, 5], 100),
    numbers: &channels(RGB, 2.0),
    get: |own, k| own.scene.lights[k].point_light.diffuse.into(),
    set: |own, k, rgb| own.scene.lights[k].point_light.diffuse = rgb.into(),
    ..COLOUR
};

/// The camera's field of view, which nobody types: it is an option.
const FIELD_OF_VIEW: Quantity = Quantity {
    name: "the field of view",
    owner: Owner::Camera,
    typed: None,
    numbers: &[degrees("θ", "field of view", [1.0, 179.0])],
    get: |own, _| [own.fov_degrees; 3],
    set: |own, _, [fov, ..]| own.fov_degrees = fov,
    ..COLOUR
};

const CAMERA_RANGES: [[f64; 2]; 3] = [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 12.0]];

/// All quantities of a scene, those of one owner after each other.
pub const QUANTITIES: &[Quantity] = &[
    FIELD_OF_VIEW,
    Quantity {
        name: "the position",
        numbers: &coordinates(
            ["position sideways", "position upwards", "position backwards"],
            CAMERA_RANGES,
        ),
        get: |own, _| own.position.into(),
        set: |own, _, xyz| own.position = xyz.into(),
        ..FIELD_OF_VIEW
    },
    Quantity {
        name: "the target",
        numbers: &coordinates(
            ["target sideways", "target upwards", "target backwards"],
            CAMERA_RANGES,
        ),
        get: |own, _| own.target.into(),
        set: |own, _, xyz| own.target = xyz.into(),
        ..FIELD_OF_VIEW
    },
    Quantity {
        name: "the roll",
        numbers: &[degrees("", "roll", [-180.0, 180.0])],
        get: |own, _| [own.roll_degrees; 3],
        set: |own, _, [roll, ..]| own.roll_degrees = roll,
        ..FIELD_OF_VIEW
    },
    Quantity {
        name: "L_a",
        owner: Owner::Scene,
        numbers: &channels(RGB, 1.0),
        get: |own, _| own.scene.ambient_light.into(),
        set: |own, _, rgb| own.scene.ambient_light = rgb.into(),
        ..DIFFUSE
    },
    Quantity {
        name: "the position",
        typed: typed_shape([-50, 50]),
        numbers: &coordinates(XYZ, [[-6.0, 6.0], [-3.0, 5.0], [-16.0, 6.0]]),
        ground_ranges: Some(&[[-20.0, 20.0], [-60.0, 0.0], [-30.0, 10.0]]),
        get: |own, k| own.scene.objects[k].sphere.centre.into(),
        set: |own, k, xyz| own.scene.objects[k].sphere.centre = xyz.into(),
        ..COLOUR
    },
    Quantity {
        name: "the radius",
        typed: typed_shape([0, 60]),
        numbers: &[number("r", "radius", [0.05, 3.0], 100.0)],
        ground_ranges: Some(&[[10.0, 60.0]]),
        get: |own, k| [own.scene.objects[k].sphere.radius; 3],
        set: |own, k, [r, ..]| own.scene.objects[k].sphere.radius = r,
        ..COLOUR
    },
    Quantity {
        name: "R_s",
        typed: typed_highlight([0, 5], 100),
        numbers: &[number("Rₛ", "mirrored", [0.0, 1.0], 100.0)],
        get: |own, k| own.scene.objects[k].material.specular.into(),
        set: |own, k, [r_s, ..]| own.scene.objects[k].material.specular = [r_s; 3].into(),
        ..COLOUR
    },
    Quantity {
        name: "n",
        typed: typed_highlight([0, 1000], 1),
        numbers: &[number("n", "shininess", [1.0, 300.0], 1.0)],
        get: |own, k| [own.scene.objects[k].material.shininess.into(); 3],
        set: |own, k, [n, ..]| own.scene.objects[k].material.shininess = n as i32,
        ..COLOUR
    },
    COLOUR,
    Quantity {
        name: "k",
        typed: None,
        needs_mirrors: true,
        numbers: &[number("k", "mirror image", [0.0, 1.0], 100.0)],
        get: |own, k| [own.mirror_parts[k]; 3],
        set: |own, k, [part, ..]| own.mirror_parts[k] = part,
        ..COLOUR
    },
    Quantity {
        name: "the position",
        typed: typed_light([-20, 20], 100),
        numbers: &coordinates(XYZ, [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 6.0]]),
        get: |own, k| own.scene.lights[k].point_light.position.into(),
        set: |own, k, xyz| own.scene.lights[k].point_light.position = xyz.into(),
        ..DIFFUSE
    },
    DIFFUSE,
    Quantity {
        name: "L_s",
        typed: typed_highlight([0, 5], 100),
        numbers: &channels(["red in highlights", "green in highlights", "blue in highlights"], 2.0),
        get: |own, k| own.scene.lights[k].specular.into(),
        set: |own, k, rgb| own.scene.lights[k].specular = rgb.into(),
        ..DIFFUSE
    },
    Quantity {
        name: "(a, b, c)",
        typed: typed_light([0, 20], 1000),
        numbers: &[
            // Above 0, so that a + bd + cd² is.
            number("a", "constant fading", [0.1, 2.0], 100.0),
            number("b", "linear fading", [0.0, 1.0], 1000.0),
            number("c", "quadratic fading", [0.0, 1.0], 1000.0),
        ],
        get: |own, k| {
            let Attenuation { a, b, c } = own.scene.lights[k].point_light.attenuation;
            [a, b, c]
        },
        set: |own, k, [a, b, c]| {
            own.scene.lights[k].point_light.attenuation = Attenuation { a, b, c };
        },
        ..DIFFUSE
    },
];
