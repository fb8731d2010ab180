use crate::own_scene::opened;
use crate::{Knob, Live, Sight, find, json};
use glam::dvec2;
use image::RgbImage;

/// What the module says to a request of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// JSON: what to put where, or what was wrong with the request.
    pub text: String,
    /// The pixels, where there is a picture.
    pub pixels: Vec<u8>,
}

impl Answer {
    /// An answer of these fields, which are JSON already.
    pub fn of(fields: impl IntoIterator<Item = (&'static str, String)>) -> Self {
        Self { text: json::object(fields), pixels: vec![] }
    }
}

/// Answers a line such as `show row 7 60 0`.
///
/// - `about NAME`: its handles, and the values of its knobs in the printed book.
/// - `show NAME VALUES`: what it shows at these values.
/// - `tell NAME VALUES`: the same, where it is there to be seen already.
/// - `drag NAME HANDLE X Y VALUES`: the same, after a handle was dragged to a place.
/// - `step NAME HANDLE X Y VALUES`: the same, after so many steps by arrow keys.
/// - `open NAME ADDRESS`: what it shows at the values of an address.
///
/// A handle that asks leaves what is seen as it is: then nothing is drawn, nor for `tell`.
pub fn answer(request: &str) -> Answer {
    answered(request)
        .unwrap_or_else(|| refused(&format!("There is no answer to {request}.")))
}

/// A sentence that says what was wrong.
fn refused(what: &str) -> Answer {
    Answer::of([("error", json::text(what))])
}

fn answered(request: &str) -> Option<Answer> {
    let mut words = request.split_whitespace();
    let (verb, live) = (words.next()?, find(words.next()?)?);
    if verb == "open" {
        return Some(match opened(live, words.next().unwrap_or_default()) {
            Ok(values) => show(live, &values, true),
            Err(what) => refused(&what),
        });
    }
    let numbers: Option<Vec<f64>> = words.map(|word| word.parse().ok()).collect();
    match (verb, &numbers?[..]) {
        ("about", _) => Some(about(live)),
        ("show", values) => Some(show(live, &live.allowed(values)?, true)),
        ("tell", values) => Some(show(live, &live.allowed(values)?, false)),
        (_, [handle, x, y, values @ ..]) => {
            let handle = live.handles.get(*handle as usize)?;
            let (values, by) = (live.allowed(values)?, dvec2(*x, *y));
            let moved = match verb {
                "drag" => live.drag(&values, handle, by),
                "step" => live.step(&values, handle, by),
                _ => return None,
            };
            Some(show(live, &moved.unwrap_or(values), !handle.is_asking))
        }
        _ => None,
    }
}

/// What the page has to know before it can ask; what it can turn is printed in it.
fn about(live: &Live) -> Answer {
    let handles = live.handles.iter().map(|handle| {
        let Knob { range: [min, max], group, .. } = live.knobs[handle.knobs[0]];
        json::object([
            ("words", json::text(&handle.words)),
            ("knobs", json::list(handle.knobs)),
            ("isAsking", handle.is_asking.to_string()),
            ("min", min.to_string()),
            ("max", max.to_string()),
            ("group", json::text(group)),
        ])
    });
    Answer::of([
        ("handles", json::list(handles)),
        ("values", json::list(live.values())),
    ])
}

/// The values and what belongs to them, with what there `is_seen` at them.
fn show(live: &Live, values: &[f64], is_seen: bool) -> Answer {
    let knobs = live.knobs.iter().zip(values);
    let texts = knobs.clone().map(|(knob, value)| json::text(&knob.text(*value)));
    let shown = knobs.map(|(knob, _)| (knob.is_shown)(knob, values));
    let places = live.handles.iter().map(|handle| {
        let at = handle.place(values).to_array();
        json::list(at.map(|x| (100.0 * x).round() / 100.0))
    });
    let numbers = (live.numbers)(values);
    let numbers = numbers.iter().map(|(name, told)| (&name[..], json::text(told)));
    let mut fields = vec![
        ("values", json::list(values)),
        ("texts", json::list(texts)),
        ("shown", json::list(shown)),
        ("places", json::list(places)),
        ("numbers", json::object(numbers)),
    ];
    if let Some((_, draw)) = live.beside {
        fields.push(("beside", json::text(draw(values).body())));
    }
    let mut pixels = vec![];
    match is_seen.then(|| (live.sight)(values)) {
        Some(Sight::Drawing(drawing)) => {
            fields.push(("drawing", json::text(drawing.body())));
        }
        Some(Sight::Picture(picture)) => {
            fields.push(("size", json::list([picture.width(), picture.height()])));
            pixels = rgba(&picture);
        }
        None => {}
    }
    Answer { pixels, ..Answer::of(fields) }
}

/// Red, green, blue and 255 for each pixel, row by row, as a page draws them.
pub fn rgba(image: &RgbImage) -> Vec<u8> {
    let mut pixels = vec![255; 4 * image.as_raw().len() / 3];
    for (four, three) in pixels.chunks_exact_mut(4).zip(image.pixels()) {
        four[..3].copy_from_slice(&three.0);
    }
    pixels
}
