//! The controls below an interactive figure.

use course::escape_html;
use figures::{Figure, Parameter, ParameterKind, italic_letter};

const HINT: &str = "<span class=\"hint\">Click or tap the picture, or move the cross \
                    with the arrow keys, to choose a pixel.</span>";

/// The hint below a preview of an editable scene. book/theme/own_scene.js adds the reader's scene
/// to the address of the link in this hint.
const SCENE_HINT: &str = "<span class=\"hint\">Drag a ball, and the code of step 5 draws the \
                          picture again. When you want more, <a href=\"own_scene.html\">A scene of \
                          your own</a> goes on from here.</span>";

const RESET: &str = "<button type=\"button\" class=\"reset\" disabled>Reset</button>";

/// Returns the HTML of the controls below a figure. Each parameter has a control. If a handle sets
/// a parameter, the parameter's control is a number field in a folded box. In an editable scene, no
/// control is folded. Instead the reader chooses an object, and the page shows only the controls
/// for that object. Some of these controls aren't in the HTML, because a script adds them.
///
/// The HTML hides the controls, since they don't work without scripts. If scripts are enabled,
/// book/theme/css/live.css shows the controls from the start. The controls work once the module has
/// loaded.
pub fn controls_html(figure: &Figure) -> String {
    let (mut folded_controls, mut html_above, mut html_below) =
        (vec![], String::new(), String::new());
    for parameter in &figure.parameters {
        let control = Control { figure, parameter };
        if control.is_added_by_script() {
            continue;
        }
        if control.is_folded() {
            folded_controls.push(control);
        } else if parameter.kind == ParameterKind::Switch || figure.editable_scene.is_none() {
            html_above += &control.html();
        } else {
            html_below += &control.html();
        }
    }
    let hint = if figure.probe().is_some() { HINT } else { "" };
    let content = if figure.editable_scene.is_some() {
        let mut objects: Vec<_> =
            figure.parameters.iter().filter_map(|parameter| parameter.id.object()).collect();
        objects.dedup();
        let options: String = objects
            .iter()
            .map(|object| format!("<option>{}</option>", escape_html(object)))
            .collect();
        format!(
            "<div class=\"choice\"><label>Change <select>{options}</select></label>\
             {html_above}{RESET}</div>{html_below}"
        )
    } else {
        format!("{html_above}{}{RESET}", folded_fields_html(&folded_controls))
    };
    let tool = if figure.editable_scene.is_some() { " tool" } else { "" };
    format!("<div class=\"controls{tool}\" hidden>{hint}{content}</div>")
}

/// Returns the HTML of the hint below a preview. A preview is a picture that only becomes
/// interactive when a reader points at the picture or focuses it.
pub fn preview_hint_html(figure: &Figure) -> String {
    let hint = if figure.editable_scene.is_some() { SCENE_HINT } else { HINT };
    format!("<div class=\"controls\" hidden>{hint}</div>")
}

/// Returns the HTML of the folded number fields. The coordinates of an object share a row.
fn folded_fields_html(folded: &[Control]) -> String {
    if folded.is_empty() {
        return String::new();
    }
    let object = |control: &Control| control.parameter.id.object();
    let is_same_row = |control: &Control, next: &Control| {
        object(control).is_some() && object(control) == object(next)
    };
    let rows = folded.chunk_by(is_same_row).map(|row| {
        let fields: String = row.iter().map(Control::html).collect();
        let label = escape_html(object(&row[0]).unwrap_or(&row[0].parameter.label));
        format!("<div class=\"row\"><span>{label}</span>{fields}</div>")
    });
    let rows: String = rows.collect();
    format!("<details class=\"exact\"><summary>Exact values</summary>{rows}</details>")
}

/// The control for one parameter of a figure.
struct Control<'a> {
    figure: &'a Figure,
    parameter: &'a Parameter,
}

