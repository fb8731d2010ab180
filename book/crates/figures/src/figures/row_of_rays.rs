//! A row of rays in a plane.

use super::*;
use course::FOV_DEGREES;
use course::examples::row::Row;
use std::f64::consts::PI;

/// The position of C in the drawing.
const ORIGIN: DVec2 = dvec2(240.0, 294.0);

const RAYS: ParameterId = ParameterId::new("rays");
const FIELD_OF_VIEW: ParameterId = ParameterId::new("field of view");
const DIVIDES_BY_RAYS: ParameterId = ParameterId::new("divide by hRes");

const CONTENT: Content = Content::Drawing {
    title: "Seven rays fan out from the point C through a line at distance 1. An arrow V0 goes from C to the leftmost point on the line, and two arrows D step along the line from there, each to the next point.",
    caption: "Follow $V_0$ to the first pixel; from there, every step $D$ leads to the next ray. \
                  Here, $\\mathit{hRes} = {{#number row:hRes}}$, $\\theta = {{#number row:angle}}°$ and $D = ({{#number row:D}}, 0)$. \
                  <span class='move'>Drag the tip of $V_0$ to make the view wider, and add rays.</span>",
    draw,
};

/// A row of rays in 2D, with V_0 and D.
pub fn figure() -> Figure {
    Figure {
        parameters: vec![
            Parameter::number(RAYS, "rays", 7.0, [2.0, 25.0], 1.0).with_symbol("hRes"),
            Parameter::number(FIELD_OF_VIEW, "field of view", FOV_DEGREES, [10.0, 150.0], 1.0)
                .with_symbol("θ")
                .with_unit("°"),
            Parameter::switch(DIVIDES_BY_RAYS, "divide the width by hRes, not by hRes − 1", false),
        ],
        handles: vec![Handle::of_parameter(
            "the tip of V0, which opens the field of view",
            FIELD_OF_VIEW,
            |values| view(&row(values)).to_drawing(row(values).direction(0.0)),
            |values, position| 2.0 * view(&row(values)).degrees_left_of_up(position),
        )],
        readouts,
        ..Figure::new("row", CONTENT)
    }
}

/// The row of rays with these values. If the reader divides by hRes rather than hRes − 1, D is too
/// short.
fn row(values: &ParameterValues) -> Row {
    let rays = values[RAYS];
    let mut row = Row::new(rays as u32, values[FIELD_OF_VIEW].to_radians());
    if values.is_on(DIVIDES_BY_RAYS) {
        row.matrix.x_axis *= (rays - 1.0) / rays;
    }
    row
}

/// Maps the plane of the rays to the drawing. If the field of view is wide, the scale is smaller.
fn view(row: &Row) -> View {
    let tan = -row.direction(0.0).x;
    View { origin: ORIGIN, scale: DVec2::splat(205.0 * (0.84 / tan).min(1.0)) }
}

/// Draws the row of rays, V_0, two of the steps D, and the triangle that gives tan(θ/2).
fn draw(values: &ParameterValues) -> Drawing {
    let row = row(values);
    let view = view(&row);
    let c = ORIGIN;
    let directions = (0..values[RAYS] as u32).map(|i| row.direction(f64::from(i)));
    let directions: Vec<DVec2> = directions.collect();
    let (v_0, last_index) = (directions[0], directions.len() - 1);
    let tips: Vec<DVec2> = directions.iter().map(|&v| view.to_drawing(v)).collect();
    let tan = -v_0.x;
    let side = (1.02 * tan).max(0.86);
    let mut drawing = Drawing::new(332.0);
    drawing.line("plane", view.xy_to_drawing(-side, 1.0), view.xy_to_drawing(side, 1.0));
    drawing.line("guide", c, view.xy_to_drawing(0.0, 1.0));
    for (i, &v) in directions.iter().enumerate() {
        let end = view.to_drawing(1.28 * v);
        drawing.line("ray faint", c, end);
        drawing.dot("ray", tips[i]);
        if [0, last_index].contains(&i) {
            // In a narrow field of view, the labels of the first and the last ray would overlap, so
            // they are moved apart.
            let x = if i == 0 { end.x.min(c.x - 26.0) } else { end.x.max(c.x + 26.0) };
            drawing.label("quiet", dvec2(x, end.y - 8.0), &format!("$i$ = {i}"));
        }
    }
    drawing.arc("axis", c, 54.0, [PI - v_0.to_angle(), v_0.to_angle()]);
    drawing.label("over", c + dvec2(13.0, -64.0), "$θ$");
    drawing.arrow("vector", c, tips[0]);
    // The label of V_0 is to the left of the arrow V_0.
    let label_offset = 20.0 * (tips[0] - c).normalize().perp();
    drawing.label("strong", (c + tips[0]) / 2.0 - label_offset + dvec2(0.0, 6.0), "$V_0$");
    for step in tips.windows(2).take(2) {
        drawing.arrow("accent", step[0], step[1]);
    }
    drawing.label("accent over", (tips[0] + tips[1]) / 2.0 + dvec2(0.0, -10.0), "$D$");
    drawing.dot("eye", c);
    drawing.label("strong", c + dvec2(0.0, 26.0), "$C$");
    // The legs of a right triangle. The angle between the leg of length 1 and the hypotenuse is
    // θ/2.
    let corner = view.xy_to_drawing(tan, 0.0);
    drawing.path("guide", [c, corner, view.xy_to_drawing(tan, 1.0)]);
    drawing.label("quiet start", view.xy_to_drawing(tan, 0.5) + dvec2(10.0, 5.0), "1");
    let label = view.xy_to_drawing(tan / 2.0, 0.0) + dvec2(6.0, 22.0);
    drawing.label("quiet", label.max(c + dvec2(46.0, 0.0)), "tan($θ$/2)");
    drawing
}

fn readouts(values: &ParameterValues) -> Readouts {
    collect_readouts([
        ("hRes", format_number(values[RAYS])),
        ("angle", format_number(values[FIELD_OF_VIEW])),
        ("D", format_number(row(values).matrix.x_axis.x)),
    ])
}
