use live::{Knob, Live, escape, italic};
use std::collections::BTreeSet;

/// The ranges and switches below what is live, for what no handle of it turns.
///
/// They are hidden where no script can answer, and are there from the first where one
/// will, to be turned as soon as it can; see book/theme/live.js.
pub fn html(live: &Live) -> String {
    let turned = turned(live);
    let shown =
        |(k, knob): &(usize, &Knob)| !knob.group.is_empty() || !turned.contains(k);
    let all: Vec<_> = live.knobs.iter().enumerate().filter(shown).collect();
    let labels = |is_asked: fn(&Knob) -> bool| -> String {
        let asked = all.iter().filter(|(_, knob)| is_asked(knob));
        asked.map(|(k, knob)| label(live, *k, knob)).collect()
    };
    let hint = if live.is_asked() { HINT } else { "" };
    let inside = match choice(live) {
        None => format!("{}{RESET}", labels(|_| true)),
        Some(choice) => format!(
            "<div class=\"choice\">{choice}{}{RESET}</div>{}",
            labels(is_switch),
            labels(|knob| !is_switch(knob))
        ),
    };
    format!("<div class=\"knobs\" hidden inert>{hint}{inside}</div>")
}

const HINT: &str = "<span class=\"hint\">Press on the picture, or move the cross by \
                    the arrow keys, to ask a pixel.</span>";

const RESET: &str =
    "<button type=\"button\" class=\"reset\" disabled>Reset</button>";

/// The knobs that a handle turns which is in what is printed.
fn turned(live: &Live) -> BTreeSet<usize> {
    let values = live.values();
    let [width, height] = live.printed().size();
    let handles = live.handles.iter().filter(|handle| {
        let at = handle.place(&values);
        (0.0..=width).contains(&at.x) && (0.0..=height).contains(&at.y)
    });
    handles.flat_map(|handle| handle.knobs).collect()
}

/// Where knobs are of several things, the choice of the one whose are to be seen.
fn choice(live: &Live) -> Option<String> {
    let mut things: Vec<_> = live.knobs.iter().map(|knob| knob.group).collect();
    things.dedup();
    things.retain(|thing| !thing.is_empty());
    let options: String =
        things.iter().map(|thing| format!("<option>{thing}</option>")).collect();
    let choice = format!("<label>Change <select>{options}</select></label>");
    (!things.is_empty()).then_some(choice)
}

/// Whether a knob has the two values off and on.
fn is_switch(knob: &Knob) -> bool {
    knob.choices == ["off", "on"]
}

/// The knob number `k` as it is set in the printed book.
fn label(live: &Live, k: usize, knob: &Knob) -> String {
    let (class, input) = match is_switch(knob) {
        true => ("switch", switch(knob)),
        false => ("range", range(knob)),
    };
    let first = live.handles.first().map_or("", |handle| {
        let [across, _] = handle.knobs;
        live.knobs[across].group
    });
    let is_shown = (knob.is_shown)(knob, &live.values()) && knob.group == first;
    let hidden = if is_shown { "" } else { " hidden" };
    let group = match knob.group {
        "" => String::new(),
        group => format!(" data-group=\"{group}\""),
    };
    let symbol: String = knob.symbol.chars().map(italic).collect();
    let symbol = match symbol.as_str() {
        "" => symbol,
        _ => format!(
            "<span class=\"symbol\" aria-hidden=\"true\">{}</span> ",
            escape(&symbol)
        ),
    };
    format!(
        "<label class=\"{class}\" data-knob=\"{k}\"{group}{hidden}>\
         <span>{symbol}{}</span>{input}</label>",
        escape(&knob.words)
    )
}

/// A range, and its value in words: a screen reader has it from the script.
fn range(knob: &Knob) -> String {
    let Knob { range: [min, max], steps, value, .. } = knob;
    let step = 1.0 / steps;
    format!(
        "<input type=\"range\" min=\"{min}\" max=\"{max}\" step=\"{step}\" \
         value=\"{value}\"><b aria-hidden=\"true\">{}</b>",
        escape(&knob.text(*value))
    )
}

fn switch(knob: &Knob) -> String {
    let checked = if knob.value == 1.0 { " checked" } else { "" };
    format!("<input type=\"checkbox\"{checked}>")
}
