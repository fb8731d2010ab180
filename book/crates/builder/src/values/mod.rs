//! The numbers that `{{#value …}}` puts into a chapter, computed when the book is built.
//!
//! - `LIVE:NAME` is a number of a figure at its defaults, such as `row:D`;
//! - `LIVE:I,J:NAME` is one of the trace of a pixel, such as `step04_diffuse:470,120:t`;
//! - `NAME X` is a function of a number, such as `half-angle 40`;
//! - `NAME` is any other.
//!
//! A minus is one (−); code and formulas get a hyphen where it is put in.

mod lecture_slips;
mod problems;
mod rays;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;
mod way_back;

/// Values of a chapter as they are written, by name.
type Values = [(&'static str, fn() -> String)];

/// Values of a chapter that are functions of a number, by name.
type Functions = [(&'static str, fn(f64) -> String)];

const VALUES: [&Values; 8] = [
    step01::VALUES,
    step02::VALUES,
    step03::VALUES,
    step04::VALUES,
    step05::VALUES,
    lecture_slips::VALUES,
    way_back::VALUES,
    problems::VALUES,
];

const FUNCTIONS: [&Functions; 4] =
    [step02::FUNCTIONS, step05::FUNCTIONS, lecture_slips::FUNCTIONS, way_back::FUNCTIONS];

/// The text of `{{#value …}}`.
pub fn value_text(text: &str) -> Result<String, String> {
    let number = match text.split_once(':') {
        Some((live, number)) => live_number_text(live, number),
        None => chapter_value_text(text),
    };
    number.ok_or_else(|| format!("there is no value {text}"))
}

/// A number such as `D` of a live figure at its defaults, or such as `470,120:t` of a
/// picture with a probe.
fn live_number_text(live: &str, number: &str) -> Option<String> {
    let live = figures::find(live)?;
    let mut values = live.default_values();
    let mut name = number;
    if let Some((pixel, traced)) = number.split_once(':')
        && live.has_probe()
    {
        let (i, j) = pixel.split_once(',')?;
        values[..2].copy_from_slice(&[i.parse().ok()?, j.parse().ok()?]);
        name = traced;
    }
    let is_allowed = live.snap_if_allowed(&values)? == values;
    is_allowed.then(|| (live.numbers)(&values).remove(name))?
}

/// A value such as `camera-tan`, or such as `half-angle 40`.
fn chapter_value_text(text: &str) -> Option<String> {
    let Some((name, number)) = text.split_once(' ') else {
        let (_, value) = VALUES.into_iter().flatten().find(|(name, _)| *name == text)?;
        return Some(value());
    };
    let (_, function) = FUNCTIONS.into_iter().flatten().find(|(known, _)| *known == name)?;
    Some(function(number.parse().ok()?))
}

/// The names of all of them.
#[cfg(test)]
pub fn names() -> impl Iterator<Item = &'static str> {
    let values = VALUES.into_iter().flatten().map(|(name, _)| *name);
    values.chain(FUNCTIONS.into_iter().flatten().map(|(name, _)| *name))
}
