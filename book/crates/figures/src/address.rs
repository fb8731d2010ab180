//! Parameter values as one word, such as `red-sphere-radius:2,camera-roll:45`, which the page
//! writes in requests and in the address of a scene.

use crate::{Figure, ParameterValues};
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::{self, Display, Formatter};

/// What is wrong with the values in a request or an address.
#[derive(Clone, Debug, PartialEq)]
pub enum AddressError {
    /// No parameter has this name.
    UnknownParameter(String),
    /// The value isn't a number within the parameter's range.
    NotAllowed {
        /// The name of the parameter.
        parameter: String,
        /// The value in the address.
        value: String,
        /// The smallest and the largest value.
        range: [f64; 2],
    },
    /// Each value is allowed, but all of them together leave nothing to show.
    NothingToShow,
}

impl Error for AddressError {}

impl Display for AddressError {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::UnknownParameter(name) => {
                write!(f, "The address speaks of “{name}”, and nothing here is called so.")
            }
            Self::NotAllowed { parameter, value, range: [min, max] } => {
                write!(f, "The address says “{value}” for {parameter}; allowed are {min} to {max}.")
            }
            Self::NothingToShow => f.write_str("There is nothing to show at this address."),
        }
    }
}

/// Formats the values that differ from the defaults.
pub fn format_address(figure: &Figure, values: &ParameterValues) -> String {
    let different = figure.parameters.iter().filter_map(|parameter| {
        let value = values[parameter.id];
        (value != parameter.default).then(|| format!("{}:{value}", parameter.id))
    });
    different.collect::<Vec<_>>().join(",")
}

/// Parses an address, whose values must be within their ranges. A parameter that isn't mentioned
/// has its default.
pub fn parse_address(figure: &Figure, address: &str) -> Result<ParameterValues, AddressError> {
    parse(figure, address, true)
}

/// Parses the values in a request, where a number outside its range becomes the nearest one within
/// it. A parameter that isn't mentioned has its default.
pub fn parse_values(figure: &Figure, text: &str) -> Result<ParameterValues, AddressError> {
    parse(figure, text, false)
}

fn parse(figure: &Figure, text: &str, is_strict: bool) -> Result<ParameterValues, AddressError> {
    let parameters: BTreeMap<_, _> =
        figure.parameters.iter().map(|parameter| (parameter.id.to_string(), parameter)).collect();
    let mut values = figure.default_values();
    for part in text.split(',').filter(|part| !part.is_empty()) {
        let (name, value) = part.split_once(':').unwrap_or((part, ""));
        let parameter =
            parameters.get(name).ok_or_else(|| AddressError::UnknownParameter(name.to_owned()))?;
        let [min, max] = parameter.range;
        let is_allowed = |number: &f64| {
            if is_strict { (min..=max).contains(number) } else { number.is_finite() }
        };
        let number = value.parse().ok().filter(is_allowed);
        let number = number.ok_or_else(|| AddressError::NotAllowed {
            parameter: name.to_owned(),
            value: value.to_owned(),
            range: parameter.range,
        })?;
        values.set(parameter.id, number);
    }
    figure.snap_if_allowed(&values).ok_or(AddressError::NothingToShow)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::find_figure;

    #[test]
    fn address_has_the_values_that_differ_from_the_defaults() {
        let figure = find_figure("own_scene").expect("a figure");
        for address in ["", "camera-roll:45", "red-sphere-radius:2,cool-light-on:0"] {
            let values = parse_address(figure, address).expect(address);
            let mut parts: Vec<_> =
                format_address(figure, &values).split(',').map(str::to_owned).collect();
            parts.sort();
            let mut expected: Vec<_> = address.split(',').map(str::to_owned).collect();
            expected.sort();
            assert_eq!(parts, expected);
        }
    }

    #[test]
    fn address_with_a_number_outside_its_range_is_an_error_and_a_request_takes_the_nearest() {
        let figure = find_figure("own_scene").expect("a figure");
        let text = "red-sphere-radius:7";
        let error = parse_address(figure, text).expect_err("a radius that is too large");
        assert!(matches!(error, AddressError::NotAllowed { range: [0.05, 3.0], .. }), "{error}");
        let values = parse_values(figure, text).expect("values");
        assert_eq!(format_address(figure, &values), "red-sphere-radius:3");
        for text in ["red-sphere-radius:NaN", "red-sphere-radius:inf", "red-sphere-radius"] {
            assert!(parse_values(figure, text).is_err(), "{text}");
        }
    }

    #[test]
    fn unknown_parameter_is_named() {
        let figure = find_figure("row").expect("a figure");
        let error = parse_values(figure, "moon:1").expect_err("no moon");
        assert_eq!(error, AddressError::UnknownParameter("moon".to_owned()));
    }
}
