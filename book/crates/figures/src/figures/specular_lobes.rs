//! The shape of a highlight for several exponents.

use super::*;
use std::f64::consts::{FRAC_PI_4, PI};

const VIEW: View = View { origin: dvec2(176.0, 258.0), scale: dvec2(222.0, 222.0) };

const EXPONENT: ParameterId = ParameterId::new("exponent");
const ANGLE: ParameterId = ParameterId::new("angle");

const CONTENT: Content = Content::Drawing {
    title: "Lobes around the reflection vector r: for the exponents 1, 10, 40 and 150, they get narrower and narrower, and all have the same length along r.",
    caption: "The highlight $\\max(r \\cdot v, 0)^n$, drawn as a shape, a *lobe*: the brighter it is in a direction $v$, \
                  the further the lobe reaches. All lobes are equally long along $r$; a larger $n$ makes them narrower. \
                  Where a lobe crosses the dotted circle, the highlight is down to one half. \
                  <span class='move'>Turn the light, and let $n$ grow.</span>",
    draw,
};

/// The light, and one lobe for each of several exponents. The reader can set one of the exponents.
pub fn figure() -> Figure {
    Figure {
        parameters: vec![
            Parameter::number(EXPONENT, "of one of the lobes", 150.0, [1.0, 300.0], 1.0)
                .with_symbol("n"),
            Parameter::number(ANGLE, "angle of the light", 45.0, [5.0, 50.0], 1.0).with_unit("°"),
        ],
        handles: vec![Handle::of_degrees_left_of_up("the light l", ANGLE, VIEW, 0.85)],
        ..Figure::new("lobes", CONTENT)
    }
}

/// Draws the lobes and their legend. Also draws the vectors l, n and r, and an arc at half the
/// length of the lobes.
fn draw(values: &ParameterValues) -> Drawing {
    let reader_n = values[EXPONENT] as i32;
    // r is as far to the right of n as the light is to the left.
    let r = DVec2::from_angle((90.0 - values[ANGLE]).to_radians());
    let mut drawing = Drawing::new(300.0);
    drawing.line("plane", dvec2(30.0, 258.0), dvec2(450.0, 258.0));
    let on_lobe = |n: i32, v: DVec2| VIEW.to_drawing(r.dot(v).max(0.0).powi(n) * v);
    // The lobe for the reader's exponent comes last, so that it is on top of the other lobes.
    let mut exponents = vec![1, 10, 40];
    exponents.retain(|&n| n != reader_n);
    exponents.push(reader_n);
    let class_of = |n: i32| if n == reader_n { "lobe chosen" } else { "lobe" };
    for &n in &exponents {
        let directions = (0..=180).map(|k| DVec2::from_angle(f64::from(k).to_radians()));
        drawing.area(class_of(n), directions.map(|v| on_lobe(n, v)));
    }
    drawing.arc("guide", VIEW.origin, 111.0, [0.0, PI]);
    for (class, tip, name, shift) in [
        ("light", 0.85 * dvec2(-r.x, r.y), "$l$", dvec2(-18.0, -6.0)),
        ("second", 0.85 * DVec2::Y, "$n$", dvec2(0.0, -8.0)),
        ("vector", 1.12 * r, "$r$", dvec2(10.0, -2.0)),
    ] {
        drawing.arrow(class, VIEW.origin, VIEW.to_drawing(tip));
        drawing.label("strong over", VIEW.to_drawing(tip) + shift, name);
    }
    // The legend lists the exponents, with the smallest at the bottom.
    exponents.pop();
    exponents.insert(exponents.partition_point(|&n| n < reader_n), reader_n);
    for (n, (angle, y)) in
        exponents.into_iter().zip([(0.12, 226.0), (0.44, 190.0), (0.6, 154.0), (0.7, 118.0)])
    {
        // A line leads from the exponent to a point on the exponent's lobe. The point is to the
        // right of r and above the ground.
        let v = DVec2::from_angle((r.to_angle() - FRAC_PI_4 + angle).max(0.0));
        let label = dvec2(418.0, y);
        drawing.line("axis", on_lobe(n, v), label - dvec2(5.0, 5.0));
        let class = if n == reader_n { "accent start" } else { "quiet start" };
        drawing.label(class, label, &n.to_string());
    }
    drawing.label("quiet start", dvec2(418.0, 90.0), "$n$ =");
    drawing.label("quiet", VIEW.origin + dvec2(-111.0, 22.0), "one half");
    drawing
}
