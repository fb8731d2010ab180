//! Replies to a page's requests about a figure.

use crate::address::{clamp_requested_values, format_address, parse_address};
use crate::{
    Content, Figure, FigureRequest, FigureRequestError, Mark, Parameter, ParameterValues,
    find_figure,
};
use course::{PICTURE_COLUMNS, json};
use glam::DVec2;
use image::{Rgb, RgbImage};
use std::error::Error;
use std::fmt::Display;
use std::ops::RangeInclusive;

/// The number of columns of a picture, unless the request asks for a different number.
pub const COLUMNS: u32 = PICTURE_COLUMNS;

/// The numbers of columns that a request may ask for.
const ALLOWED_COLUMNS: RangeInclusive<u32> = 2..=3840;

/// The reply to a request from a page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reply {
    /// A JSON object with what the page shows, or with an `error`.
    pub text: String,
    /// The pixels of a picture, as [`rgba_bytes`] returns them. Empty if the reply has no picture.
    pub pixels: Vec<u8>,
}

impl Reply {
    /// A reply with these fields. The value of each field has to be JSON already.
    pub fn from_json_fields(fields: impl IntoIterator<Item = (&'static str, String)>) -> Self {
        Self { text: json::object(fields), pixels: vec![] }
    }

    /// A reply whose only field, `error`, is the error's message.
    pub fn from_error(error: impl Error) -> Self {
        Self::from_json_fields([("error", quote(error))])
    }
}

/// Replies to a request about the figure with this name.
pub fn reply(figure_name: &str, request: &FigureRequest) -> Result<Reply, FigureRequestError> {
    let unknown = || FigureRequestError::UnknownFigure(figure_name.to_owned());
    let figure = find_figure(figure_name).ok_or_else(unknown)?;
    let reply = match request {
        FigureRequest::About => about_figure(figure),
        FigureRequest::Show { values, columns } => {
            let columns = allowed_columns(*columns)?;
            reply_for_values(figure, &clamp_requested_values(figure, values)?, Some(columns))
        }
        FigureRequest::Read { values } => {
            reply_for_values(figure, &clamp_requested_values(figure, values)?, None)
        }
        FigureRequest::Drag { values, handle, position, columns } => {
            let unknown = || FigureRequestError::UnknownHandle(*handle);
            let handle = figure.handles.get(*handle as usize).ok_or_else(unknown)?;
            let columns = allowed_columns(*columns)?;
            let values = clamp_requested_values(figure, values)?;
            let new =
                figure.values_after_drag(&values, handle, DVec2::from(*position)).unwrap_or(values);
            reply_for_values(figure, &new, (handle.mark != Mark::Probe).then_some(columns))
        }
        FigureRequest::Pick { values, position } => {
            let scene = figure.editable_scene.as_ref().ok_or(FigureRequestError::NoObjects)?;
            let values = clamp_requested_values(figure, values)?;
            let object = (scene.object_at)(&values, DVec2::from(*position));
            Reply::from_json_fields([("object", quote_or_null(object))])
        }
        FigureRequest::Open { address } => {
            reply_for_values(figure, &parse_address(figure, address)?, Some(COLUMNS))
        }
    };
    Ok(reply)
}

/// Returns the requested number of columns, or [`COLUMNS`] if the request doesn't set the number. A
/// number outside [`ALLOWED_COLUMNS`] is an error.
fn allowed_columns(columns: Option<u32>) -> Result<u32, FigureRequestError> {
    let columns = columns.unwrap_or(COLUMNS);
    let is_allowed = ALLOWED_COLUMNS.contains(&columns);
    is_allowed.then_some(columns).ok_or(FigureRequestError::Columns(columns))
}

/// Replies with what a page has to know about a figure before the page can show it.
fn about_figure(figure: &Figure) -> Reply {
    let handles = figure.handles.iter().map(|handle| {
        json::object([
            ("label", json::quote(handle.label)),
            ("mark", json::quote(handle.mark.name())),
            ("horizontal", quote(handle.horizontal)),
            ("vertical", quote(handle.vertical)),
            ("depth", quote_or_null(handle.depth)),
            ("presence", quote_or_null(handle.presence)),
        ])
    });
    let columns = match figure.content {
        Content::Picture { .. } => COLUMNS.to_string(),
        Content::Drawing { .. } => "null".to_owned(),
    };
    let mut fields = vec![
        ("parameters", json::list(figure.parameters.iter().map(about_parameter))),
        ("handles", json::list(handles)),
        ("columns", columns),
    ];
    if let Some(scene) = &figure.editable_scene {
        let colours = scene
            .colour_parameters_by_object
            .iter()
            .map(|(object, ids)| (*object, json::list(ids.map(quote))));
        fields.push(("colours", json::object(colours)));
    }
    Reply::from_json_fields(fields)
}

/// Formats what a page has to know about a parameter, as a JSON object.
fn about_parameter(parameter: &Parameter) -> String {
    let [min, max] = parameter.range;
    json::object([
        ("id", quote(parameter.id)),
        ("object", quote_or_null(parameter.id.object())),
        ("name", quote(parameter.id.name())),
        ("default", parameter.default.to_string()),
        ("min", min.to_string()),
        ("max", max.to_string()),
        ("step", parameter.step().to_string()),
        ("axis", quote_or_null(parameter.axis.map(|axis| axis.name()))),
    ])
}

/// Replies with everything that the page shows for the given parameter values. A picture has at
/// most `columns` columns. If `columns` is None, nothing is drawn.
fn reply_for_values(figure: &Figure, values: &ParameterValues, columns: Option<u32>) -> Reply {
    let by_id = |field: &dyn Fn(&Parameter, f64) -> String| {
        let fields: Vec<_> = figure
            .parameters
            .iter()
            .map(|parameter| (parameter.id.to_string(), field(parameter, values[parameter.id])))
            .collect();
        json::object(fields.iter().map(|(id, field)| (&**id, field.clone())))
    };
    let positions = figure.handles.iter().map(|handle| {
        let rounded = |x: f64| (100.0 * x).round() / 100.0;
        (handle.locate)(values)
            .map_or("null".into(), |position: DVec2| json::list(position.to_array().map(rounded)))
    });
    let readouts = (figure.readouts)(values);
    let quoted_readouts = readouts.iter().map(|(name, text)| (&name[..], json::quote(text)));
    let mut fields = vec![
        ("values", by_id(&|_, value| value.to_string())),
        ("texts", by_id(&|parameter, value| json::quote(&parameter.format(value)))),
        ("visible", by_id(&|parameter, _| (parameter.has_control)(parameter, values).to_string())),
        ("positions", json::list(positions)),
        ("readouts", json::object(quoted_readouts)),
    ];
    if let Some(scene) = &figure.editable_scene {
        fields.push(("program", json::quote(&(scene.program)(values))));
        fields.push(("address", json::quote(&format_address(figure, values))));
    }
    let mut pixels = vec![];
    if let Some(columns) = columns {
        let drawing = figure.draw(values).map(|drawing| json::quote(&drawing.svg_elements()));
        fields.extend(drawing.map(|elements| ("drawing", elements)));
        if let Content::Picture { draw } = &figure.content {
            let image = draw(values, columns);
            fields.push(("size", json::list([image.width(), image.height()])));
            pixels = rgba_bytes(&image);
        }
    }
    Reply { pixels, ..Reply::from_json_fields(fields) }
}

fn quote(text: impl Display) -> String {
    json::quote(&text.to_string())
}

fn quote_or_null(text: Option<impl Display>) -> String {
    text.map_or("null".to_owned(), quote)
}

/// Converts a picture to the bytes of an HTML canvas. Each pixel has four bytes: red, green, blue,
/// and 255 for the opacity.
pub fn rgba_bytes(image: &RgbImage) -> Vec<u8> {
    let mut bytes = vec![255; 4 * image.as_raw().len() / 3];
    for (rgba, Rgb([red, green, blue])) in bytes.chunks_exact_mut(4).zip(image.pixels()) {
        (rgba[0], rgba[1], rgba[2]) = (*red, *green, *blue);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parses an address, such as `i:1,j:2`, into the values of a request.
    fn parse_values(text: &str) -> Vec<(String, f64)> {
        let parts = text.split(',').filter_map(|part| part.split_once(':'));
        parts.map(|(id, value)| (id.to_owned(), value.parse().expect(text))).collect()
    }

    fn show(text: &str, columns: Option<u32>) -> FigureRequest {
        FigureRequest::Show { values: parse_values(text), columns }
    }

    fn drag(text: &str, handle: u32, position: [f64; 2]) -> FigureRequest {
        FigureRequest::Drag { values: parse_values(text), handle, position, columns: None }
    }

    #[test]
    fn request_that_cannot_be_fulfilled_has_an_error() {
        let pick = FigureRequest::Pick { values: parse_values("rays:7"), position: [0.0; 2] };
        for (name, request, message) in [
            ("nothing", show("", None), "There is no figure “nothing”."),
            ("step02_sphere", show("i:1", Some(1)), "A picture can't have 1 columns."),
            ("step02_sphere", show("i:1", Some(3841)), "A picture can't have 3841 columns."),
            ("row", drag("rays:7", 5, [0.0; 2]), "This figure has no handle 5."),
            ("row", pick, "This figure has no objects to pick."),
            (
                "row",
                show("moon:1", None),
                "The address sets “moon”, but nothing here has that name.",
            ),
        ] {
            let error = reply(name, &request).expect_err(message);
            assert_eq!(error.to_string(), message);
        }
    }

    #[test]
    fn picture_has_at_most_the_columns_of_the_request() {
        let size = |name, request| {
            let reply = reply(name, &request).expect(name);
            let (_, size) = reply.text.rsplit_once("\"size\":").expect(name);
            size.to_owned()
        };
        assert_eq!(size("step02_sphere", show("", Some(8))), "[8,5]}");
        assert_eq!(size("step01_rays", show("columns:16", Some(8))), "[8,5]}");
        assert_eq!(size("step01_rays", show("columns:16", None)), "[16,9]}");
    }

    #[test]
    fn dragging_a_probe_sends_no_pixels() {
        let reply =
            reply("step02_sphere", &drag("", 0, [10.5, 20.5])).expect("the probe can be dragged");
        assert!(reply.pixels.is_empty() && reply.text.contains("\"positions\":[[10.5,20.5]"));
    }
}
