//! Replies to requests from a page.

use crate::address::{format_address, parse_address, parse_values};
use crate::{AddressError, Content, Figure, Mark, Parameter, ParameterValues, find_figure};
use course::{PICTURE_COLUMNS, json};
use glam::{DVec2, dvec2};
use image::{Rgb, RgbImage};
use std::error::Error;
use std::fmt::{self, Display, Formatter};
use std::ops::RangeInclusive;

/// The columns of a picture, unless the request says otherwise.
pub const COLUMNS: u32 = PICTURE_COLUMNS;

/// The numbers of columns that a request may ask for.
const ALLOWED_COLUMNS: RangeInclusive<u32> = 2..=3840;

/// The reply to a request from a page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reply {
    /// A JSON object with what the page shows, or with an `error`.
    pub text: String,
    /// The pixels of a picture, or empty if there is none.
    pub pixels: Vec<u8>,
}

impl Reply {
    /// A reply with these fields, whose values are already JSON.
    pub fn from_json_fields(fields: impl IntoIterator<Item = (&'static str, String)>) -> Self {
        Self { text: json::object(fields), pixels: vec![] }
    }
}

/// Why a request can't be answered.
#[derive(Clone, Debug, PartialEq)]
pub enum RequestError {
    /// The request isn't one of those listed at [`reply`].
    UnknownRequest(String),
    /// The figure can't have these values.
    Address(AddressError),
}

impl Error for RequestError {}

impl Display for RequestError {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::UnknownRequest(request) => write!(f, "There is no reply to {request}."),
            Self::Address(error) => error.fmt(f),
        }
    }
}

impl From<AddressError> for RequestError {
    fn from(error: AddressError) -> Self {
        Self::Address(error)
    }
}

/// Replies to a request such as `show row rays:7,field-of-view:60`.
///
/// - `about NAME`: the parameters and the handles.
/// - `show NAME VALUES COLUMNS`: everything that the page shows at these values. A picture has at
///   most this many columns; if the number is omitted, it has as many as in the book.
/// - `read NAME VALUES`: the same without the drawing or the pixels.
/// - `drag NAME VALUES HANDLE X Y COLUMNS`: as for `show`, after a handle is dragged to a position.
///   Handles are numbered from 0, in the order of `about`.
/// - `pick NAME VALUES X Y`: the object at a position, or null.
/// - `open NAME ADDRESS`: as for `show`, at the values of an address.
///
/// A probe doesn't change the picture, so nothing is drawn after a probe is dragged.
pub fn reply(request: &str) -> Reply {
    try_reply(request).unwrap_or_else(|error| {
        Reply::from_json_fields([("error", json::quote(&error.to_string()))])
    })
}

fn try_reply(request: &str) -> Result<Reply, RequestError> {
    let unknown = || RequestError::UnknownRequest(request.to_owned());
    let (verb, rest) = request.split_once(' ').ok_or_else(unknown)?;
    let (name, rest) = rest.split_once(' ').unwrap_or((rest, ""));
    let figure = find_figure(name).ok_or_else(unknown)?;
    let (text, rest) = rest.split_once(' ').unwrap_or((rest, ""));
    let numbers = rest.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>();
    let numbers = numbers.map_err(|_| unknown())?;
    let values = || parse_values(figure, text);
    match (verb, &numbers[..]) {
        ("about", _) => Ok(about_figure(figure)),
        ("read", []) => Ok(reply_at(figure, &values()?, None)),
        ("show", columns) => {
            let columns = parse_columns(columns).ok_or_else(unknown)?;
            Ok(reply_at(figure, &values()?, Some(columns)))
        }
        ("open", []) => Ok(reply_at(figure, &parse_address(figure, text)?, Some(COLUMNS))),
        ("pick", [x, y]) => {
            let scene = figure.editable_scene.as_ref().ok_or_else(unknown)?;
            let object = (scene.object_at)(&values()?, dvec2(*x, *y));
            Ok(Reply::from_json_fields([("object", quote_or_null(object))]))
        }
        ("drag", [handle, x, y, columns @ ..]) => {
            let handle = figure.handles.get(*handle as usize).ok_or_else(unknown)?;
            let columns = parse_columns(columns).ok_or_else(unknown)?;
            let values = values()?;
            let new = figure.drag_handle(&values, handle, dvec2(*x, *y)).unwrap_or(values);
            Ok(reply_at(figure, &new, (handle.mark != Mark::Probe).then_some(columns)))
        }
        _ => Err(unknown()),
    }
}

