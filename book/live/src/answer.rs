use crate::own_scene::opened;
use crate::{Knob, Live, Sight, find};
use glam::dvec2;
use image::RgbImage;
use serde_json::{Value, json};

/// What the module says to a request of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// JSON: what to put where, or what was wrong with the request.
    pub text: String,
    /// The pixels, where there is a picture.
    pub pixels: Vec<u8>,
}

impl From<Value> for Answer {
    fn from(value: Value) -> Self {
        Self { text: value.to_string(), pixels: vec![] }
    }
}

/// Answers a line such as `show row 7 60 0`.
///
/// - `about NAME`: its handles, and the values of its knobs in the printed book.
/// - `show NAME VALUES`: what it shows at these values.
/// - `drag NAME HANDLE X Y VALUES`: the same, after a handle was dragged to a place.
/// - `step NAME HANDLE X Y VALUES`: the same, after so many steps by arrow keys.
/// - `open NAME ADDRESS`: what it shows at the values of an address.
///
/// A handle that asks leaves what is seen as it is, and nothing is drawn.
pub fn answer(request: &str) -> Answer {
    answered(request).unwrap_or_else(|| {
        json!({ "error": format!("There is no answer to {request}.") }).into()
    })
}

fn answered(request: &str) -> Option<Answer> {
    let mut words = request.split_whitespace();
    let (verb, live) = (words.next()?, find(words.next()?)?);
    if verb == "open" {
        return Some(match opened(live, words.next().unwrap_or_default()) {
            Ok(values) => show(live, &values, true),
            Err(error) => json!({ "error": error }).into(),
        });
    }
    let numbers: Option<Vec<f64>> = words.map(|word| word.parse().ok()).collect();
    match (verb, &numbers?[..]) {
        ("about", _) => Some(about(live)),
        ("show", values) => Some(show(live, &live.allowed(values)?, true)),
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
        json!({
            "words": handle.words, "knobs": handle.knobs, "isAsking": handle.is_asking,
            "min": min, "max": max, "group": group,
        })
    });
    json!({ "handles": handles.collect::<Value>(), "values": live.values() }).into()
}

/// The values and what belongs to them, with what there `is_seen` at them.
fn show(live: &Live, values: &[f64], is_seen: bool) -> Answer {
    let knobs = live.knobs.iter().zip(values);
    let texts = knobs.clone().map(|(knob, value)| knob.text(*value));
    let shown = knobs.map(|(knob, _)| (knob.is_shown)(knob, values));
    let places = live.handles.iter().map(|handle| {
        let at = handle.place(values).to_array();
        Value::from(at.map(|x| (100.0 * x).round() / 100.0).to_vec())
    });
    let mut answer = json!({
        "values": values,
        "texts": texts.collect::<Value>(),
        "shown": shown.collect::<Value>(),
        "places": places.collect::<Value>(),
        "numbers": (live.numbers)(values),
    });
    if let Some((_, draw)) = live.beside {
        answer["beside"] = draw(values).body().into();
    }
    let mut pixels = vec![];
    match is_seen.then(|| (live.sight)(values)) {
        Some(Sight::Drawing(drawing)) => answer["drawing"] = drawing.body().into(),
        Some(Sight::Picture(picture)) => {
            answer["size"] = json!(picture.dimensions());
            pixels = rgba(&picture);
        }
        None => {}
    }
    Answer { pixels, ..answer.into() }
}

/// Red, green, blue and 255 for each pixel, row by row, as a page draws them.
pub fn rgba(image: &RgbImage) -> Vec<u8> {
    let mut pixels = vec![255; 4 * image.as_raw().len() / 3];
    for (four, three) in pixels.chunks_exact_mut(4).zip(image.pixels()) {
        four[..3].copy_from_slice(&three.0);
    }
    pixels
}
