use crate::own_scene::parse_address;
use crate::{ControlKind, Figure, Mark, Output, find};
use course::json;
use glam::dvec2;
use image::{Rgb, RgbImage};

/// The reply to a request of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reply {
    /// A JSON object of what the page shows, or of an `error`.
    pub text: String,
    /// The pixels of a picture; otherwise empty.
    pub pixels: Vec<u8>,
}

impl Reply {
    /// A reply of these fields, which are JSON already.
    pub fn from_json_fields(fields: impl IntoIterator<Item = (&'static str, String)>) -> Self {
        Self { text: json::object(fields), pixels: vec![] }
    }
}

/// Replies to a request such as `show row 7 60 0`.
///
/// - `about NAME`: the handles, and the default values.
/// - `show NAME VALUES`: all that the page shows at these values.
/// - `tell NAME VALUES`: the same without the drawing or the pixels.
/// - `drag NAME HANDLE X Y VALUES`: as `show`, after a handle was dragged to a place.
/// - `press NAME X Y VALUES`: the group of the object that is seen at a place, or nothing.
/// - `open NAME ADDRESS`: as `show`, at the values of an address.
///
/// A probe leaves the picture as it is: after it was moved, nothing is drawn.
pub fn reply(request: &str) -> Reply {
    let no_answer = || error_reply(format!("There is no answer to {request}."));
    try_reply(request).unwrap_or_else(no_answer)
}

fn error_reply(error: String) -> Reply {
    Reply::from_json_fields([("error", json::quote(&error))])
}

/// The reply; None where nothing fits the request.
fn try_reply(request: &str) -> Option<Reply> {
    let mut words = request.split_whitespace();
    let (verb, figure) = (words.next()?, find(words.next()?)?);
    if verb == "open" {
        let values = parse_address(figure, words.next().unwrap_or_default());
        return Some(values.map_or_else(error_reply, |values| reply_at(figure, &values, true)));
    }
    let numbers: Option<Vec<f64>> = words.map(|word| word.parse().ok()).collect();
    Some(match (verb, &numbers?[..]) {
        ("about", _) => handles_and_defaults_reply(figure),
        ("show" | "tell", values) => {
            reply_at(figure, &figure.snap_if_allowed(values)?, verb == "show")
        }
        ("press", [x, y, values @ ..]) => {
            let group = (figure.group_at)(&figure.snap_if_allowed(values)?, dvec2(*x, *y));
            Reply::from_json_fields([("group", json::quote(group.unwrap_or_default()))])
        }
        ("drag", [handle, x, y, values @ ..]) => {
            let handle = figure.handles.get(*handle as usize)?;
            let values = figure.snap_if_allowed(values)?;
            let new = figure.drag_handle(&values, handle, dvec2(*x, *y)).unwrap_or(values);
            reply_at(figure, &new, handle.mark != Mark::Probe)
        }
        _ => return None,
    })
}

/// The handles, the default values, and which of them is the columns of a picture; the
/// controls are printed in the page.
fn handles_and_defaults_reply(figure: &Figure) -> Reply {
    let columns = figure.parameters.iter().position(|p| p.control == ControlKind::Columns);
    let handles = figure.handles.iter().map(|handle| {
        json::object([
            ("words", json::quote(&handle.words)),
            ("parameters", json::list(handle.parameters)),
            ("mark", json::quote(&format!("{:?}", handle.mark).to_lowercase())),
            // Rows grow downwards.
            ("down", (figure.parameters[handle.parameters[1]].symbol == "j").to_string()),
        ])
    });
    Reply::from_json_fields([
        ("handles", json::list(handles)),
        ("values", json::list(figure.default_values())),
        ("columns", columns.map_or("null".into(), |index| index.to_string())),
    ])
}

/// All that the page shows at these values, with or without the drawing or the pixels.
fn reply_at(figure: &Figure, values: &[f64], is_shown: bool) -> Reply {
    let pairs = figure.parameters.iter().zip(values);
    let texts = pairs.clone().map(|(p, value)| json::quote(&p.format(*value)));
    let visible = pairs.map(|(p, _)| (p.has_control)(p, values));
    let places = figure.handles.iter().map(|handle| {
        let rounded = |x: f64| (100.0 * x).round() / 100.0;
        let place = (handle.locate)(values);
        place.map_or("null".into(), |place| json::list(place.to_array().map(rounded)))
    });
    let numbers = (figure.numbers)(values);
    let numbers = numbers.iter().map(|(name, text)| (&name[..], json::quote(text)));
    let mut fields = vec![
        ("values", json::list(values)),
        ("texts", json::list(texts)),
        ("visible", json::list(visible)),
        ("places", json::list(places)),
        ("numbers", json::object(numbers)),
    ];
    let mut pixels = vec![];
    match is_shown.then(|| (figure.draw)(values)) {
        Some(Output::Drawing(one)) => fields.push(("drawing", json::quote(one.svg_elements()))),
        Some(Output::Pixels(image)) => {
            fields.push(("size", json::list([image.width(), image.height()])));
            pixels = rgba_bytes(&image);
        }
        None => {}
    }
    Reply { pixels, ..Reply::from_json_fields(fields) }
}

/// Red, green, blue and 255 for each pixel, row by row, as a canvas takes them.
pub fn rgba_bytes(image: &RgbImage) -> Vec<u8> {
    image.pixels().flat_map(|Rgb([red, green, blue])| [*red, *green, *blue, 255]).collect()
}
