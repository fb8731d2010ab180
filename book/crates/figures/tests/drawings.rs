//! Locks the texts of each figure, the replies to a page, and the effects of dragging the handles.
//! In the snapshots, each element of a drawing and each field of a reply begins a line.

use course::{Step, find_draw_function};
use figures::{
    COLUMNS, Content, FIGURES, Figure, FigureRequest, Parameter, ParameterValues, Reply, WIDTH,
    find_figure, format_address, parse_address, reply,
};
use glam::{DVec2, dvec2};
use insta::assert_snapshot;

/// The reply to a request, split into lines. If the reply has pixels, the text ends with the first
/// 40 pixels.
fn reply_lines(figure: &Figure, request: &FigureRequest) -> String {
    let Reply { text, pixels } = reply(figure.name, request).unwrap_or_else(Reply::from_error);
    let text = json_lines(&text).replace("\\\"", "\"").replace("\\u000a", "\n");
    let pixels = pixels.chunks(4).take(40).map(|pixel| format!("\n{pixel:?}"));
    let text = ["<radialGradient", "<stop", "<path", "<circle", "<ellipse", "<text"]
        .into_iter()
        .fold(text, |text, element| text.replace(element, &format!("\n{element}")));
    text + &pixels.collect::<String>()
}

/// Splits a JSON object into lines. A line ends after each field of this object, after each object
/// in a list, and after each text in `texts` or `readouts`.
fn json_lines(json: &str) -> String {
    let (mut lines, mut depth, mut is_string, mut has_long_texts) =
        (String::new(), 0, false, false);
    let mut chars = json.chars().peekable();
    while let Some(c) = chars.next() {
        lines.push(c);
        match c {
            '\\' => lines.extend(chars.next()),
            '"' => is_string = !is_string,
            '{' | '[' if !is_string => {
                has_long_texts |=
                    lines.ends_with("\"texts\":{") || lines.ends_with("\"readouts\":{");
                depth += 1;
            }
            '}' | ']' if !is_string => {
                has_long_texts = false;
                depth -= 1;
            }
            ',' if !is_string && (depth == 1 || has_long_texts || chars.peek() == Some(&'{')) => {
                lines.push('\n');
            }
            _ => {}
        }
    }
    lines
}

/// Lists the replies to requests about a figure. Each reply follows the description of its request.
fn replies(figure: &Figure, requests: &[(String, FigureRequest)]) -> String {
    let parts: Vec<_> = requests
        .iter()
        .map(|(description, request)| format!("{description}\n{}\n", reply_lines(figure, request)))
        .collect();
    parts.join("\n")
}

/// Returns the description of a request, and the request itself. The request is to show the figure
/// with these values. If the figure is a picture, the request asks for only eight columns.
fn described_show_request(figure: &Figure, values: &ParameterValues) -> (String, FigureRequest) {
    let columns = match figure.content {
        Content::Drawing { .. } => None,
        Content::Picture { .. } => Some(8),
    };
    let mut description = format!("show {} {}", figure.name, format_address(figure, values));
    if let Some(columns) = columns {
        description += &format!(" {columns}");
    }
    let numbers =
        figure.parameters.iter().map(|Parameter { id, .. }| (id.to_string(), values[*id]));
    (description, FigureRequest::Show { values: numbers.collect(), columns })
}

/// Returns allowed values that are spread over the parameters' ranges, and that differ between
/// seeds.
fn spread_values(figure: &Figure, seed: usize) -> ParameterValues {
    let golden_ratio = 0.618_033_988_749_895;
    let mut attempts = (0..10_000).filter_map(|attempt| {
        let values = (1..).zip(&figure.parameters).map(|(k, parameter)| {
            let [min, max] = parameter.range;
            let fraction = ((k + attempt * 97 + seed * 31) as f64 * golden_ratio).fract();
            (parameter.id, min + fraction * (max - min))
        });
        figure.nearest_allowed_values(&values.collect())
    });
    attempts.next().expect("the values of some attempt are allowed")
}

/// The default values, and two sets of values that are spread over the parameters' ranges. If the
/// figure has no parameters, only the default values.
fn default_and_spread_values(figure: &Figure) -> Vec<ParameterValues> {
    let [first, second] = [1, 2].map(|seed| spread_values(figure, seed));
    let mut value_sets = vec![figure.default_values(), first, second];
    value_sets.dedup();
    value_sets
}

#[test]
fn figure_draws_the_same_picture_as_its_program() {
    let steps = Step::NAMES.map(|name| (name, "", name));
    let examples = [
        ("checkerboard", "", "checkerboard"),
        ("mirror", "", "mirror"),
        ("own_scene", "", "step05_phong"),
        ("own_scene", "the-way-back-shadows-and-mirrors:1", "mirror"),
    ];
    for (name, address, program) in steps.into_iter().chain(examples) {
        let figure = find_figure(name).expect("the figure exists");
        let values = parse_address(figure, address).expect("the address is valid");
        let Content::Picture { draw } = figure.content else { panic!("{name} is a drawing") };
        let draw_program = find_draw_function(program).expect("the program draws a picture");
        assert!(
            draw(&values, COLUMNS) == draw_program(&course::camera(), 1),
            "{name} differs from {program}"
        );
    }
}

