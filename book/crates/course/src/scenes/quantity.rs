//! A table of the numbers in a scene: their names, their ranges, and where they are stored. The
//! page "A scene of your own" gets its controls and its addresses from this table. The same table
//! tells `check` which values to try.

use crate::{OwnScene, Step};
use glam::DVec3;
use step05_phong::Matte;

/// One number in a scene, such as a radius, or three numbers that belong together, such as the
/// coordinates of a position.
#[derive(Debug)]
pub struct Quantity {
    /// The name as it appears in a sentence, such as "the radius" in "the radius of the ground".
    pub name: &'static str,
    /// The kind of thing that has this quantity.
    pub owner: Owner,
    /// The values that a reader may type for the quantity in a step's code. None if the steps'
    /// scenes don't contain the quantity.
    pub typed: Option<TypedRange>,
    /// The quantity's one number or three numbers.
    pub scalars: &'static [Scalar],
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

/// The values that a reader may type for a quantity in a step's code.
#[derive(Clone, Copy, Debug)]
pub struct TypedRange {
    /// The first step whose code contains the quantity.
    pub first_step: Step,
    /// The smallest and the largest value that somebody may plausibly type.
    pub range: [i32; 2],
    /// How many increments make 1, such as 100 for values with two decimals.
    pub steps_per_unit: i32,
}

/// A single number in a scene, such as a radius or the x of a position.
#[derive(Debug)]
pub struct Scalar {
    /// The number's mathematical symbol, or an empty string.
    pub symbol: &'static str,
    /// The label of the number's control. In the page's address, the number's name consists of the
    /// owner's name and this label.
    pub label: &'static str,
    /// The unit, such as °, or an empty string.
    pub unit: &'static str,
    /// The smallest and the largest value that a page offers for every owner except the ground.
    range: [f64; 2],
    /// The range if the owner is the ground, which is the largest sphere. None if the ground has
    /// the same range as all other owners.
    ground_range: Option<[f64; 2]>,
    /// How many increments of the page's control make 1.
    pub steps_per_unit: f64,
    /// Whether the number has an effect only in a scene with shadows and mirrors.
    pub needs_mirrors: bool,
    /// The axis, if this number is a coordinate of an object or a light. The channel, if this
    /// number belongs to the ambient light, or to the colour of an object or a light. None for all
    /// other numbers, which include the camera's coordinates and the colours of highlights. A
    /// page's handles and its colour field find their numbers by these components.
    pub component: Option<Component>,
    property: Property,
    /// The index of this number among the property's three numbers, such as the index of the axis
    /// or channel. 0 if the property is a single number.
    axis: usize,
}

/// A component of a position or of a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// The x coordinate, to the right.
    X,
    /// The y coordinate, upwards.
    Y,
    /// The z coordinate, towards the camera of the five steps.
    Z,
    /// The red channel.
    Red,
    /// The green channel.
    Green,
    /// The blue channel.
    Blue,
}

impl Component {
    /// The components of a position.
    pub const POSITION: [Self; 3] = [Self::X, Self::Y, Self::Z];
    /// The components of a colour.
    pub const COLOUR: [Self; 3] = [Self::Red, Self::Green, Self::Blue];
}

/// The index of the ground in the steps' list of objects. Scenes that are made from this list keep
/// the order of the objects.
pub const GROUND: usize = 1;

/// Which property of an [`OwnScene`] a number belongs to.
#[derive(Clone, Copy, Debug)]
enum Property {
    FieldOfView,
    CameraPosition,
    Target,
    Roll,
    AmbientLight,
    Centre,
    Radius,
    /// R_s, which has the same value in all channels.
    ObjectSpecular,
    Shininess,
    /// R_d and R_a, which are always equal.
    ObjectColour,
    MirrorPart,
    LightPosition,
    LightDiffuse,
    LightSpecular,
    Attenuation,
}

impl Scalar {
    /// The smallest and the largest value that a page offers for this number. `owner_index` is the
    /// index of the object or light that has the number. If the number belongs to the camera or to
    /// the whole scene, the index has no effect.
    pub fn range_for_owner(&self, owner_index: usize) -> [f64; 2] {
        self.ground_range.filter(|_| owner_index == GROUND).unwrap_or(self.range)
    }

