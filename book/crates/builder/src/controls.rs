use figures::{ControlKind, Figure, Handle, Parameter, escape, italic_letter};

const HINT: &str = "<span class=\"hint\">Click or tap the picture, or move the cross \
                    with the arrow keys, to choose a pixel.</span>";

const RESET: &str = "<button type=\"button\" class=\"reset\" disabled>Reset</button>";

/// The controls below a figure or picture: one for each parameter but [`ControlKind::Columns`].
/// Number fields for what a handle sets are folded away.
///
/// Hidden where no script can answer, and there from the first where one
/// will, to be set as soon as it can; see book/theme/figure.js.
pub fn html(live: &Figure) -> String {
    let mut groups: Vec<_> = live.parameters.iter().map(|parameter| parameter.group).collect();
    groups.dedup();
    groups.retain(|group| !group.is_empty());
    let controls = live.parameters.iter().enumerate().map(|(k, parameter)| {
        let handle = live.handles.iter().find(|handle| handle.parameters.contains(&k));
        Control { live, k, parameter, handle: handle.filter(|_| parameter.group.is_empty()) }
    });
    let controls = controls.filter(|one| one.parameter.control != ControlKind::Columns);
    let (exact, others): (Vec<_>, Vec<_>) = controls.partition(Control::is_exact);
    let (above, below): (Vec<_>, Vec<_>) = others
        .iter()
        .partition(|one| groups.is_empty() || one.parameter.control == ControlKind::Switch);
    let [above, below] =
        [above, below].map(|some| some.into_iter().map(Control::html).collect::<String>());
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

/// The folded number fields, in a row for each object that they are of.
fn exact_html(exact: &[Control]) -> String {
    if exact.is_empty() {
        return String::new();
    }
    let words = |control: &Control| control.symbol_and_words().1;
    let rows = exact.chunk_by(|one, other| words(one) == words(other)).map(|row| {
        let of = words(&row[0]);
        let fields: String = row.iter().map(Control::html).collect();
        let of = escape(of.strip_prefix("of ").unwrap_or(&of));
        format!("<span class=\"row\"><span>{of}</span>{fields}</span>")
    });
    let rows: String = rows.collect();
    format!("<details class=\"exact\"><summary>Exact values</summary>{rows}</details>")
}

/// A parameter, its number, and the handle that sets it; None for one with a group.
struct Control<'a> {
    live: &'a Figure,
    k: usize,
    parameter: &'a Parameter,
    handle: Option<&'a Handle>,
}

impl Control<'_> {
    /// Whether a handle sets the parameter, or another coordinate of the same object.
    fn is_exact(&self) -> bool {
        let Parameter { words, group, .. } = self.parameter;
        let mut set = self.live.handles.iter().flat_map(|handle| handle.parameters);
        let is_of_object = |k: usize| group.is_empty() && self.live.parameters[k].words == *words;
        self.handle.is_some() || !words.is_empty() && set.any(is_of_object)
    }

    /// The control at its default. What a handle sets has no range beside its number field.
    fn html(&self) -> String {
        let Self { live, k, parameter, .. } = self;
        let (symbol, words) = self.symbol_and_words();
        let (class, content) = self.class_and_content(symbol, &words);
        let first = live.handles.first().map(|handle| handle.parameters[0]);
        let first_group = first.map_or("", |k| live.parameters[k].group);
        let has_control = (parameter.has_control)(parameter, &live.default_values());
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
            ControlKind::Number(unit) if self.is_exact() => {
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

fn label_html(symbol: &str, words: &str) -> String {
    let symbol: String = symbol.chars().map(italic_letter).collect();
    let symbol = match symbol.as_str() {
        "" => symbol,
        _ => format!("<span class=\"symbol\" aria-hidden=\"true\">{}</span> ", escape(&symbol)),
    };
    format!("<span>{symbol}{}</span>", escape(words))
}
