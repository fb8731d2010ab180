//! A scene of the reader's own: the picture of step 5 with everything in it to set, and
//! its Rust.

mod parameters;

use crate::probe::SIZE;
use crate::{Figure, Handle, Mark, Output, Parameter, collect_numbers};
use course::{Owner, format_scene_program};
use glam::DVec3;
use parameters::{PARAMETERS, Target, own_scene};
use step05_phong::nearest;

/// The picture of the scene.
pub fn figure() -> Figure {
    // The switch of a sphere or light comes before its position.
    let handles = PARAMETERS.iter().enumerate().filter_map(|(k, (target, parameter))| {
        let Target::Presence(owner, _) = *target else { return None };
        let mark = if owner == Owner::Light { Mark::Light } else { Mark::Point };
        let camera_and_point = move |values: &[f64]| {
            let point = DVec3::from_slice(&values[k + 1..]);
            (values[k] == 1.0).then(|| (own_scene(values).camera(SIZE.x), point))
        };
        Some(Handle { mark, ..Handle::in_picture(parameter.group, k + 1, 0.0, camera_and_point) })
    });
    // The first parameter is the columns.
    let draw = |values: &[f64]| Output::Pixels(own_scene(values).picture(values[0]));
    Figure {
        parameters: PARAMETERS.iter().map(|(_, parameter)| parameter.clone()).collect(),
        handles: handles.collect(),
        numbers: |values| {
            collect_numbers([
                ("rust", format_scene_program(&own_scene(values))),
                ("address", format_address(values)),
            ])
        },
        group_at: |values, place| {
            let own = own_scene(values);
            let pixel = place - 0.5;
            let ray = own.camera(SIZE.x).ray(pixel.x, pixel.y);
            nearest(&own.scene.objects, &ray).map(|hit| hit.object.name)
        },
        is_allowed: |values| {
            let own = own_scene(values);
            own.position != own.target
        },
        ..Figure::new("own_scene", draw)
    }
}

/// The part of an address that keeps a scene: the values that differ from the defaults, such as
/// `red-sphere-radius:2,camera-field-of-view:45`.
fn format_address(values: &[f64]) -> String {
    let pairs = PARAMETERS.iter().map(|(_, parameter)| parameter).zip(values).skip(1);
    let different = pairs.filter(|(parameter, value)| parameter.default != **value);
    let parts = different.map(|(parameter, value)| format!("{}:{value}", key(parameter)));
    parts.collect::<Vec<_>>().join(",")
}

/// The values at an address, or a sentence that says what is wrong with it.
pub fn parse_address(figure: &Figure, address: &str) -> Result<Vec<f64>, String> {
    let mut values = figure.default_values();
    for part in address.split(',').filter(|part| !part.is_empty()) {
        let (name, value) = part.split_once(':').unwrap_or((part, ""));
        let mut parameters = figure.parameters.iter().enumerate().skip(1);
        let (index, parameter) = parameters.find(|(_, one)| key(one) == name).ok_or_else(|| {
            format!("The address speaks of “{name}”, and nothing here is called so.")
        })?;
        let [min, max] = parameter.range;
        let number = value.parse().ok().filter(|number| (min..=max).contains(number));
        values[index] = number.ok_or_else(|| {
            format!("The address says “{value}” for {name}; allowed are {min} to {max}.")
        })?;
    }
    figure.snap_if_allowed(&values).ok_or("There is nothing to show at this address.".into())
}

/// The name of a parameter in an address, which has all but the first, the columns.
fn key(parameter: &Parameter) -> String {
    format!("{} {}", parameter.group, parameter.words).replace(' ', "-")
}