    /// Reads the number from `own_scene`. `owner_index` is the index of the object or light that
    /// has the number.
    pub fn get(&self, own_scene: &OwnScene, owner_index: usize) -> f64 {
        let (scene, axis) = (&own_scene.scene, self.axis);
        match self.property {
            Property::FieldOfView => own_scene.fov_degrees,
            Property::CameraPosition => own_scene.position[axis],
            Property::Target => own_scene.target[axis],
            Property::Roll => own_scene.roll_degrees,
            Property::AmbientLight => scene.ambient_light[axis],
            Property::Centre => scene.objects[owner_index].sphere.centre[axis],
            Property::Radius => scene.objects[owner_index].sphere.radius,
            Property::ObjectSpecular => scene.objects[owner_index].material.specular.x,
            Property::Shininess => scene.objects[owner_index].material.shininess.into(),
            Property::ObjectColour => scene.objects[owner_index].material.matte.diffuse[axis],
            Property::MirrorPart => own_scene.mirror_parts[owner_index],
            Property::LightPosition => scene.lights[owner_index].point_light.position[axis],
            Property::LightDiffuse => scene.lights[owner_index].point_light.diffuse[axis],
            Property::LightSpecular => scene.lights[owner_index].specular[axis],
            Property::Attenuation => {
                let attenuation = scene.lights[owner_index].point_light.attenuation;
                [attenuation.a, attenuation.b, attenuation.c][axis]
            }
        }
    }

    /// Sets the number in `own_scene`. `owner_index` is the index of the object or light that has
    /// the number.
    pub fn set(&self, own_scene: &mut OwnScene, owner_index: usize, value: f64) {
        let (scene, axis) = (&mut own_scene.scene, self.axis);
        match self.property {
            Property::FieldOfView => own_scene.fov_degrees = value,
            Property::CameraPosition => own_scene.position[axis] = value,
            Property::Target => own_scene.target[axis] = value,
            Property::Roll => own_scene.roll_degrees = value,
            Property::AmbientLight => scene.ambient_light[axis] = value,
            Property::Centre => scene.objects[owner_index].sphere.centre[axis] = value,
            Property::Radius => scene.objects[owner_index].sphere.radius = value,
            Property::ObjectSpecular => {
                scene.objects[owner_index].material.specular = DVec3::splat(value)
            }
            Property::Shininess => scene.objects[owner_index].material.shininess = value as i32,
            Property::ObjectColour => {
                let matte = &mut scene.objects[owner_index].material.matte;
                let mut colour = matte.diffuse;
                colour[axis] = value;
                *matte = Matte::of(colour);
            }
            Property::MirrorPart => own_scene.mirror_parts[owner_index] = value,
            Property::LightPosition => scene.lights[owner_index].point_light.position[axis] = value,
            Property::LightDiffuse => scene.lights[owner_index].point_light.diffuse[axis] = value,
            Property::LightSpecular => scene.lights[owner_index].specular[axis] = value,
            Property::Attenuation => {
                let attenuation = &mut scene.lights[owner_index].point_light.attenuation;
                let abc = [&mut attenuation.a, &mut attenuation.b, &mut attenuation.c];
                *abc[axis] = value;
            }
        }
    }
}

