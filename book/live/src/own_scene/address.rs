//! Values as the part of an address that keeps a scene: those that differ from the
//! defaults, such as
//! `red-sphere-radius:2,camera-field-of-view:45`.

use crate::{Live, Parameter};

/// The address of these values.
pub fn format_address(parameters: &[Parameter], values: &[f64]) -> String {
    let pairs = parameters.iter().zip(values).filter(|(parameter, value)| {
        has_name(parameter) && parameter.default != **value
    });
    let parts =
        pairs.map(|(parameter, value)| format!("{}:{value}", name(parameter)));
    parts.collect::<Vec<_>>().join(",")
}

/// The values at an address, or a sentence that says what is wrong with it.
pub fn parse_address(live: &Live, address: &str) -> Result<Vec<f64>, String> {
    let mut values = live.default_values();
    for part in address.split(',').filter(|part| !part.is_empty()) {
        let (key, value) = part.split_once(':').unwrap_or((part, ""));
        // The sentence repeats only the beginning of a long address.
        let [key, value] =
            [key, value].map(|text| text.chars().take(40).collect::<String>());
        let is_key =
            |parameter: &Parameter| has_name(parameter) && name(parameter) == key;
        let index = live.parameters.iter().position(is_key).ok_or_else(|| {
            format!("The address speaks of “{key}”, and nothing here is called so.")
        })?;
        let [min, max] = live.parameters[index].range;
        values[index] = match value.parse() {
            Ok(number) if (min..=max).contains(&number) => number,
            _ => {
                return Err(format!(
                    "The address says “{value}” for {key}; allowed are {min} to {max}."
                ));
            }
        };
    }
    live.nearest_allowed(&values)
        .ok_or("There is nothing to show at this address.".into())
}

/// Whether an address may hold the parameter: those of an object, a light or the camera.
fn has_name(parameter: &Parameter) -> bool {
    !parameter.group.is_empty()
}

/// The name of a parameter in an address.
fn name(parameter: &Parameter) -> String {
    format!("{} {}", parameter.group, parameter.words).replace(' ', "-")
}
