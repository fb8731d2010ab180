//! What a page gets of each figure and picture, locked as text: one element of a drawing, or
//! one field of JSON, a line.

use course::{Step, find_picture};
use figures::{FIGURES, Figure, Output, Reply, find, parse_address, reply};
use glam::{DVec2, dvec2};
use insta::assert_snapshot;

/// The reply to a request, in lines; the last are the first pixels.
fn reply_lines(request: &str) -> String {
    let Reply { text, pixels } = reply(request);
    let text = text.replace("\\\"", "\"").replace("\\u000a", "\n");
    let pixels = pixels.chunks(4).take(40).map(|pixel| format!("\n{pixel:?}"));
    ["<path", "<circle", "<text"]
        .into_iter()
        .fold(text, |text, element| text.replace(element, &format!("\n{element}")))
        .replace(",\"", ",\n\"")
        .replace(",{", ",\n{")
        + &pixels.collect::<String>()
}

/// The requests, each with its reply below it.
fn replies(requests: &[String]) -> String {
    let parts = requests.iter().map(|request| format!("{request}\n{}\n", reply_lines(request)));
    parts.collect::<Vec<_>>().join("\n")
}

/// Allowed values all over their ranges, others for each seed.
fn spread_values(figure: &Figure, seed: usize) -> Vec<f64> {
    let golden_ratio = 0.618_033_988_749_895;
    let mut attempts = (0..10_000).filter_map(|attempt| {
        let values = (1..).zip(&figure.parameters).map(|(k, parameter)| {
            let [min, max] = parameter.range;
            let fraction = ((k + attempt * 97 + seed * 31) as f64 * golden_ratio).fract();
            min + fraction * (max - min)
        });
        figure.snap_if_allowed(&values.collect::<Vec<_>>())
    });
    attempts.next().expect("allowed values")
}

/// The default values and, if there are parameters, two others all over their ranges; of a
/// picture, with eight columns.
fn values_to_lock(figure: &Figure) -> Vec<Vec<f64>> {
    let [first, second] = [1, 2].map(|seed| spread_values(figure, seed));
    let mut all = vec![figure.default_values(), first, second];
    let columns = figure.parameters.iter().position(|one| one.symbol == "hRes");
    if let Some(columns) = columns.filter(|_| figure.title.is_empty()) {
        all.iter_mut().for_each(|values| values[columns] = 8.0);
    }
    all.dedup();
    all
}

#[test]
fn default_picture_is_that_of_the_program() {
    let steps = Step::NAMES.map(|name| (name, "", name));
    let others = [
        ("mirror", "", "mirror"),
        ("own_scene", "", "step05_phong"),
        ("own_scene", "the-way-back-shadows-and-mirrors:1", "mirror"),
    ];
    for (name, address, program) in steps.into_iter().chain(others) {
        let figure = find(name).expect("a picture");
        let values = parse_address(figure, address).expect("values");
        let Output::Pixels(image) = (figure.draw)(&values) else { panic!("a drawing") };
        let picture = find_picture(program).expect("a program");
        assert!(image == picture(&course::camera(), 1), "{name} differs from {program}");
    }
}

#[test]
fn drawings_and_numbers_are_as_locked() {
    for figure in FIGURES.iter() {
        let mut requests = vec![format!("about {}", figure.name)];
        requests.extend(values_to_lock(figure).iter().map(|values| {
            let values = values.iter().map(|value| format!(" {value}"));
            format!("show {}{}", figure.name, values.collect::<String>())
        }));
        assert_snapshot!(figure.name, replies(&requests));
    }
}

/// Each handle with its place at these values, and its parameters after it was dragged.
fn handle_lines(figure: &Figure, values: &[f64]) -> String {
    let lines = figure.handles.iter().map(|handle| {
        let place = (handle.locate)(values).map(DVec2::round);
        let dragged = figure.drag_handle(values, handle, dvec2(300.0, 120.0));
        let dragged = dragged.map(|new| handle.parameters.map(|k| new[k]));
        format!("{}: {place:?}, dragged: {dragged:?}\n", handle.words)
    });
    format!("{}\n{}", figure.name, lines.collect::<String>())
}

#[test]
fn dragged_handles_are_as_locked() {
    let parts = FIGURES.iter().flat_map(|figure| {
        let all = values_to_lock(figure).into_iter();
        all.map(|values| handle_lines(figure, &values))
    });
    let own_scene = find("own_scene").expect("a picture");
    let cameras = [
        "camera-position-sideways:6,camera-roll:-30,camera-target-backwards:-8",
        // It looks back at the scene.
        "camera-position-backwards:-20,camera-target-upwards:1",
        // The plane in which the red sphere is dragged is seen from its edge.
        "camera-position-sideways:6,camera-position-backwards:-7.4,camera-target-backwards:-7.4",
    ];
    let cameras = cameras.map(|address| {
        handle_lines(own_scene, &parse_address(own_scene, address).expect("a scene"))
    });
    assert_snapshot!("handles", parts.chain(cameras).collect::<Vec<_>>().join("\n"));
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
        "-columns:2",
        // The camera is at its own target.
        "camera-position-backwards:-1",
    ];
    let requests = addresses.map(|address| format!("open own_scene {address}"));
    assert_snapshot!("addresses", replies(&requests));
}