/// All quantities in a scene, grouped by owner, in the order of the controls on the page.
pub static QUANTITIES: &[Quantity] = &[
    Quantity {
        name: "the field of view",
        owner: Owner::Camera,
        typed: None,
        scalars: &[Scalar {
            unit: "°",
            ..scalar(Property::FieldOfView, "θ", "field of view", [1.0, 179.0], 1.0)
        }],
    },
    Quantity {
        name: "the position",
        owner: Owner::Camera,
        typed: None,
        scalars: &xyz(
            Property::CameraPosition,
            ["position sideways", "position upwards", "position backwards"],
            CAMERA_RANGES,
        ),
    },
    Quantity {
        name: "the target",
        owner: Owner::Camera,
        typed: None,
        scalars: &xyz(
            Property::Target,
            ["target sideways", "target upwards", "target backwards"],
            CAMERA_RANGES,
        ),
    },
    Quantity {
        name: "the roll",
        owner: Owner::Camera,
        typed: None,
        scalars: &[Scalar {
            unit: "°",
            ..scalar(Property::Roll, "", "roll", [-180.0, 180.0], 1.0)
        }],
    },
    Quantity {
        name: "L_a",
        owner: Owner::Scene,
        typed: Some(LIGHT_COLOUR),
        scalars: &colour(Property::AmbientLight, 1.0),
    },
    Quantity {
        name: "the position",
        owner: Owner::Object,
        typed: Some(TypedRange { first_step: Step::Sphere, range: [-50, 50], steps_per_unit: 100 }),
        scalars: &with_ranges_for_ground(
            position(Property::Centre, [[-6.0, 6.0], [-3.0, 5.0], [-16.0, 6.0]]),
            [[-20.0, 20.0], [-60.0, 0.0], [-30.0, 10.0]],
        ),
    },
    Quantity {
        name: "the radius",
        owner: Owner::Object,
        typed: Some(TypedRange { first_step: Step::Sphere, range: [0, 60], steps_per_unit: 100 }),
        scalars: &with_ranges_for_ground(
            [scalar(Property::Radius, "r", "radius", [0.05, 3.0], 100.0)],
            [[10.0, 60.0]],
        ),
    },
    Quantity {
        name: "R_s",
        owner: Owner::Object,
        typed: Some(HIGHLIGHT_COLOUR),
        scalars: &[scalar(Property::ObjectSpecular, "Rₛ", "mirrored", [0.0, 1.0], 100.0)],
    },
    Quantity {
        name: "n",
        owner: Owner::Object,
        typed: Some(TypedRange { first_step: Step::Phong, range: [0, 1000], steps_per_unit: 1 }),
        scalars: &[scalar(Property::Shininess, "n", "shininess", [1.0, 300.0], 1.0)],
    },
    Quantity {
        name: "the colour",
        owner: Owner::Object,
        typed: Some(TypedRange { first_step: Step::Nearest, range: [0, 5], steps_per_unit: 100 }),
        scalars: &colour(Property::ObjectColour, 1.0),
    },
    Quantity {
        name: "k",
        owner: Owner::Object,
        typed: None,
        scalars: &[Scalar {
            needs_mirrors: true,
            ..scalar(Property::MirrorPart, "k", "mirror image", [0.0, 1.0], 100.0)
        }],
    },
    Quantity {
        name: "the position",
        owner: Owner::Light,
        typed: Some(TypedRange {
            first_step: Step::Diffuse,
            range: [-20, 20],
            steps_per_unit: 100,
        }),
        scalars: &position(Property::LightPosition, [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 6.0]]),
    },
    Quantity {
        name: "L_d",
        owner: Owner::Light,
        typed: Some(LIGHT_COLOUR),
        scalars: &colour(Property::LightDiffuse, 2.0),
    },
    Quantity {
        name: "L_s",
        owner: Owner::Light,
        typed: Some(HIGHLIGHT_COLOUR),
        scalars: &rgb(
            Property::LightSpecular,
            ["red in highlights", "green in highlights", "blue in highlights"],
            2.0,
        ),
    },
    Quantity {
        name: "(a, b, c)",
        owner: Owner::Light,
        typed: Some(TypedRange { first_step: Step::Diffuse, range: [0, 2], steps_per_unit: 1000 }),
        scalars: &with_numbered_axes([
            // The minimum is above 0, so that a + bd + cd² is never 0.
            scalar(Property::Attenuation, "a", "constant fading", [0.1, 2.0], 100.0),
            scalar(Property::Attenuation, "b", "linear fading", [0.0, 1.0], 1000.0),
            scalar(Property::Attenuation, "c", "quadratic fading", [0.0, 1.0], 1000.0),
        ]),
    },
];

const CAMERA_RANGES: [[f64; 2]; 3] = [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 12.0]];

const LIGHT_COLOUR: TypedRange =
    TypedRange { first_step: Step::Diffuse, range: [0, 5], steps_per_unit: 100 };
const HIGHLIGHT_COLOUR: TypedRange =
    TypedRange { first_step: Step::Phong, range: [0, 5], steps_per_unit: 100 };

/// Makes a number that has no unit, has the same range for every owner, and has an effect in every
/// scene.
const fn scalar(
    property: Property,
    symbol: &'static str,
    label: &'static str,
    range: [f64; 2],
    steps_per_unit: f64,
) -> Scalar {
    Scalar {
        symbol,
        label,
        unit: "",
        range,
        ground_range: None,
        steps_per_unit,
        needs_mirrors: false,
        component: None,
        property,
        axis: 0,
    }
}

