//! The four unit vectors of the Phong terms.

use super::*;
use std::f64::consts::FRAC_PI_2;
use step05_phong::reflect;

/// Maps the plane of the vectors to the drawing. The origin is the point on the sphere, where all
/// four vectors start.
const VIEW: View = View { origin: dvec2(240.0, 240.0), scale: DVec2::splat(190.0) };

const ANGLE: ParameterId = ParameterId::new("angle");

const CONTENT: Content = Content::Drawing {
    title: "A point on a sphere with four unit vectors: n straight up out of the surface, l to the light on the left, r its mirror image on the right, and v to the eye, between n and r.",
    caption: "The four vectors, each one unit long. $l$ and $r$ make the same angle with $n$, {{#number phong-vectors:angle}}°. \
                  <span class='move'>Turn the light until it is behind the surface.</span>",
    draw,
};

/// The unit vectors n, l, r and v in one plane, with a light that the reader can turn.
pub fn figure() -> Figure {
    let angle = Parameter::number(ANGLE, "angle of the light", 30.0, [0.0, 110.0], 1.0)
        .with_symbol("α")
        .with_unit("°");
    Figure {
        parameters: vec![angle],
        handles: vec![Handle::of_degrees_left_of_up("the light l", ANGLE, VIEW, 1.0)],
        readouts: |values| collect_readouts([("angle", format_number(values[ANGLE]))]),
        ..Figure::new("phong-vectors", CONTENT)
    }
}

/// Draws the top of a sphere, and the four vectors at a point on the sphere.
fn draw(values: &ParameterValues) -> Drawing {
    let mut drawing = Drawing::new(320.0);
    let p = VIEW.origin;
    drawing.circle("object", p + dvec2(0.0, 300.0), 300.0);
    let [n, l, v] =
        [0.0, values[ANGLE], -17.0].map(|angle| direction_left_of_up(angle).extend(0.0));
    let angle = values[ANGLE].to_radians();
    drawing.arc("axis", p, 62.0, [FRAC_PI_2 - angle, FRAC_PI_2 + angle]);
    let arrows = [
        ("light", l, "$l$", dvec2(-20.0, -4.0)),
        ("second", n, "$n$", dvec2(0.0, -12.0)),
        ("vector", reflect(n, l), "$r$", dvec2(20.0, -4.0)),
        ("accent", v, "$v$", dvec2(2.0, -12.0)),
    ];
    for (class, vector, name, shift) in arrows {
        let tip = VIEW.to_drawing(vector.truncate());
        drawing.arrow(class, p, tip);
        drawing.label("strong over", tip + shift, name);
    }
    if n.dot(l) < 0.0 {
        drawing.label("quiet over", p + dvec2(0.0, 34.0), "$n$·$l$ < 0: no highlight");
    }
    drawing.dot("hit", p);
    drawing
}
