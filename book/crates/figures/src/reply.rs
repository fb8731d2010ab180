use crate::own_scene::parse_address;
use crate::{Kind, Live, Mark, Output, find};
use course::json;
use glam::dvec2;
use image::RgbImage;

/// The answer to a request of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// A JSON object of what the page shows, or of an `error`.
    pub text: String,
    /// The pixels of a picture; otherwise empty.
    pub pixels: Vec<u8>,
}

impl Answer {
    /// An answer of these fields, which are JSON already.
    pub fn from_json_fields(fields: impl IntoIterator<Item = (&'static str, String)>) -> Self {
        Self { text: json::object(fields), pixels: vec![] }
    }
}

/// Answers a request such as `show row 7 60 0`.
///
/// - `about NAME`: the handles, and the default values.
/// - `show NAME VALUES`: all that the page shows at these values.
/// - `tell NAME VALUES`: the same without the drawing or the pixels.
/// - `drag NAME HANDLE X Y VALUES`: as `show`, after a handle was dragged to a place.
/// - `step NAME HANDLE X Y VALUES`: the same, after so many steps by arrow keys.
/// - `open NAME ADDRESS`: as `show`, at the values of an address.
///
/// A probe leaves the picture as it is: after it was moved, nothing is drawn.
pub fn answer(request: &str) -> Answer {
    try_answer(request)
        .unwrap_or_else(|| error_answer(&format!("There is no answer to {request}.")))
}

/// The answer that says, in a sentence, what was wrong with the request.
fn error_answer(sentence: &str) -> Answer {
    Answer::from_json_fields([("error", json::quote(sentence))])
}

fn try_answer(request: &str) -> Option<Answer> {
    let mut words = request.split_whitespace();
    let (verb, live) = (words.next()?, find(words.next()?)?);
    if verb == "open" {
        return Some(match parse_address(live, words.next().unwrap_or_default()) {
            Ok(values) => full_answer(live, &values),
            Err(sentence) => error_answer(&sentence),
        });
    }
    let numbers: Option<Vec<f64>> = words.map(|word| word.parse().ok()).collect();
    match (verb, &numbers?[..]) {
        ("about", _) => Some(handles_and_defaults_answer(live)),
        ("show", values) => Some(full_answer(live, &live.snap_if_allowed(values)?)),
        ("tell", values) => Some(text_answer(live, &live.snap_if_allowed(values)?)),
        (_, [handle, x, y, values @ ..]) => {
            let handle = live.handles.get(*handle as usize)?;
            let (values, vector) = (live.snap_if_allowed(values)?, dvec2(*x, *y));
            let new = match verb {
                "drag" => live.drag_handle(&values, handle, vector),
                "step" => live.step_handle(&values, handle, vector),
                _ => return None,
            };
            let new = new.unwrap_or(values);
            let is_probe = handle.mark == Mark::Probe;
            let respond = if is_probe { text_answer } else { full_answer };
            Some(respond(live, &new))
        }
        _ => None,
    }
}

/// The handles, the default values, and which of them is the columns of a picture; the
/// controls are printed in the page.
fn handles_and_defaults_answer(live: &Live) -> Answer {
    let columns = live.parameters.iter().position(|p| p.kind == Kind::Columns);
    let handles = live.handles.iter().map(|handle| {
        let [first, _] = handle.parameters;
        let [min, max] = live.parameters[first].range;
        json::object([
            ("words", json::quote(&handle.words)),
            ("parameters", json::list(handle.parameters)),
            ("mark", json::quote(handle.mark.name())),
            ("min", min.to_string()),
            ("max", max.to_string()),
            ("group", json::quote(live.parameters[first].group)),
        ])
    });
    Answer::from_json_fields([
        ("handles", json::list(handles)),
        ("values", json::list(live.default_values())),
        ("columns", columns.map_or("null".into(), |index| index.to_string())),
    ])
}

/// All that the page shows at these values.
fn full_answer(live: &Live, values: &[f64]) -> Answer {
    let mut fields = text_fields(live, values);
    let mut pixels = vec![];
    match (live.draw)(values) {
        Output::Drawing(drawing) => {
            fields.push(("drawing", json::quote(drawing.svg_elements())));
        }
        Output::Picture(picture) => {
            fields.push(("size", json::list([picture.width(), picture.height()])));
            pixels = rgba_bytes(&picture);
        }
    }
    Answer { pixels, ..Answer::from_json_fields(fields) }
}

/// The same without the drawing or the pixels.
fn text_answer(live: &Live, values: &[f64]) -> Answer {
    Answer::from_json_fields(text_fields(live, values))
}

fn text_fields(live: &Live, values: &[f64]) -> Vec<(&'static str, String)> {
    let pairs = live.parameters.iter().zip(values);
    let texts = pairs.clone().map(|(p, value)| json::quote(&p.format(*value)));
    let visible = pairs.map(|(p, _)| (p.has_control)(p, values));
    let places = live.handles.iter().map(|handle| {
        let rounded = |x: f64| (100.0 * x).round() / 100.0;
        let place = handle.place(values);
        place.map_or("null".into(), |place| json::list(place.to_array().map(rounded)))
    });
    let numbers = (live.numbers)(values);
    let numbers = numbers.iter().map(|(name, text)| (&name[..], json::quote(text)));
    let mut fields = vec![
        ("values", json::list(values)),
        ("texts", json::list(texts)),
        ("visible", json::list(visible)),
        ("places", json::list(places)),
        ("numbers", json::object(numbers)),
    ];
    if let Some(companion) = live.companion {
        let drawing = (companion.draw)(values);
        fields.push(("companion", json::quote(drawing.svg_elements())));
    }
    fields
}

/// Red, green, blue and 255 for each pixel, row by row, as a canvas takes them.
pub fn rgba_bytes(image: &RgbImage) -> Vec<u8> {
    let mut pixels = vec![255; 4 * image.as_raw().len() / 3];
    for (rgba, rgb) in pixels.chunks_exact_mut(4).zip(image.pixels()) {
        rgba[..3].copy_from_slice(&rgb.0);
    }
    pixels
}