/// The three coordinates of a position, in increments of 0.01.
const fn xyz(
    property: Property,
    [right, up, back]: [&'static str; 3],
    ranges: [[f64; 2]; 3],
) -> [Scalar; 3] {
    let [x, y, z] = ranges;
    with_numbered_axes([
        scalar(property, "x", right, x, 100.0),
        scalar(property, "y", up, y, 100.0),
        scalar(property, "z", back, z, 100.0),
    ])
}

/// The three coordinates of the position of an object or a light. [`Scalar::component`] says which
/// coordinate each number is.
const fn position(property: Property, ranges: [[f64; 2]; 3]) -> [Scalar; 3] {
    let [x, y, z] = xyz(property, ["sideways", "upwards", "towards you"], ranges);
    [
        Scalar { component: Some(Component::X), ..x },
        Scalar { component: Some(Component::Y), ..y },
        Scalar { component: Some(Component::Z), ..z },
    ]
}

/// The three channels of the colour of an object or a light. [`Scalar::component`] says which
/// channel each number is.
const fn colour(property: Property, max: f64) -> [Scalar; 3] {
    let [red, green, blue] = rgb(property, ["red", "green", "blue"], max);
    [
        Scalar { component: Some(Component::Red), ..red },
        Scalar { component: Some(Component::Green), ..green },
        Scalar { component: Some(Component::Blue), ..blue },
    ]
}

/// The three channels of a colour, each from 0 to `max` in increments of 0.01.
const fn rgb(property: Property, [red, green, blue]: [&'static str; 3], max: f64) -> [Scalar; 3] {
    let range = [0.0, max];
    with_numbered_axes([
        scalar(property, "", red, range, 100.0),
        scalar(property, "", green, range, 100.0),
        scalar(property, "", blue, range, 100.0),
    ])
}

/// Sets the axes of a property's three numbers to 0, 1 and 2.
const fn with_numbered_axes([x, y, z]: [Scalar; 3]) -> [Scalar; 3] {
    [x, Scalar { axis: 1, ..y }, Scalar { axis: 2, ..z }]
}

/// Sets the ranges that these numbers have if the owner is the ground.
const fn with_ranges_for_ground<const N: usize>(
    mut scalars: [Scalar; N],
    ranges: [[f64; 2]; N],
) -> [Scalar; N] {
    let mut k = 0;
    while k < N {
        scalars[k].ground_range = Some(ranges[k]);
        k += 1;
    }
    scalars
}

#[cfg(test)]
mod tests {
    use super::*;
    use step05_phong::scene;

    fn all_scalars() -> impl Iterator<Item = &'static Scalar> {
        QUANTITIES.iter().flat_map(|quantity| quantity.scalars)
    }

    #[test]
    fn number_that_is_set_is_read_again_and_no_other_changes() {
        for scalar in all_scalars() {
            let mut own_scene = OwnScene::new(scene());
            let mut expected: Vec<_> =
                all_scalars().map(|scalar| scalar.get(&own_scene, 1)).collect();
            let [min, max] = scalar.range;
            let value = if scalar.get(&own_scene, 1) == min { max } else { min };
            scalar.set(&mut own_scene, 1, value);
            let index = all_scalars()
                .position(|row| std::ptr::eq(row, scalar))
                .expect("the scalar is in the table");
            expected[index] = value;
            let values: Vec<_> = all_scalars().map(|scalar| scalar.get(&own_scene, 1)).collect();
            assert_eq!(values, expected, "{}", scalar.label);
        }
    }

    #[test]
    fn ground_has_ranges_of_its_own() {
        assert_eq!(scene().objects[GROUND].name, "ground");
        let is_radius = |scalar: &&Scalar| matches!(scalar.property, Property::Radius);
        let radius = all_scalars().find(is_radius).expect("the table has a radius");
        assert_eq!(
            [radius.range_for_owner(0), radius.range_for_owner(GROUND)],
            [[0.05, 3.0], [10.0, 60.0]]
        );
        // These numbers have the same range for all owners. For example, the light with the index
        // `GROUND` has the same range as the other lights, because the ground isn't a light.
        for scalar in all_scalars().filter(|scalar| scalar.ground_range.is_none()) {
            assert_eq!(scalar.range_for_owner(GROUND), scalar.range);
        }
    }

    #[test]
    fn colour_of_an_object_is_its_ambient_and_its_diffuse_reflectance() {
        let mut own_scene = OwnScene::new(scene());
        let red = all_scalars().find(|scalar| matches!(scalar.property, Property::ObjectColour));
        red.expect("the table has a colour").set(&mut own_scene, 0, 0.125);
        let matte = own_scene.scene.objects[0].material.matte;
        assert_eq!((matte.ambient.x, matte.diffuse.x), (0.125, 0.125));
    }
}
