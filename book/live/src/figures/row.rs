use super::Figure;
use crate::svg::{Drawing, View};
use glam::{DVec2, dvec2};
use std::f64::consts::FRAC_PI_3;
use step01_rays::Row;

/// The row of rays in 2D, with V_0 and D.
pub fn figure() -> Figure {
    let row = Row::new(7, FRAC_PI_3);
    let view = View { origin: dvec2(240.0, 282.0), scale: DVec2::splat(205.0) };
    let c = view.at(DVec2::ZERO);
    let directions: Vec<DVec2> = (0..7).map(|i| row.direction(i.into())).collect();
    let mut drawing = Drawing::new(480.0, 320.0);
    drawing.line("plane", view.xy(-0.86, 1.0), view.xy(0.86, 1.0));
    drawing.line("guide", c, view.xy(0.0, 1.0));
    for &v in &directions[1..] {
        drawing.line("ray faint", c, view.at(1.28 * v));
    }
    let v_0 = directions[0];
    drawing.line("ray faint", view.at(v_0), view.at(1.28 * v_0));
    for &v in &directions {
        drawing.dot("ray", view.at(v));
    }
    drawing.arc("angle", c, 54.0, directions[6].to_angle(), v_0.to_angle());
    drawing.label("", c + dvec2(13.0, -64.0), "$θ$");
    drawing.arrow("vector", c, view.at(v_0));
    let step = |i: usize| [view.at(directions[i]), view.at(directions[i + 1])];
    for i in [0, 1] {
        let [from, to] = step(i);
        drawing.arrow("accent", from, to);
    }
    let [from, to] = step(1);
    drawing.label("accent", (from + to) / 2.0 + dvec2(4.0, 24.0), "$D$");
    let middle = view.at(0.55 * v_0);
    drawing.label_to("strong", middle + dvec2(-14.0, 4.0), "$V_0$");
    for i in [0, 1, 2, 6] {
        let end = view.at(1.28 * directions[i]);
        let label = format!("$i$ = {i}");
        drawing.label("quiet", end + dvec2(0.0, -8.0), &label);
    }
    let right = view.xy(0.86, 1.0) + dvec2(-14.0, 20.0);
    drawing.label_from("quiet", right, "image plane");
    drawing.dot("eye", c);
    drawing.label("strong", c + dvec2(0.0, 26.0), "$C$");
    let (end, tan) = (directions[6], directions[6].x);
    let corner = view.xy(tan, 0.0);
    drawing.line("guide", view.at(end), corner);
    drawing.line("guide", c, corner);
    let side = view.xy(tan, 0.5) + dvec2(10.0, 5.0);
    drawing.label_from("quiet", side, "1");
    let base = view.xy(tan / 2.0, 0.0) + dvec2(6.0, 22.0);
    drawing.label("quiet", base, "tan $θ$/2");
    Figure {
        title: "Seven rays fan out from the point C through a line at distance 1. An arrow V0 goes from C to the leftmost point on the line, and arrows D step along the line from each point to the next.",
        caption: "The row of rays for $\\mathit{hRes} = 7$ and $\\theta = 60°$. Follow $V_0$ to the left end \
                  of the image plane; from there, every step $D$ leads to the next ray. The dotted \
                  lines on the right are the sides of the triangle that gives half of its length.",
        drawing,
    }
}
