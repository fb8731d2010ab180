//! Parameter values in the two forms that pages use:
//! - the address of a scene, such as `red-sphere-radius:2,camera-roll:45`;
//! - the numbers in a request, each with the name of a parameter.

use crate::{Figure, Parameter, ParameterValues};
use thiserror::Error;

/// What is wrong with the values in a request or an address.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum AddressError {
    /// No parameter has this name.
    #[error("The address sets “{0}”, but nothing here has that name.")]
    UnknownParameter(String),
    /// The value isn't a number within the parameter's range.
    #[error(
        "The address says “{value}” for {parameter}, which must be from {} to {}.",
        .range[0],
        .range[1]
    )]
    NotAllowed {
        /// The name of the parameter.
        parameter: String,
        /// The value in the address.
        value: String,
        /// The smallest and the largest allowed value.
        range: [f64; 2],
    },
    /// Each value is allowed by itself, but the values together leave the figure with nothing to
    /// show.
    #[error("There is nothing to show at this address.")]
    NothingToShow,
}

impl AddressError {
    fn not_allowed(parameter: &Parameter, value: impl ToString) -> Self {
        Self::NotAllowed {
            parameter: parameter.id.to_string(),
            value: value.to_string(),
            range: parameter.range,
        }
    }
}

/// Formats an address, which lists the values that differ from the defaults.
pub fn format_address(figure: &Figure, values: &ParameterValues) -> String {
    let different = figure.parameters.iter().filter_map(|parameter| {
        let value = values[parameter.id];
        (value != parameter.default).then(|| format!("{}:{value}", parameter.id))
    });
    different.collect::<Vec<_>>().join(",")
}

/// Parses an address. A value outside the range of its parameter is an error. A parameter that the
/// address doesn't mention gets its default value.
pub fn parse_address(figure: &Figure, address: &str) -> Result<ParameterValues, AddressError> {
    let mut values = figure.default_values();
    for part in address.split(',').filter(|part| !part.is_empty()) {
        let (name, value) = part.split_once(':').unwrap_or((part, ""));
        let parameter = find_parameter(figure, name)?;
        let [min, max] = parameter.range;
        let number = value
            .parse()
            .ok()
            .filter(|number| (min..=max).contains(number))
            .ok_or_else(|| AddressError::not_allowed(parameter, value))?;
        values.set(parameter.id, number);
    }
    figure.nearest_allowed_values(&values).ok_or(AddressError::NothingToShow)
}

/// Replaces each number in a request with the nearest value that its parameter allows. A number
/// that isn't finite is an error. A parameter that the request doesn't mention gets its default
/// value.
pub fn clamp_requested_values(
    figure: &Figure,
    numbers: &[(String, f64)],
) -> Result<ParameterValues, AddressError> {
    let mut values = figure.default_values();
    for (name, number) in numbers {
        let parameter = find_parameter(figure, name)?;
        if !number.is_finite() {
            return Err(AddressError::not_allowed(parameter, number));
        }
        values.set(parameter.id, *number);
    }
    figure.nearest_allowed_values(&values).ok_or(AddressError::NothingToShow)
}

/// Finds the parameter whose id is displayed as `name`.
fn find_parameter<'a>(figure: &'a Figure, name: &str) -> Result<&'a Parameter, AddressError> {
    let parameter = figure.parameters.iter().find(|parameter| parameter.id.is_displayed_as(name));
    parameter.ok_or_else(|| AddressError::UnknownParameter(name.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::find_figure;

    #[test]
    fn address_has_the_values_that_differ_from_the_defaults() {
        let figure = find_figure("own_scene").expect("the figure exists");
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
    fn number_out_of_range_is_an_error_in_an_address_and_is_clamped_in_a_request() {
        let figure = find_figure("own_scene").expect("the figure exists");
        let error =
            parse_address(figure, "red-sphere-radius:7").expect_err("the radius is too large");
        assert!(matches!(error, AddressError::NotAllowed { range: [0.05, 3.0], .. }), "{error}");
        let request = |radius| [("red-sphere-radius".to_owned(), radius)];
        let values = clamp_requested_values(figure, &request(7.0)).expect("the radius is clamped");
        assert_eq!(format_address(figure, &values), "red-sphere-radius:3");
        for radius in [f64::NAN, f64::INFINITY] {
            assert!(clamp_requested_values(figure, &request(radius)).is_err(), "{radius}");
        }
        for text in ["red-sphere-radius:NaN", "red-sphere-radius:inf", "red-sphere-radius"] {
            assert!(parse_address(figure, text).is_err(), "{text}");
        }
    }

    #[test]
    fn error_names_the_unknown_parameter() {
        let figure = find_figure("row").expect("the figure exists");
        let expected = AddressError::UnknownParameter("moon".to_owned());
        assert_eq!(parse_address(figure, "moon:1").as_ref(), Err(&expected));
        let request = [("moon".to_owned(), 1.0)];
        assert_eq!(clamp_requested_values(figure, &request), Err(expected));
    }
}
