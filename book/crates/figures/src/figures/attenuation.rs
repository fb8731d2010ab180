//! How a light fades with distance.

use super::*;
use glam::dvec2;
use step04_diffuse::{Attenuation, WARM_LIGHT};

const A: ParameterId = ParameterId::new("a");
const B: ParameterId = ParameterId::new("b");
const C: ParameterId = ParameterId::new("c");

const CONTENT: Content = Content::Drawing {
    title: "Curves of 1 / (a + bd + cd²) over the distance d: constant for a alone, falling slowly with b, fast with c; the curve of the scene's warm light begins above them.",
    caption: "What a light gives at the distance $d$, in units of its $L_d$. With $a$ \
                  alone it never fades. With some $b$ it begins to fade at once. With some $c$ it hardly fades at \
                  first, but ends up lowest. The red curve is that of our warm light, with some of each<span class='move'>, until you change it</span>. \
                  At $d = 6$ it gives {{#number attenuation:share}}.",
    draw,
};

/// Curves that show how brightness depends on distance. The reader can set the a, b and c of one
/// curve.
pub fn figure() -> Figure {
    let Attenuation { a, b, c } = WARM_LIGHT.attenuation;
    let label = "of your curve";
    Figure {
        parameters: vec![
            // With the smallest allowed a, the curve begins at the highest line of the grid.
            Parameter::number(A, label, a, [0.5, 2.0], 20.0).with_symbol("a"),
            Parameter::number(B, label, b, [0.0, 1.0], 100.0).with_symbol("b"),
            Parameter::number(C, label, c, [0.0, 0.5], 200.0).with_symbol("c"),
        ],
        readouts: |values| {
            let share = 1.0 / attenuation(values).divisor(6.0);
            collect_readouts([("share", format_number(share))])
        },
        ..Figure::new("attenuation", CONTENT)
    }
}

/// The attenuation that the reader has set.
fn attenuation(values: &ParameterValues) -> Attenuation {
    Attenuation { a: values[A], b: values[B], c: values[C] }
}

/// Draws the axes, and four curves with their names.
fn draw(values: &ParameterValues) -> Drawing {
    let view = View { origin: dvec2(56.0, 230.0), scale: dvec2(22.0, 100.0) };
    let position = |d: f64, share: f64| view.xy_to_drawing(d, share);
    let mut drawing = Drawing::new(280.0);
    for share in [0.5, 1.0, 1.5, 2.0] {
        drawing.line("grid", position(0.0, share), position(14.0, share));
        drawing.label("quiet end", position(0.0, share) + dvec2(-8.0, 5.0), &share.to_string());
    }
    for d in [2.0, 4.0, 6.0, 8.0, 10.0, 12.0] {
        drawing.label("quiet", position(d, 0.0) + dvec2(0.0, 22.0), &d.to_string());
    }
    drawing.arrow("axis", view.origin, position(14.4, 0.0));
    drawing.arrow("axis", view.origin, position(0.0, 2.16));
    let from_1 = |b, c| Attenuation { a: 1.0, b, c };
    let yours = attenuation(values);
    let name = if yours == WARM_LIGHT.attenuation { "the warm light" } else { "your curve" };
    let mut curves = [
        ("curve curve-1", from_1(0.0, 0.0), "$a$ = 1"),
        ("curve curve-2", from_1(0.2, 0.0), "$a$ = 1, $b$ = 0.2"),
        ("curve curve-3", from_1(0.0, 0.1), "$a$ = 1, $c$ = 0.1"),
        ("curve curve-4", yours, name),
    ];
    for (class, attenuation, _) in &curves {
        let distances = (0..=100).map(|k| f64::from(k) * 0.14);
        drawing.path(class, distances.map(|d| position(d, 1.0 / attenuation.divisor(d))));
    }
    // Each curve's name is at the curve's end, or higher if the name would overlap the next name
    // below.
    curves.sort_by(|(_, a, _), (_, b, _)| b.divisor(14.0).total_cmp(&a.divisor(14.0)));
    let mut y = f64::INFINITY;
    for (class, attenuation, name) in curves {
        let end = position(14.0, 1.0 / attenuation.divisor(14.0)) + dvec2(14.0, 5.0);
        y = end.y.min(y - 18.0);
        drawing.label(&format!("{class} start"), end.with_y(y), name);
    }
    drawing.label("", position(14.0, 0.0) + dvec2(4.0, 22.0), "$d$");
    drawing
}
