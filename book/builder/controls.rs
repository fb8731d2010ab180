use live::{Kind, Live, Parameter, escape, italic_letter};
use std::collections::BTreeSet;

/// The controls below a figure or picture: ranges and switches for the parameters that no
/// visible handle sets.
///
/// Hidden where no script can answer, and there from the first where one
/// will, to be set as soon as it can; see book/theme/live.js.
pub fn html(live: &Live) -> String {
    let handled = parameter_indices_of_visible_handles(live);
    let labels = |is_included: fn(&Parameter) -> bool| -> String {
        let parameters = live.parameters.iter().enumerate();
        let included = parameters.filter(|(k, parameter)| {
            let is_grouped = !parameter.group.is_empty();
            (is_grouped || !handled.contains(k)) && is_included(parameter)
        });
        included
            .map(|(k, parameter)| parameter_control_html(live, k, parameter))
            .collect()
    };
    let hint = if live.has_probe() { HINT } else { "" };
    let content = match group_select_html(live) {
        None => format!("{}{RESET}", labels(|_| true)),
        Some(choice) => format!(
            "<div class=\"choice\">{choice}{}{RESET}</div>{}",
            labels(|parameter| parameter.kind == Kind::Switch),
            labels(|parameter| parameter.kind != Kind::Switch)
        ),
    };
    format!("<div class=\"controls\" hidden inert>{hint}{content}</div>")
}

const HINT: &str = "<span class=\"hint\">Press on the picture, or move the cross by \
                    the arrow keys, to ask a pixel.</span>";

const RESET: &str =
    "<button type=\"button\" class=\"reset\" disabled>Reset</button>";

/// The parameters that are set by the handles which are inside the printed output.
fn parameter_indices_of_visible_handles(live: &Live) -> BTreeSet<usize> {
    let values = live.default_values();
    let [width, height] = live.default_output().width_and_height();
    let handles = live.handles.iter().filter(|handle| {
        handle.place(&values).is_some_and(|place| {
            (0.0..=width).contains(&place.x) && (0.0..=height).contains(&place.y)
        })
    });
    handles.flat_map(|handle| handle.parameters).collect()
}

/// The choice of the group whose controls are visible; None without groups.
fn group_select_html(live: &Live) -> Option<String> {
    let mut groups: Vec<_> =
        live.parameters.iter().map(|parameter| parameter.group).collect();
    groups.dedup();
    groups.retain(|group| !group.is_empty());
    let options: String =
        groups.iter().map(|group| format!("<option>{group}</option>")).collect();
    let choice = format!("<label>Change <select>{options}</select></label>");
    (!groups.is_empty()).then_some(choice)
}

/// The control of the parameter number `k`, at its default.
fn parameter_control_html(live: &Live, k: usize, parameter: &Parameter) -> String {
    let (class, input) = match parameter.kind {
        Kind::Switch => ("switch", checkbox_html(parameter)),
        Kind::Number(_) | Kind::Choice(_) => ("range", range_input_html(parameter)),
    };
    let first_group = live.handles.first().map_or("", |handle| {
        let [first, _] = handle.parameters;
        live.parameters[first].group
    });
    let has_control = (parameter.has_control)(parameter, &live.default_values());
    let is_visible = has_control && parameter.group == first_group;
    let hidden = if is_visible { "" } else { " hidden" };
    let group = match parameter.group {
        "" => String::new(),
        group => format!(" data-group=\"{group}\""),
    };
    let symbol: String = parameter.symbol.chars().map(italic_letter).collect();
    let symbol = match symbol.as_str() {
        "" => symbol,
        _ => format!(
            "<span class=\"symbol\" aria-hidden=\"true\">{}</span> ",
            escape(&symbol)
        ),
    };
    format!(
        "<label class=\"{class}\" data-parameter=\"{k}\"{group}{hidden}>\
         <span>{symbol}{}</span>{input}</label>",
        escape(&parameter.words)
    )
}

/// A range, and its value as text; a screen reader has that from the script.
fn range_input_html(parameter: &Parameter) -> String {
    let Parameter { range: [min, max], steps_per_unit, default, .. } = parameter;
    let step = 1.0 / steps_per_unit;
    format!(
        "<input type=\"range\" min=\"{min}\" max=\"{max}\" step=\"{step}\" \
         value=\"{default}\"><b aria-hidden=\"true\">{}</b>",
        escape(&parameter.format(*default))
    )
}

fn checkbox_html(parameter: &Parameter) -> String {
    let checked = if parameter.default == 1.0 { " checked" } else { "" };
    format!("<input type=\"checkbox\"{checked}>")
}
