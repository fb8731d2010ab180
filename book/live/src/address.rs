//! Values as a part of an address: those that are not as printed, such as
//! `red-sphere-radius:2,camera-field-of-view:45`.

use crate::{Knob, Live};

/// The values of things that are not as printed.
pub fn address(knobs: &[Knob], values: &[f64]) -> String {
    let all = knobs.iter().zip(values);
    let changed =
        all.filter(|(knob, value)| !knob.group.is_empty() && knob.value != **value);
    let changed: Vec<_> =
        changed.map(|(knob, value)| format!("{}:{value}", name(knob))).collect();
    changed.join(",")
}

/// The values at an address, or a sentence that says what is wrong with it.
pub fn opened(live: &Live, address: &str) -> Result<Vec<f64>, String> {
    let mut values = live.values();
    for part in address.split(',').filter(|part| !part.is_empty()) {
        let (which, value) = part.split_once(':').unwrap_or((part, ""));
        let mut known = live.knobs.iter().zip(&mut values);
        let known =
            known.find(|(knob, _)| name(knob) == which && !knob.group.is_empty());
        let (knob, at) = known.ok_or(format!(
            "The address speaks of “{}”, and nothing here is called so.",
            short(which)
        ))?;
        let number: f64 = value.parse().map_err(|_| {
            format!(
                "The address says “{}” for {which}, which is no number.",
                short(value)
            )
        })?;
        let [min, max] = knob.range;
        if !(min..=max).contains(&number) {
            let value = short(value);
            return Err(format!(
                "The address says {value} for {which}; allowed are {min} to {max}."
            ));
        }
        *at = number;
    }
    live.allowed(values).ok_or("There is nothing to show at this address.".into())
}

/// What a number of a thing is called in an address.
fn name(knob: &Knob) -> String {
    format!("{} {}", knob.group, knob.words).replace(' ', "-")
}

/// The beginning of a text that may be long.
fn short(text: &str) -> String {
    match text.char_indices().nth(30) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into(),
    }
}