/// The number of columns that a request asks for, or None if it isn't allowed.
fn parse_columns(numbers: &[f64]) -> Option<u32> {
    match numbers {
        [] => Some(COLUMNS),
        [columns] => Some(*columns as u32).filter(|columns| ALLOWED_COLUMNS.contains(columns)),
        _ => None,
    }
}

/// What a page has to know about a figure before it shows anything.
fn about_figure(figure: &Figure) -> Reply {
    let handles = figure.handles.iter().map(|handle| {
        json::object([
            ("words", json::quote(handle.words)),
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
        let colours = scene.colours.iter();
        let colours = colours.map(|(object, ids)| (*object, json::list(ids.map(quote))));
        fields.push(("colours", json::object(colours)));
    }
    Reply::from_json_fields(fields)
}

fn about_parameter(parameter: &Parameter) -> String {
    let [min, max] = parameter.range;
    json::object([
        ("id", quote(parameter.id)),
        ("default", parameter.default.to_string()),
        ("min", min.to_string()),
        ("max", max.to_string()),
        ("step", parameter.step().to_string()),
        ("axis", quote_or_null(parameter.axis.map(|axis| axis.name()))),
    ])
}

/// Everything that the page shows at these values. A picture has at most this many columns; if
/// `columns` is None, nothing is drawn.
fn reply_at(figure: &Figure, values: &ParameterValues, columns: Option<u32>) -> Reply {
    let by_id = |field: &dyn Fn(&Parameter, f64) -> String| {
        let fields = figure
            .parameters
            .iter()
            .map(|parameter| (parameter.id.to_string(), field(parameter, values[parameter.id])));
        let fields: Vec<_> = fields.collect();
        json::object(fields.iter().map(|(id, field)| (&**id, field.clone())))
    };
    let positions = figure.handles.iter().map(|handle| {
        let rounded = |x: f64| (100.0 * x).round() / 100.0;
        let position = (handle.locate)(values);
        position
            .map_or("null".into(), |position: DVec2| json::list(position.to_array().map(rounded)))
    });
    let readouts = (figure.readouts)(values);
    let readouts = readouts.iter().map(|(name, text)| (&name[..], json::quote(text)));
    let mut fields = vec![
        ("values", by_id(&|_, value| value.to_string())),
        ("texts", by_id(&|parameter, value| json::quote(&parameter.format(value)))),
        ("visible", by_id(&|parameter, _| (parameter.has_control)(parameter, values).to_string())),
        ("positions", json::list(positions)),
        ("readouts", json::object(readouts)),
    ];
    if let Some(scene) = &figure.editable_scene {
        fields.push(("program", json::quote(&(scene.program)(values))));
        fields.push(("address", json::quote(&format_address(figure, values))));
    }
    let mut pixels = vec![];
    match (&figure.content, columns) {
        (_, None) => {}
        (Content::Drawing { draw, .. }, _) => {
            fields.push(("drawing", json::quote(&draw(values).svg_elements())));
        }
        (Content::Picture { draw }, Some(columns)) => {
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

/// The picture in the format of a canvas: red, green, blue and 255 for each pixel, row by row.
pub fn rgba_bytes(image: &RgbImage) -> Vec<u8> {
    image.pixels().flat_map(|Rgb([red, green, blue])| [*red, *green, *blue, 255]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn request_that_is_none_has_an_error() {
        for request in [
            "",
            "show",
            "show nothing",
            "dance row",
            "show row rays:7 many",
            "show step02_sphere i:1 0",
            "show step02_sphere i:1 3841",
            "show row moon:1",
            "drag row rays:7 5 0 0",
            "pick row rays:7 0 0",
        ] {
            assert!(try_reply(request).is_err(), "{request}");
            assert!(reply(request).text.starts_with("{\"error\":"), "{request}");
        }
    }

    #[test]
    fn picture_has_at_most_the_columns_of_the_request() {
        let size = |request| {
            let reply = try_reply(request).expect(request);
            let (_, size) = reply.text.rsplit_once("\"size\":").expect(request);
            size.to_owned()
        };
        assert_eq!(size("show step02_sphere  8"), "[8,5]}");
        assert_eq!(size("show step01_rays columns:16 8"), "[8,5]}");
        assert_eq!(size("show step01_rays columns:16"), "[16,9]}");
    }

    #[test]
    fn dragging_a_probe_sends_no_pixels() {
        let reply = try_reply("drag step02_sphere  0 10.5 20.5").expect("a reply");
        assert!(reply.pixels.is_empty() && reply.text.contains("\"positions\":[[10.5,20.5]"));
    }
}
