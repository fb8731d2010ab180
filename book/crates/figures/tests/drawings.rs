//! What a page gets of each figure and picture, locked as text: one element of a drawing, or
//! one field of JSON, a line.

use figures::{FIGURES, Figure, Output, reply};
use insta::{Settings, assert_snapshot};

/// The reply to a request, in lines.
fn reply_lines(request: &str) -> String {
    let text = reply(request).text.replace("\\\"", "\"").replace("\\u000a", "\n");
    ["<path", "<circle", "<text"]
        .into_iter()
        .fold(text, |text, element| text.replace(element, &format!("\n{element}")))
        .replace(",\"", ",\n\"")
        .replace(",{", ",\n{")
}

/// Allowed values all over their ranges, others for each seed.
fn spread_values(figure: &Figure, seed: usize) -> Vec<f64> {
    let golden_ratio = 0.618_033_988_749_895;
    let attempts = (0..10_000).map(|attempt| {
        let fractions =
            (1..).map(|k| ((k + attempt * 97 + seed * 31) as f64 * golden_ratio).fract());
        let parameters = figure.parameters.iter().zip(fractions);
        let values: Vec<_> = parameters
            .map(|(parameter, fraction)| {
                let [min, max] = parameter.range;
                min + fraction * (max - min)
            })
            .collect();
        figure.snap_if_allowed(&values)
    });
    attempts.flatten().next().expect("allowed values")
}

/// Compares a text with the snapshot of this name.
#[track_caller]
fn assert_locked(name: &str, parts: impl Iterator<Item = String>) {
    let text = parts.collect::<Vec<_>>().join("\n");
    let mut settings = Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| assert_snapshot!(name, text));
}

#[test]
fn drawings_and_numbers_are_as_locked() {
    for figure in FIGURES.iter() {
        let verb = match figure.default_output() {
            Output::Drawing(_) => "show",
            Output::Pixels(_) => "tell",
        };
        let mut requests = vec![format!("about {}", figure.name)];
        let mut values = vec![figure.default_values()];
        if !figure.parameters.is_empty() {
            values.extend([1, 2].map(|seed| spread_values(figure, seed)));
        }
        requests.extend(values.iter().map(|values| {
            let values = values.iter().map(|value| format!(" {value}"));
            format!("{verb} {}{}", figure.name, values.collect::<String>())
        }));
        let parts = requests.iter().map(|request| format!("{request}\n{}\n", reply_lines(request)));
        assert_locked(figure.name, parts);
    }
}

#[test]
fn replies_to_addresses_are_as_locked() {
    let addresses = [
        "red-sphere-radius:2,camera-field-of-view:45,third-light-on:1,ground-mirrored:0.5",
        "the-way-back-shadows-and-mirrors:1,camera-roll:-20,camera-position-sideways:3",
        "red-sphere-radius:0",
        "camera-field-of-view:NaN",
        "red-sphere-radius:2,ground-radius:",
        "moon-radius:1",
        // The camera is at its own target.
        "camera-position-backwards:-1",
    ];
    let parts = addresses.map(|address| {
        let request = format!("open own_scene {address}");
        format!("{request}\n{}\n", reply_lines(&request))
    });
    assert_locked("addresses", parts.into_iter());
}
