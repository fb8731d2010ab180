//! The part of an address that keeps a scene: the values that differ from the defaults,
//! such as `red-sphere-radius:2,camera-field-of-view:45`.

use super::parameters::PARAMETERS;
use crate::{Figure, Parameter};

/// The address of these values.
pub fn format_address(values: &[f64]) -> String {
    let pairs = PARAMETERS.iter().map(|(_, parameter)| parameter).zip(values);
    let different = pairs.filter(|(parameter, value)| parameter.default != **value);
    let parts = different.filter_map(|(one, value)| Some(format!("{}:{value}", key(one)?)));
    parts.collect::<Vec<_>>().join(",")
}

/// The values at an address, or a sentence that says what is wrong with it.
pub fn parse_address(figure: &Figure, address: &str) -> Result<Vec<f64>, String> {
    let mut values = figure.default_values();
    for part in address.split(',').filter(|part| !part.is_empty()) {
        let (name, value) = part.split_once(':').unwrap_or((part, ""));
        // The sentence repeats only the beginning of a long address.
        let [name, value] = [name, value].map(|text| text.chars().take(40).collect::<String>());
        let mut keys = figure.parameters.iter().map(key);
        let index = keys.position(|key| key.as_ref() == Some(&name));
        let index = index.ok_or_else(|| {
            format!("The address speaks of “{name}”, and nothing here is called so.")
        })?;
        let [min, max] = figure.parameters[index].range;
        let number = value.parse().ok().filter(|number| (min..=max).contains(number));
        values[index] = number.ok_or_else(|| {
            format!("The address says “{value}” for {name}; allowed are {min} to {max}.")
        })?;
    }
    figure.snap_if_allowed(&values).ok_or("There is nothing to show at this address.".into())
}

/// The name of a parameter in an address; None for the columns of the picture.
fn key(parameter: &Parameter) -> Option<String> {
    let key = format!("{} {}", parameter.group, parameter.words);
    (!parameter.group.is_empty()).then(|| key.replace(' ', "-"))
}
