//! Values as a part of an address: those that are not as printed, such as
//! `red-sphere-radius:2,camera-field-of-view:45`.

use crate::{Knob, Live};

/// The values of things that are not as printed.
pub fn address(knobs: &[Knob], values: &[f64]) -> String {
    let changed = knobs
        .iter()
        .zip(values)
        .filter(|(knob, value)| !knob.group.is_empty() && knob.value != **value)
        .map(|(knob, value)| format!("{}:{value}", name(knob)));
    changed.collect::<Vec<_>>().join(",")
}

/// The values at an address, or a sentence that says what is wrong with it.
pub fn opened(live: &Live, address: &str) -> Result<Vec<f64>, String> {
    let mut values = live.values();
    for part in address.split(',').filter(|part| !part.is_empty()) {
        let (which, value) = part.split_once(':').unwrap_or((part, ""));
        // They may be long.
        let [which, value] =
            [which, value].map(|text| text.chars().take(40).collect::<String>());
        let known = |knob: &Knob| !knob.group.is_empty() && name(knob) == which;
        let k = live.knobs.iter().position(known).ok_or_else(|| {
            format!(
                "The address speaks of “{which}”, and nothing here is called so."
            )
        })?;
        let [min, max] = live.knobs[k].range;
        values[k] = match value.parse() {
            Ok(number) if (min..=max).contains(&number) => number,
            _ => {
                return Err(format!(
                    "The address says “{value}” for {which}; allowed are {min} to {max}."
                ));
            }
        };
    }
    live.allowed(&values).ok_or("There is nothing to show at this address.".into())
}

/// What a number of a thing is called in an address.
fn name(knob: &Knob) -> String {
    format!("{} {}", knob.group, knob.words).replace(' ', "-")
}
