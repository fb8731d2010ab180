//! A false highlight: the formula on the lecture's slide draws a highlight even where the light is
//! behind the surface.

use super::*;
use step05_phong::reflect;

/// Maps the plane of the vectors to the drawing. The origin is the point near the rim, where all
/// four vectors start.
const VIEW: View = View { origin: dvec2(240.0, 150.0), scale: DVec2::splat(160.0) };

/// The ball's radius in the drawing.
const RADIUS: f64 = 640.0;

const ANGLE: ParameterId = ParameterId::new("angle");

const CONTENT: Content = Content::Drawing {
    title: "The top of a ball. The lamp is far away on the left, a little lower than a point near the top, and the eye is far away on the right. At that point, l leads left and down into the ball, and its mirror image r leads right and down into the ball, not far from v, which leads right to the eye.",
    caption: "The rim, from the side: $l$ leads to the lamp and $v$ to you. The lamp is behind the surface: $n \\cdot l =$ {{#number rim:nl}}. \
              And yet $r \\cdot v =$ {{#number rim:rv}}, as if there were a highlight. \
              <span class='move'>Turn the lamp until it's in front, and see where $r$ goes then.</span>",
    draw,
};

/// A point near the rim of a ball, and a lamp on the far side of the ball. The reader can turn the
/// lamp.
pub fn figure() -> Figure {
    let angle =
        Parameter::number(ANGLE, "angle of the lamp", 96.0, [40.0, 125.0], 1.0).with_unit("°");
    Figure {
        parameters: vec![angle],
        handles: vec![Handle::of_degrees_left_of_up("the lamp", ANGLE, VIEW, 1.0)],
        readouts: |values| {
            let [n, l, r, v] = phong_vectors(values);
            let [nl, rv] = [n.dot(l), r.dot(v)].map(|cosine| format_with_max_decimals(cosine, 2));
            collect_readouts([("nl", nl), ("rv", rv)])
        },
        ..Figure::new("rim", CONTENT)
    }
}

/// The unit vectors n, l, r and v. The vector n leans a little towards the eye.
fn phong_vectors(values: &ParameterValues) -> [DVec3; 4] {
    let [n, l, v] =
        [-8.0, values[ANGLE], -90.0].map(|angle| direction_left_of_up(angle).extend(0.0));
    [n, l, reflect(n, l), v]
}

/// Draws the top of the ball, and the four vectors at a point near the rim.
fn draw(values: &ParameterValues) -> Drawing {
    let mut drawing = Drawing::new(314.0);
    let p = VIEW.origin;
    let [n, l, r, v] = phong_vectors(values);
    let up = dvec2(n.x, -n.y);
    drawing.circle("object", p - RADIUS * up, RADIUS);
    drawing.line("guide", p - 190.0 * up.perp(), p + 190.0 * up.perp());
    let arrows = [
        ("light", l, "$l$", dvec2(-14.0, -6.0)),
        ("second", n, "$n$", dvec2(14.0, 8.0)),
        ("vector", r, "$r$", dvec2(-2.0, 20.0)),
        ("accent", v, "$v$", dvec2(14.0, 5.0)),
    ];
    for (class, vector, name, shift) in arrows {
        let length = if class == "second" { 0.6 } else { 1.0 };
        let tip = VIEW.to_drawing(length * vector.truncate());
        drawing.arrow(class, p, tip);
        drawing.label("strong over", tip + shift, name);
    }
    drawing.dot("hit", p);
    drawing
}
