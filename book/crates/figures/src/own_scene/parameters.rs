//! The parameters of the reader's own scene: switches, and numbers that describe the camera, the
//! ambient light, the spheres and the lights. By default, three spheres and one light are switched
//! off, and so are shadows and mirrors.

use crate::{Axis, Parameter, ParameterId, ParameterValues};
use course::examples::mirror::mirrors;
use course::examples::own_scene::{ball, lamp};
use course::{Component, LIGHT_NAMES, OwnScene, Owner, QUANTITIES, Scalar};
use std::sync::LazyLock;
use step05_phong::{OBJECTS, scene};

const MIRRORS: ParameterId = ParameterId::of("the way back", "shadows and mirrors");

/// The switch or number that a parameter sets.
#[derive(Clone, Copy)]
pub enum Target {
    /// Whether there are shadows and mirrors.
    Mirrors,
    /// Whether the scene has the object or light with this index.
    Presence(Owner, usize),
    /// A number that belongs to the camera, the scene, an object or a light. The index is that of
    /// the object or light, and 0 for the camera and the scene.
    Scalar(&'static Scalar, usize),
}

/// All parameters, each with its target.
pub static PARAMETERS: LazyLock<Vec<(Target, Parameter)>> = LazyLock::new(|| {
    let own_scene = largest_scene();
    let mut parameters = vec![];
    parameters.extend(parameters_of_owner(&own_scene, Owner::Camera, 0, "camera"));
    parameters.extend(parameters_of_owner(&own_scene, Owner::Scene, 0, "ambient light"));
    parameters.push((Target::Mirrors, Parameter::switch(MIRRORS, "shadows and mirrors", false)));
    for (k, object) in own_scene.scene.objects.iter().enumerate() {
        let id = ParameterId::of(object.name, "in the scene");
        let presence = Parameter::switch(id, "in the scene", k < OBJECTS.len());
        parameters.push((Target::Presence(Owner::Object, k), presence));
        parameters.extend(parameters_of_owner(&own_scene, Owner::Object, k, object.name));
    }
    let light_names = LIGHT_NAMES.iter().map(|light| light.name).chain(["third light"]);
    for (k, name) in light_names.enumerate() {
        let presence = Parameter::switch(ParameterId::of(name, "on"), "on", k < LIGHT_NAMES.len());
        parameters.push((Target::Presence(Owner::Light, k), presence));
        parameters.extend(parameters_of_owner(&own_scene, Owner::Light, k, name));
    }
    parameters
});

/// Returns a parameter and its target for each number that belongs to `owner`. If the owner is an
/// object or a light, `k` is the owner's index. The parameters' ids contain `owner_name`.
fn parameters_of_owner(
    own_scene: &OwnScene,
    owner: Owner,
    k: usize,
    owner_name: &'static str,
) -> impl Iterator<Item = (Target, Parameter)> {
    let quantities = QUANTITIES.iter().filter(move |quantity| quantity.owner == owner);
    quantities.flat_map(|quantity| quantity.scalars).map(move |scalar| {
        let id = ParameterId::of(owner_name, scalar.label);
        let (range, default) = (scalar.range_for_owner(k), scalar.get(own_scene, k));
        let parameter = Parameter::number(id, scalar.label, default, range, scalar.steps_per_unit)
            .with_symbol(scalar.symbol)
            .with_unit(scalar.unit);
        let axis = match scalar.component {
            Some(Component::X) => Some(Axis::Right),
            Some(Component::Y) => Some(Axis::Up),
            _ => None,
        };
        let has_control: fn(&Parameter, &ParameterValues) -> bool = match scalar.needs_mirrors {
            true => |_, values| values.is_on(MIRRORS),
            false => |_, _| true,
        };
        (Target::Scalar(scalar, k), Parameter { axis, has_control, ..parameter })
    })
}

/// Finds the parameters for three components of an object's position or colour. Returns None if the
/// object has no parameter for one of these components.
pub fn component_ids(object: &str, components: [Component; 3]) -> Option<[ParameterId; 3]> {
    let find = |component| {
        let mut ids = PARAMETERS.iter().filter_map(|(target, parameter)| match target {
            Target::Scalar(scalar, _) if scalar.component == Some(component) => Some(parameter.id),
            _ => None,
        });
        ids.find(|id| id.object() == Some(object))
    };
    let [first, second, third] = components.map(find);
    Some([first?, second?, third?])
}

/// The scene with these values, without the objects and lights that are switched off.
pub fn own_scene(values: &ParameterValues) -> OwnScene {
    let mut own_scene = scene_including_what_is_off(values);
    // Goes from last to first, because removing an object or a light changes all later indices.
    for (target, parameter) in PARAMETERS.iter().rev() {
        match *target {
            Target::Presence(owner, k) if !values.is_on(parameter.id) => {
                if owner == Owner::Object {
                    own_scene.scene.objects.remove(k);
                    own_scene.mirror_parts.remove(k);
                } else {
                    own_scene.scene.lights.remove(k);
                }
            }
            Target::Presence(..) | Target::Mirrors | Target::Scalar(..) => {}
        }
    }
    own_scene
}

/// The scene with these values, including the objects and lights that are switched off.
pub fn scene_including_what_is_off(values: &ParameterValues) -> OwnScene {
    let mut own_scene = largest_scene();
    own_scene.has_shadows_and_mirrors = values.is_on(MIRRORS);
    for (target, parameter) in &*PARAMETERS {
        if let Target::Scalar(scalar, k) = *target {
            scalar.set(&mut own_scene, k, values[parameter.id]);
        }
    }
    own_scene
}

/// The scene of step 5, plus the spheres and the light that are off by default.
fn largest_scene() -> OwnScene {
    let mut scene = scene();
    scene.objects.extend([
        ball("tenth sphere", [1.25, -1.1, -5.0], 0.35, [0.45, 0.2, 0.6], 0.8, 80),
        ball("eleventh sphere", [-1.2, 1.6, -7.0], 0.4, [0.1, 0.3, 0.75], 0.6, 60),
        ball("twelfth sphere", [1.6, 1.7, -8.0], 0.45, [0.85, 0.15, 0.35], 0.3, 20),
    ]);
    scene.lights.push(lamp([0.3, 1.5, -5.0], [0.9, 0.3, 0.6], [1.0, 0.6, 0.8], [0.6, 0.0, 0.1]));
    let default_parts = mirrors().objects.into_iter().map(|object| object.material.k);
    let mirror_parts = default_parts.chain([0.5, 0.3, 0.1]).collect();
    OwnScene { mirror_parts, ..OwnScene::new(scene) }
}