impl Control<'_> {
    /// Whether the control is a folded number field. A control is folded if a handle sets its
    /// parameter, or sets another coordinate of the same object. In an editable scene, no control
    /// is folded.
    fn is_folded(&self) -> bool {
        let Self { figure, parameter } = self;
        let is_moved =
            figure.handles.iter().any(|handle| handle.moves_parameter_or_its_object(parameter.id));
        is_moved && figure.editable_scene.is_none()
    }

    /// The object that the reader has to choose before the page shows this control. Returns None if
    /// the control doesn't depend on the choice of an object.
    fn object_that_shows_it(&self) -> Option<&'static str> {
        self.figure.editable_scene.as_ref().and(self.parameter.id.object())
    }

    /// Whether the HTML leaves the control out, for a script to add. In an editable scene, the HTML
    /// leaves out the controls of an object if an earlier object has parameters with the same
    /// names. book/theme/figure.js then copies the controls of that earlier object. If the HTML
    /// contained all controls, two thirds of the page would be such copies.
    fn is_added_by_script(&self) -> bool {
        let parameters = &self.figure.parameters;
        let names = |object: &str| -> Vec<_> {
            let owned = parameters.iter().filter(|parameter| parameter.id.object() == Some(object));
            owned.map(|parameter| parameter.id.name()).collect()
        };
        self.object_that_shows_it().is_some_and(|object| {
            let mut objects = parameters.iter().filter_map(|parameter| parameter.id.object());
            objects.find(|candidate| names(candidate) == names(object)) != Some(object)
        })
    }

    /// Whether the control is shown before the reader changes anything. In an editable scene, only
    /// the controls of one object are shown at first: the object that the first handle moves.
    fn is_shown_at_first(&self) -> bool {
        let Self { figure, parameter } = self;
        let handle = figure.handles.first().filter(|_| figure.editable_scene.is_some());
        let is_of_first_object =
            self.object_that_shows_it() == handle.and_then(|handle| handle.horizontal.object());
        (parameter.has_control)(parameter, &figure.default_values()) && is_of_first_object
    }

    /// Returns the HTML of the control, set to the parameter's default value. A folded control has
    /// no slider.
    fn html(&self) -> String {
        let Parameter { id, symbol, label, unit, range: [min, max], default, .. } = self.parameter;
        let step = self.parameter.step();
        let range = format!("min=\"{min}\" max=\"{max}\" step=\"{step}\"");
        let name = escape_html(format!("{symbol} {label}").trim());
        let slider =
            format!("<input type=\"range\" {range} value=\"{default}\" aria-label=\"{name}\">");
        // This number field has no limits and no step, because book/theme/figure.js turns it into a
        // text field, and gets the limits and the step from the module `live`.
        let number = format!("<input type=\"number\" aria-label=\"{name}\" value=\"{default}\">");
        let label_element = label_html(symbol, label);
        let (class, content) = match self.parameter.kind {
            ParameterKind::Switch => {
                let checked = if *default == 1.0 { " checked" } else { "" };
                let field = format!("<input type=\"checkbox\"{checked}>");
                ("switch", format!("<label>{label_element}{field}</label>"))
            }
            ParameterKind::Choice(_) => {
                let text = escape_html(&self.parameter.format(*default));
                let text = format!("<b aria-hidden=\"true\">{text}</b>");
                ("range", format!("<label>{label_element}{slider}</label>{text}"))
            }
            ParameterKind::Number if self.is_folded() => {
                let symbol_element = label_html(symbol, "");
                ("field", format!("<label>{symbol_element} {number}{}</label>", escape_html(unit)))
            }
            ParameterKind::Number => {
                let field = format!("<span>{number}{}</span>", escape_html(unit));
                ("range", format!("<label>{label_element}{slider}</label>{field}"))
            }
        };
        let hidden = if self.is_shown_at_first() { "" } else { " hidden" };
        let object = self
            .object_that_shows_it()
            .map_or(String::new(), |object| format!(" data-object=\"{}\"", escape_html(object)));
        format!("<div class=\"{class}\" data-parameter=\"{id}\"{object}{hidden}>{content}</div>")
    }
}

fn label_html(symbol: &str, label: &str) -> String {
    let symbol: String = symbol.chars().map(italic_letter).collect();
    let symbol = match symbol.as_str() {
        "" => symbol,
        _ => {
            format!("<span class=\"symbol\" aria-hidden=\"true\">{}</span> ", escape_html(&symbol))
        }
    };
    format!("<span>{symbol}{}</span>", escape_html(label))
}

#[cfg(test)]
mod tests {
    use super::*;
    use figures::find_figure;

    fn control_html(figure: &str, id: &str) -> String {
        let figure = find_figure(figure).expect("the figure exists");
        let has_id = |parameter: &&Parameter| parameter.id.to_string() == id;
        let parameter = figure.parameters.iter().find(has_id).expect("the parameter exists");
        Control { figure, parameter }.html()
    }

    #[test]
    fn control_matches_the_kind_of_its_parameter() {
        for (figure, id, class, tag) in [
            ("row", "rays", "range", "<input type=\"range\" min=\"2\" max=\"25\" step=\"1\""),
            ("row", "field-of-view", "field", "<input type=\"number\""),
            ("row", "divide-by-hRes", "switch", "<input type=\"checkbox\">"),
            ("step01_rays", "aspect-ratio", "range", "<b aria-hidden=\"true\">16:9</b>"),
        ] {
            let html = control_html(figure, id);
            assert!(html.contains(tag), "{html}");
            assert!(html.starts_with(&format!("<div class=\"{class}\" data-parameter=\"{id}\"")));
        }
    }

    #[test]
    fn control_of_an_object_is_hidden_until_the_object_is_chosen() {
        assert!(
            control_html("own_scene", "red-sphere-radius").contains("data-object=\"red sphere\">")
        );
        let unchosen = control_html("own_scene", "blue-sphere-radius");
        assert!(unchosen.contains("data-object=\"blue sphere\" hidden>"), "{unchosen}");
    }

    #[test]
    fn each_control_that_the_script_adds_has_a_printed_control_to_copy() {
        let figure = find_figure("own_scene").expect("the figure exists");
        let controls = figure.parameters.iter().map(|parameter| Control { figure, parameter });
        let (added_controls, printed_controls): (Vec<_>, Vec<_>) =
            controls.partition(Control::is_added_by_script);
        for Control { parameter, .. } in added_controls {
            let has_same_name = |control: &&Control| {
                let Parameter { id, .. } = control.parameter;
                id.object().is_some() && id.name() == parameter.id.name()
            };
            let model =
                printed_controls.iter().find(has_same_name).expect("there is a printed control");
            let text = |parameter: &Parameter| {
                let Parameter { kind, symbol, label, unit, .. } = parameter;
                format!("{kind:?} {symbol} {label} {unit}")
            };
            assert_eq!(text(model.parameter), text(parameter), "{}", parameter.id);
        }
    }

    #[test]
    fn exact_values_have_a_row_for_each_object() {
        let html = controls_html(find_figure("three-cases").expect("the figure exists"));
        assert_eq!(html.matches("<div class=\"row\">").count(), 3);
        assert!(html.contains("<span>the start of the left ray</span>"));
        // A parameter that belongs to no object has a row of its own.
        let html = controls_html(find_figure("frustum").expect("the figure exists"));
        for label in ["near plane", "far plane"] {
            assert!(html.contains(&format!("<div class=\"row\"><span>{label}</span>")), "{html}");
        }
    }
}
