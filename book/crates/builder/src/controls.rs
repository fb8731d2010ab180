//! The controls of an interactive figure: sliders, number fields, switches and choices.

use figures::{ControlKind, Figure, Parameter, escape, italic_letter};

const HINT: &str = "<span class=\"hint\">Click or tap the picture, or move the cross \
                    with the arrow keys, to choose a pixel.</span>";

const RESET: &str = "<button type=\"button\" class=\"reset\" disabled>Reset</button>";

/// The controls below a figure or picture: one for each parameter, except those of
/// [`ControlKind::Columns`]. The number fields of parameters that a handle sets are folded away. If
/// parameters have groups, the page shows one group at a time.
///
/// The controls are printed with the page, so that nothing moves when they start working. Without
/// scripts they stay hidden; see book/theme/figure.js.
pub fn html(live: &Figure) -> String {
    let mut groups: Vec<_> = live.parameters.iter().map(|parameter| parameter.group).collect();
    groups.dedup();
    groups.retain(|group| !group.is_empty());
    let (mut exact, mut above, mut below) = (vec![], String::new(), String::new());
    for (k, parameter) in live.parameters.iter().enumerate() {
        let control = Control::new(live, k, parameter);
        match parameter.control {
            ControlKind::Columns => {}
            _ if control.is_exact => exact.push(control),
            ControlKind::Switch => above += &control.html(),
            _ if groups.is_empty() => above += &control.html(),
            _ => below += &control.html(),
        }
    }
    let hint = if live.has_probe() { HINT } else { "" };
    let content = if groups.is_empty() {
        format!("{above}{}{RESET}", exact_html(&exact))
    } else {
        let options = groups.iter().map(|group| format!("<option>{}</option>", escape(group)));
        let options: String = options.collect();
        format!(
            "<div class=\"choice\"><label>Change <select>{options}</select></label>\
             {above}{RESET}</div>{below}"
        )
    };
    format!("<div class=\"controls\" hidden inert>{hint}{content}</div>")
}

/// The folded number fields, with a row for each object that they belong to.
fn exact_html(exact: &[Control]) -> String {
    if exact.is_empty() {
        return String::new();
    }
    let rows = exact.chunk_by(|one, other| one.words == other.words).map(|row| {
        let fields: String = row.iter().map(Control::html).collect();
        let object = escape(row[0].words.strip_prefix("of ").unwrap_or(&row[0].words));
        format!("<span class=\"row\"><span>{object}</span>{fields}</span>")
    });
    let rows: String = rows.collect();
    format!("<details class=\"exact\"><summary>Exact values</summary>{rows}</details>")
}

/// The control of a parameter, with the words of its label.
struct Control<'a> {
    live: &'a Figure,
    k: usize,
    parameter: &'a Parameter,
    symbol: &'static str,
    words: String,
    /// Whether a handle sets this parameter, or a different coordinate of the same object.
    is_exact: bool,
}

impl<'a> Control<'a> {
    /// Describes the control of the parameter with index `k`. A coordinate of a handle is named
    /// after the handle.
    fn new(live: &'a Figure, k: usize, parameter: &'a Parameter) -> Self {
        let Parameter { words, group, .. } = parameter;
        let handle = live.handles.iter().find(|handle| handle.parameters.contains(&k));
        let handle = handle.filter(|_| group.is_empty());
        let mut set = live.handles.iter().flat_map(|handle| handle.parameters);
        let is_of_object = |k: usize| group.is_empty() && live.parameters[k].words == *words;
        let is_exact = handle.is_some() || !words.is_empty() && set.any(is_of_object);
        let (symbol, words) = match handle.filter(|_| words.is_empty()) {
            None => (parameter.symbol, words.clone()),
            Some(handle) => match handle.parameters {
                [x, y] if x == y => ("", handle.words.to_string()),
                [x, _] if x == k => ("x", format!("of {}", handle.words)),
                _ => ("y", format!("of {}", handle.words)),
            },
        };
        Self { live, k, parameter, symbol, words, is_exact }
    }

    /// The HTML of the control, set to its default. A parameter that a handle sets has only a
    /// number field, without a slider.
    fn html(&self) -> String {
        let Self { live, k, parameter, symbol, words, .. } = self;
        let Parameter { range: [min, max], steps_per_unit, default, group, .. } = parameter;
        let step = 1.0 / steps_per_unit;
        let range = format!("min=\"{min}\" max=\"{max}\" step=\"{step}\" value=\"{default}\"");
        let slider = format!("<input type=\"range\" {range}>");
        let name = escape(&format!("{symbol} {words}"));
        let number = format!("<input type=\"number\" aria-label=\"{name}\" {range}>");
        let label = label_html(symbol, words);
        let (class, content) = match parameter.control {
            ControlKind::Columns => Default::default(),
            ControlKind::Switch => {
                let checked = if *default == 1.0 { " checked" } else { "" };
                let field = format!("<input type=\"checkbox\"{checked}>");
                ("switch", format!("<label>{label}{field}</label>"))
            }
            ControlKind::Choice(_) => {
                let text = escape(&parameter.format(*default));
                let text = format!("<b aria-hidden=\"true\">{text}</b>");
                ("range", format!("<label>{label}{slider}</label>{text}"))
            }
            ControlKind::Number(unit) if self.is_exact => {
                let label = label_html(symbol, "");
                ("field", format!("<label>{label} {number}{}</label>", escape(unit)))
            }
            ControlKind::Number(unit) => {
                let field = format!("<span>{number}{}</span>", escape(unit));
                ("range", format!("<label>{label}{slider}</label>{field}"))
            }
        };
        let first = live.handles.first().map(|handle| handle.parameters[0]);
        let first_group = first.map_or("", |k| live.parameters[k].group);
        let has_control = (parameter.has_control)(parameter, &live.default_values());
        let hidden = if has_control && *group == first_group { "" } else { " hidden" };
        let group = match *group {
            "" => String::new(),
            group => format!(" data-group=\"{}\"", escape(group)),
        };
        format!("<div class=\"{class}\" data-parameter=\"{k}\"{group}{hidden}>{content}</div>")
    }
}

fn label_html(symbol: &str, words: &str) -> String {
    let symbol: String = symbol.chars().map(italic_letter).collect();
    let symbol = match symbol.as_str() {
        "" => symbol,
        _ => format!("<span class=\"symbol\" aria-hidden=\"true\">{}</span> ", escape(&symbol)),
    };
    format!("<span>{symbol}{}</span>", escape(words))
}
