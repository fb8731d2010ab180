use figures::{Handle, Kind, Live, Parameter, escape, italic_letter};
use glam::DVec2;

/// The controls below a figure or picture: one for each parameter that has a name, and a
/// number field for each that a handle sets.
///
/// Hidden where no script can answer, and there from the first where one
/// will, to be set as soon as it can; see book/theme/live.js.
pub fn html(live: &Live) -> String {
    let handles = visible_handles(live);
    let controls = |is_included: fn(&Parameter) -> bool| -> String {
        let parameters = live.parameters.iter().enumerate();
        let included = parameters.filter(|(_, parameter)| is_included(parameter));
        included
            .map(|(k, parameter)| parameter_control_html(live, &handles, k, parameter))
            .collect()
    };
    let hint = if live.has_probe() { HINT } else { "" };
    let content = match group_select_html(live) {
        None => format!("{}{RESET}", controls(|_| true)),
        Some(choice) => format!(
            "<div class=\"choice\">{choice}{}{RESET}</div>{}",
            controls(|parameter| parameter.kind == Kind::Switch),
            controls(|parameter| parameter.kind != Kind::Switch)
        ),
    };
    format!("<div class=\"controls\" hidden inert>{hint}{content}</div>")
}

const HINT: &str = "<span class=\"hint\">Press on the picture, or move the cross by \
                    the arrow keys, to ask a pixel. The answer is below.</span>";

const RESET: &str = "<button type=\"button\" class=\"reset\" disabled>Reset</button>";

/// The handles that are inside the printed output.
fn visible_handles(live: &Live) -> Vec<&Handle> {
    let values = live.default_values();
    let size = DVec2::from(live.default_output().width_and_height());
    let is_inside = |place: DVec2| place == place.clamp(DVec2::ZERO, size);
    let handles = live.handles.iter();
    handles.filter(|handle| handle.place(&values).is_some_and(is_inside)).collect()
}

/// The choice of the group whose controls are visible; None without groups.
fn group_select_html(live: &Live) -> Option<String> {
    let mut groups: Vec<_> = live.parameters.iter().map(|parameter| parameter.group).collect();
    groups.dedup();
    groups.retain(|group| !group.is_empty());
    let options: String = groups.iter().map(|group| format!("<option>{group}</option>")).collect();
    let choice = format!("<label>Change <select>{options}</select></label>");
    (!groups.is_empty()).then_some(choice)
}

/// The control of the parameter number `k`, at its default. What a visible handle sets has
/// no range beside its number field, unless it has a group.
fn parameter_control_html(
    live: &Live,
    visible_handles: &[&Handle],
    k: usize,
    parameter: &Parameter,
) -> String {
    let handle = visible_handles.iter().copied();
    let handle =
        handle.filter(|_| parameter.group.is_empty()).find(|handle| handle.parameters.contains(&k));
    let (symbol, words) = symbol_and_words(k, parameter, handle);
    let label = label_html(symbol, &words);
    let default = escape(&parameter.format(parameter.default));
    let (class, content) = match parameter.kind {
        Kind::Columns => return String::new(),
        Kind::Switch => ("switch", format!("<label>{label}{}</label>", checkbox_html(parameter))),
        Kind::Choice(names) if names.len() < 4 => {
            ("field", format!("<label>{label} {}</label>", select_html(parameter, names)))
        }
        Kind::Choice(_) => (
            "range",
            format!(
                "<label>{label}{}</label><b aria-hidden=\"true\">{default}</b>",
                range_input_html(parameter)
            ),
        ),
        Kind::Number(unit) if handle.is_some() => {
            let field = number_input_html(parameter, "");
            ("field", format!("<label>{label} {field}{unit}</label>"))
        }
        Kind::Number(unit) => {
            let name = format!(" aria-label=\"{} {words}\"", escape(symbol));
            let (range, field) = (range_input_html(parameter), number_input_html(parameter, &name));
            ("range", format!("<label>{label}{range}</label><span>{field}{unit}</span>"))
        }
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
    format!("<div class=\"{class}\" data-parameter=\"{k}\"{group}{hidden}>{content}</div>")
}

/// The symbol and the words of a parameter; a coordinate of a handle is called by it.
fn symbol_and_words(
    k: usize,
    parameter: &Parameter,
    handle: Option<&Handle>,
) -> (&'static str, String) {
    match handle {
        Some(handle) if parameter.words.is_empty() => {
            let symbol = match handle.parameters {
                [first, second] if first == second => "",
                [first, _] if first == k => "x",
                _ => "y",
            };
            let of = if symbol.is_empty() { "" } else { "of " };
            (symbol, format!("{of}{}", handle.words))
        }
        _ => (parameter.symbol, parameter.words.clone()),
    }
}

/// A symbol in italics, and words.
fn label_html(symbol: &str, words: &str) -> String {
    let symbol: String = symbol.chars().map(italic_letter).collect();
    let symbol = match symbol.as_str() {
        "" => symbol,
        _ => format!("<span class=\"symbol\" aria-hidden=\"true\">{}</span> ", escape(&symbol)),
    };
    format!("<span>{symbol}{}</span>", escape(words))
}

/// The attributes of a range or number field.
fn range_attributes(parameter: &Parameter) -> String {
    let Parameter { range: [min, max], steps_per_unit, default, .. } = parameter;
    let step = 1.0 / steps_per_unit;
    format!("min=\"{min}\" max=\"{max}\" step=\"{step}\" value=\"{default}\"")
}

fn range_input_html(parameter: &Parameter) -> String {
    format!("<input type=\"range\" {}>", range_attributes(parameter))
}

fn number_input_html(parameter: &Parameter, name: &str) -> String {
    format!("<input type=\"number\"{name} {}>", range_attributes(parameter))
}

fn checkbox_html(parameter: &Parameter) -> String {
    let checked = if parameter.default == 1.0 { " checked" } else { "" };
    format!("<input type=\"checkbox\"{checked}>")
}

fn select_html(parameter: &Parameter, names: &[&str]) -> String {
    let options: String = names
        .iter()
        .enumerate()
        .map(|(k, name)| {
            let is_default = k as f64 == parameter.default;
            let selected = if is_default { " selected" } else { "" };
            format!("<option value=\"{k}\"{selected}>{}</option>", escape(name))
        })
        .collect();
    format!("<select>{options}</select>")
}
