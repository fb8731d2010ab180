use crate::address::opened;
use crate::json::{self, Json};
use crate::{Knob, Live, Sight, find};
use glam::dvec2;

/// What the module says to a request of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// JSON: what to put where, or what was wrong with the request.
    pub text: String,
    /// The pixels, where there is a picture.
    pub pixels: Vec<u8>,
}

/// Answers a line such as `show row 7 60`.
///
/// - `about NAME`: its handles, and the values of its knobs in the printed book.
/// - `show NAME VALUES`: what it shows at these values.
/// - `tell NAME VALUES`: the same without what there is to see.
/// - `drag NAME HANDLE X Y VALUES`: the same, after a handle was dragged to a place.
/// - `step NAME HANDLE X Y VALUES`: the same, after so many steps by arrow keys.
/// - `open NAME ADDRESS`: what it shows at the values of an address.
///
/// A handle that asks leaves what is seen as it is, and nothing is drawn.
pub fn answer(request: &str) -> Answer {
    answered(request)
        .unwrap_or_else(|| refused(format!("There is no answer to {request:?}.")))
}

/// A sentence that says what was wrong.
fn refused(what: String) -> Answer {
    Answer { text: json::object([("error", what.into())]), pixels: vec![] }
}

fn answered(request: &str) -> Option<Answer> {
    let mut words = request.split_whitespace();
    let (verb, live) = (words.next()?, find(words.next()?)?);
    if verb == "open" {
        let values = opened(live, words.next().unwrap_or_default());
        return Some(
            values.map_or_else(refused, |values| show(live, &values, true)),
        );
    }
    let numbers: Option<Vec<f64>> = words.map(|word| word.parse().ok()).collect();
    let numbers = numbers?;
    if verb == "about" {
        return Some(Answer { text: about(live), pixels: vec![] });
    }
    let (gesture, values) = if ["show", "tell"].contains(&verb) {
        (&[][..], &numbers[..])
    } else {
        numbers.split_at_checked(3)?
    };
    let values = live.allowed(values.to_vec())?;
    let (values, is_seen) = match (verb, gesture) {
        ("show" | "tell", _) => (values, verb == "show"),
        (_, &[handle, x, y]) if x.is_finite() && y.is_finite() => {
            let handle = live.handles.get(handle as usize)?;
            let values = match verb {
                "drag" => live.drag(&values, handle, dvec2(x, y)),
                "step" => live.step(&values, handle, dvec2(x, y)),
                _ => return None,
            };
            (values, !handle.is_asking)
        }
        _ => return None,
    };
    Some(show(live, &values, is_seen))
}

/// What the page has to know before it can ask; what it can turn is printed in it.
fn about(live: &Live) -> String {
    let handles = live.handles.iter().map(|handle| {
        let knobs = handle.knobs.map(|knob| Json::from(knob as f64));
        let Knob { range: [min, max], group, .. } = live.knobs[handle.knobs[0]];
        let fields = [
            ("words", handle.words.into()),
            ("knobs", Json::list(knobs)),
            ("isAsking", handle.is_asking.into()),
            ("min", min.into()),
            ("max", max.into()),
            ("group", group.into()),
        ];
        Json::raw(json::object(fields))
    });
    json::object([
        ("handles", Json::list(handles)),
        ("values", Json::list(live.values().into_iter().map(Json::from))),
    ])
}

/// The values and what belongs to them, with what there `is_seen` at them.
fn show(live: &Live, values: &[f64], is_seen: bool) -> Answer {
    let texts = live.knobs.iter().zip(values);
    let texts = texts.map(|(knob, value)| knob.text(*value).into());
    let shown = live.knobs.iter().map(|knob| (knob.is_shown)(values).into());
    let places = live.handles.iter().map(|handle| {
        let at = (handle.at)(values);
        Json::list(at.to_array().map(|x| Json::from((100.0 * x).round() / 100.0)))
    });
    let numbers =
        (live.numbers)(values).into_iter().map(|(name, text)| (name, text.into()));
    let mut fields = vec![
        ("values", Json::list(values.iter().map(|value| Json::from(*value)))),
        ("texts", Json::list(texts)),
        ("shown", Json::list(shown)),
        ("places", Json::list(places)),
        ("numbers", Json::raw(json::object(numbers))),
    ];
    if let Some((_, draw)) = live.beside {
        fields.push(("beside", draw(values).body().into()));
    }
    let mut pixels = vec![];
    match is_seen.then(|| (live.sight)(values)) {
        None => {}
        Some(Sight::Drawing(drawing)) => {
            fields.push(("drawing", drawing.body().into()))
        }
        Some(Sight::Picture { size, pixels: drawn }) => {
            let size = size.map(|side| Json::from(f64::from(side)));
            fields.push(("size", Json::list(size)));
            pixels = drawn;
        }
    }
    Answer { text: json::object(fields), pixels }
}
