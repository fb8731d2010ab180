use crate::Row;
use crate::live::{Handle, Knob, Live, Sight, named, number};
use crate::svg::{Drawing, View, degrees_left};
use glam::{DVec2, dvec2};

/// Where in the drawing C is.
const ORIGIN: DVec2 = dvec2(240.0, 294.0);

fn row(values: &[f64]) -> Row {
    let mut row = Row::new(values[0] as u32, values[1].to_radians());
    if values[2] == 1.0 {
        row.matrix.x_axis *= (values[0] - 1.0) / values[0];
    }
    row
}

/// A wide row is drawn smaller.
fn view(values: &[f64]) -> View {
    let tan = row(values).direction(0.0).x.abs();
    View { origin: ORIGIN, scale: DVec2::splat(205.0 * (0.84 / tan).min(1.0)) }
}

fn draw(values: &[f64]) -> Drawing {
    let (row, view) = (row(values), view(values));
    let last = values[0] as usize - 1;
    let c = view.at(DVec2::ZERO);
    let directions: Vec<DVec2> =
        (0..=last).map(|i| row.direction(i as f64)).collect();
    let mut drawing = Drawing::new(480.0, 332.0);
    let tan = -directions[0].x;
    let side = (1.02 * tan).max(0.86);
    drawing.line("plane", view.xy(-side, 1.0), view.xy(side, 1.0));
    drawing.line("guide", c, view.xy(0.0, 1.0));
    for &v in &directions[1..] {
        drawing.line("ray faint", c, view.at(1.28 * v));
    }
    let v_0 = directions[0];
    drawing.line("ray faint", view.at(v_0), view.at(1.28 * v_0));
    for &v in &directions {
        drawing.dot("ray", view.at(v));
    }
    drawing.arc("angle", c, 54.0, [directions[last].to_angle(), v_0.to_angle()]);
    drawing.label("", c + dvec2(13.0, -64.0), "$θ$");
    drawing.arrow("vector", c, view.at(v_0));
    let step = |i: usize| [view.at(directions[i]), view.at(directions[i + 1])];
    for i in 0..last.min(2) {
        let [from, to] = step(i);
        drawing.arrow("accent", from, to);
    }
    let [from, to] = step(last.min(2) - 1);
    drawing.label("accent over", (from + to) / 2.0 + dvec2(0.0, -10.0), "$D$");
    let middle = view.at(0.55 * v_0);
    drawing.label_to("strong", middle + dvec2(-14.0, 4.0), "$V_0$");
    let [from, to] = step(0);
    let is_wide = 36.0 < to.x - from.x;
    let named = (0..=last).filter(|i| [0, last].contains(i) || *i < 3 && is_wide);
    for i in named {
        let end = view.at(1.28 * directions[i]);
        let label = format!("$i$ = {i}");
        drawing.label("quiet", end + dvec2(0.0, -8.0), &label);
    }
    if values[1] <= 75.0 {
        let right = view.xy(side, 1.0) + dvec2(-14.0, 20.0);
        drawing.label_from("quiet", right, "image plane");
    }
    drawing.dot("eye", c);
    drawing.label("strong", c + dvec2(0.0, 26.0), "$C$");
    let corner = view.xy(tan, 0.0);
    drawing.line("guide", view.xy(tan, 1.0), corner);
    drawing.line("guide", c, corner);
    let side = view.xy(tan, 0.5) + dvec2(10.0, 5.0);
    drawing.label_from("quiet", side, "1");
    let base =
        (view.xy(tan / 2.0, 0.0) + dvec2(6.0, 22.0)).max(c + dvec2(46.0, 0.0));
    drawing.label("quiet", base, "tan $θ$/2");
    drawing
}

/// The row of rays in 2D, with V_0 and D.
pub fn figure() -> Live {
    Live {
        title: "Seven rays fan out from the point C through a line at distance 1. An arrow V0 goes from C to the leftmost point on the line, and arrows D step along the line from each point to the next.",
        caption: "Follow $V_0$ to the left end of the image plane; from there, every step $D$ leads to the next ray. \
                  Here, $\\mathit{hRes} = {{#number row:hRes}}$, $\\theta = {{#number row:angle}}°$ and $D = ({{#number row:D}}, 0)$. \
                  <span class='move'>Drag the tip of $V_0$ to make the view wider, and add rays.</span>",
        knobs: vec![
            Knob::new(["hRes", "rays", ""], 7.0, [2.0, 25.0], 1.0),
            Knob::new(["θ", "field of view", "°"], 60.0, [10.0, 150.0], 1.0),
            Knob::choice("D divides by", 0.0, &["hRes − 1", "hRes"]),
        ],
        handles: vec![Handle::new(
            "the tip of V0, which opens the field of view",
            [1, 1],
            |_, values| view(values).at(row(values).direction(0.0)),
            |_, _, to| DVec2::splat(2.0 * degrees_left(ORIGIN, to)),
        )],
        numbers: |values| {
            let row = row(values);
            named([
                ("hRes", number(values[0])),
                ("angle", number(values[1])),
                ("D", number(row.matrix.x_axis.x)),
            ])
        },
        ..Live::new("row", |values| Sight::Drawing(draw(values)))
    }
}
