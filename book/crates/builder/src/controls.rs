use figures::{ControlKind, Figure, Handle, Parameter, escape, italic_letter};

const HINT: &str = "<span class=\"hint\">Click or tap the picture, or move the cross \
                    with the arrow keys, to choose a pixel.</span>";

const RESET: &str = "<button type=\"button\" class=\"reset\" disabled>Reset</button>";

/// The controls below a figure or picture: one for each parameter that has a name. Number
/// fields for what a handle sets are folded away.
///
/// Hidden where no script can answer, and there from the first where one
/// will, to be set as soon as it can; see book/theme/figure.js.
pub fn html(live: &Figure) -> String {
    let mut groups: Vec<_> = live.parameters.iter().map(|parameter| parameter.group).collect();
    groups.dedup();
    groups.retain(|group| !group.is_empty());
    let (mut switches, mut others) = (String::new(), String::new());
    let (exact, controls) = exact_and_other_controls(live);
    for control in controls {
        let is_above = groups.is_empty() || control.parameter.control == ControlKind::Switch;
        *if is_above { &mut switches } else { &mut others } += &control.html(live);
    }
    let hint = if live.has_probe() { HINT } else { "" };
    let content = if groups.is_empty() {
        format!("{switches}{}{RESET}", exact_html(live, &exact))
    } else {
        let options = groups.iter().map(|group| format!("<option>{}</option>", escape(group)));
        let options: String = options.collect();
        format!(
            "<div class=\"choice\"><label>Change <select>{options}</select></label>\
             {switches}{RESET}</div>{others}"
        )
    };
    format!("<div class=\"controls\" hidden inert>{hint}{content}</div>")
}

/// The folded number fields, in a row for each object that they are of.
fn exact_html(live: &Figure, exact: &[Control]) -> String {
    let words = |control: &Control| control.symbol_and_words().1;
    let rows = exact.chunk_by(|one, other| words(one) == words(other)).map(|row| {
        let of = words(&row[0]);
        let fields: String = row.iter().map(|control| control.html(live)).collect();
        let of = escape(of.strip_prefix("of ").unwrap_or(&of));
        format!("<span class=\"row\"><span>{of}</span>{fields}</span>")
    });
    let rows: String = rows.collect();
    if rows.is_empty() {
        return rows;
    }
    format!("<details class=\"exact\"><summary>Exact values</summary>{rows}</details>")
}

/// A parameter, its number, and the handle that sets it.
struct Control<'a> {
    k: usize,
    parameter: &'a Parameter,
    handle: Option<&'a Handle>,
    is_exact: bool,
}

/// The controls of what a handle sets, with the other coordinates of the same object; and
/// all others. What has a group is in its fields alone.
fn exact_and_other_controls(live: &Figure) -> (Vec<Control<'_>>, Vec<Control<'_>>) {
    let parameters = live.parameters.iter().enumerate();
    let parameters = parameters.filter(|(_, parameter)| parameter.control != ControlKind::Columns);
    let mut controls: Vec<_> = parameters
        .map(|(k, parameter)| {
            let mut handles = live.handles.iter().filter(|_| parameter.group.is_empty());
            let handle = handles.find(|handle| handle.parameters.contains(&k));
            Control { k, parameter, handle, is_exact: handle.is_some() }
        })
        .collect();
    let objects: Vec<_> = controls.iter().filter(|control| control.is_exact).collect();
    let objects: Vec<_> = objects.iter().map(|control| control.symbol_and_words().1).collect();
    for control in &mut controls {
        control.is_exact |= objects.contains(&control.parameter.words);
    }
    controls.into_iter().partition(|control| control.is_exact)
}

impl Control<'_> {
    /// The control at its default. What a handle sets has no range beside its number field.
    fn html(&self, live: &Figure) -> String {
        let (symbol, words) = self.symbol_and_words();
        let (class, content) = self.class_and_content(symbol, &words);
        let Self { k, parameter, .. } = self;
        let first_group = live.handles.first().map_or("", |handle| {
            let [first, _] = handle.parameters;
            live.parameters[first].group
        });
        let has_control = parameter.has_control(&live.default_values());
        let is_visible = has_control && parameter.group == first_group;
        let hidden = if is_visible { "" } else { " hidden" };
        let group = match parameter.group {
            "" => String::new(),
            group => format!(" data-group=\"{}\"", escape(group)),
        };
        format!("<div class=\"{class}\" data-parameter=\"{k}\"{group}{hidden}>{content}</div>")
    }

    /// The class of the control, and its label with its fields.
    fn class_and_content(&self, symbol: &str, words: &str) -> (&'static str, String) {
        let Parameter { range: [min, max], steps_per_unit, default, .. } = self.parameter;
        let step = 1.0 / steps_per_unit;
        let range = format!("min=\"{min}\" max=\"{max}\" step=\"{step}\" value=\"{default}\"");
        let slider = format!("<input type=\"range\" {range}>");
        let name = escape(&format!("{symbol} {words}"));
        let number = format!("<input type=\"number\" aria-label=\"{name}\" {range}>");
        let label = label_html(symbol, words);
        match self.parameter.control {
            ControlKind::Columns => Default::default(),
            ControlKind::Switch => {
                let checked = if *default == 1.0 { " checked" } else { "" };
                let field = format!("<input type=\"checkbox\"{checked}>");
                ("switch", format!("<label>{label}{field}</label>"))
            }
            ControlKind::Choice(_) => {
                let text = escape(&self.parameter.format(*default));
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
        }
    }

    /// The symbol and the words of the parameter; a coordinate of a handle is called by it.
    fn symbol_and_words(&self) -> (&'static str, String) {
        match self.handle {
            Some(handle) if self.parameter.words.is_empty() => match handle.parameters {
                [first, second] if first == second => ("", handle.words.to_string()),
                [first, _] if first == self.k => ("x", format!("of {}", handle.words)),
                _ => ("y", format!("of {}", handle.words)),
            },
            _ => (self.parameter.symbol, self.parameter.words.clone()),
        }
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