#[test]
fn texts_and_replies_are_as_locked() {
    for figure in FIGURES.iter() {
        let mut requests = vec![(format!("about {}", figure.name), FigureRequest::About)];
        let values = default_and_spread_values(figure);
        requests.extend(values.iter().map(|values| described_show_request(figure, values)));
        let texts = match &figure.content {
            Content::Drawing { title, caption, .. } => {
                format!("title: {title}\ncaption: {caption}\n\n")
            }
            Content::Picture { .. } => String::new(),
        };
        assert_snapshot!(figure.name, texts + &replies(figure, &requests));
    }
}

/// Returns the following sets of values, except those that leave the figure with nothing to show:
/// - the default values;
/// - for each parameter, the default values with this parameter at the lower end of its range, and
///   the default values with this parameter at the upper end;
/// - the values with all parameters at their lower ends, and those with all at their upper ends.
fn values_at_limits(figure: &Figure) -> Vec<ParameterValues> {
    let mut value_sets = vec![figure.default_values()];
    for end in [0, 1] {
        let mut values_at_end = figure.default_values();
        for parameter in &figure.parameters {
            let mut values = figure.default_values();
            for values in [&mut values, &mut values_at_end] {
                values.set(parameter.id, parameter.range[end]);
            }
            value_sets.push(values);
        }
        value_sets.push(values_at_end);
    }
    value_sets.into_iter().filter_map(|values| figure.nearest_allowed_values(&values)).collect()
}

#[test]
fn labels_are_inside_their_drawing_and_covered_by_no_label_or_handle() {
    let mut faults = vec![];
    for figure in FIGURES.iter() {
        for values in values_at_limits(figure).iter().chain(&default_and_spread_values(figure)) {
            let Some(drawing) = figure.draw(values) else { continue };
            let handles = figure.handles.iter();
            let handles =
                handles.filter_map(|handle| Some((handle.label, (handle.locate)(values)?)));
            let handles: Vec<_> = handles.collect();
            let size = dvec2(WIDTH, drawing.height());
            let labels: Vec<_> = drawing.label_boxes().collect();
            for (k, (text, label_box)) in labels.iter().enumerate() {
                let label = format!("{} {}: {text}", figure.name, format_address(figure, values));
                if label_box.shift_into(size) != DVec2::ZERO {
                    faults.push(format!("{label} is cut off"));
                }
                let overlapped_label =
                    labels[..k].iter().find(|(_, earlier_box)| label_box.overlaps(earlier_box));
                faults.extend(
                    overlapped_label
                        .map(|(earlier_text, _)| format!("{label} overlaps {earlier_text}")),
                );
                let mut handles = handles.iter();
                let covering =
                    handles.find(|(_, position)| label_box.is_covered_by_handle(*position));
                faults
                    .extend(covering.map(|(handle, _)| format!("{label} is covered by {handle}")));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn ids_in_a_drawing_begin_with_the_name_of_its_figure() {
    for figure in FIGURES.iter() {
        let Some(drawing) = figure.draw(&figure.default_values()) else { continue };
        let svg = drawing.svg_elements();
        for id in svg.split(" id=\"").skip(1) {
            assert!(id.starts_with(figure.name), "{}: {id}", figure.name);
        }
    }
}

/// Lists the figure's handles, one per line. Each line contains the handle's position for `values`,
/// and the values of the handle's two parameters after the handle is dragged to a fixed position.
fn describe_handles_before_and_after_drag(figure: &Figure, values: &ParameterValues) -> String {
    let lines = figure.handles.iter().map(|handle| {
        let position = (handle.locate)(values).map(DVec2::round);
        let dragged = figure.values_after_drag(values, handle, dvec2(300.0, 120.0));
        let dragged = dragged.map(|new| [new[handle.horizontal], new[handle.vertical]]);
        format!("{}: {position:?}, dragged: {dragged:?}\n", handle.label)
    });
    format!("{}\n{}", figure.name, lines.collect::<String>())
}

#[test]
fn dragged_handles_are_as_locked() {
    let parts = FIGURES.iter().flat_map(|figure| {
        let value_sets = default_and_spread_values(figure).into_iter();
        value_sets.map(|values| describe_handles_before_and_after_drag(figure, &values))
    });
    let own_scene = find_figure("own_scene").expect("the figure exists");
    let cameras = [
        "camera-position-sideways:6,camera-roll:-30,camera-target-backwards:-8",
        // The camera looks back at the scene.
        "camera-position-backwards:-20,camera-target-upwards:1",
        // The red sphere is dragged in a plane that the camera sees edge-on.
        "camera-position-sideways:6,camera-position-backwards:-7.4,camera-target-backwards:-7.4",
    ];
    let cameras = cameras.map(|address| {
        describe_handles_before_and_after_drag(
            own_scene,
            &parse_address(own_scene, address).expect("the address is valid"),
        )
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
    let requests = addresses.map(|address| {
        let request = FigureRequest::Open { address: address.to_owned() };
        (format!("open own_scene {address}"), request)
    });
    let own_scene = find_figure("own_scene").expect("the figure exists");
    assert_snapshot!("addresses", replies(own_scene, &requests));
}
