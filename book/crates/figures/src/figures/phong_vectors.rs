use crate::{
    Drawing, Handle, Interactive, Numbers, Output, Parameter, View, collect_numbers,
    direction_left_of_up, format_number,
};
use glam::{DVec2, dvec2};
use std::f64::consts::FRAC_PI_2;
use step05_phong::reflect;

/// The place of the hit in the drawing, and the length of 1.
const VIEW: View = View { origin: dvec2(240.0, 240.0), scale: DVec2::splat(190.0) };

/// The unit vectors n, l, r and v in one plane, with a light to turn.
pub struct PhongVectors {
    /// The angle between n and l.
    degrees: f64,
}

impl Interactive for PhongVectors {
    const NAME: &str = "phong-vectors";
    const TITLE: &str = "A point on a sphere with four unit vectors: n straight up out of the surface, l to the light on the left, r its mirror image on the right, and v to the eye, between n and r.";
    const CAPTION: &str = "The four vectors, each one unit long. $l$ and $r$ make the same angle with $n$, {{#number phong-vectors:angle}}°. \
                  <span class='move'>Turn the light until it is behind the surface.</span>";

    fn parameters() -> Vec<Parameter> {
        vec![Parameter::new(["α", "angle of the light", "°"], 30.0, [0.0, 110.0], 1.0)]
    }

    fn from_values(values: &[f64]) -> Self {
        Self { degrees: values[0] }
    }

    fn handles() -> Vec<Handle> {
        let locate = |figure: &Self| VIEW.to_drawing(direction_left_of_up(figure.degrees));
        let angle_at = |_: &Self, place| VIEW.degrees_left_of_up(place);
        vec![Self::handle_of_one("the light l", 0, locate, angle_at)]
    }

    fn draw(&self) -> Output {
        let mut drawing = Drawing::new(480.0, 320.0);
        let p = VIEW.origin;
        drawing.circle("object", p + dvec2(0.0, 300.0), 300.0);
        let [n, l, v] =
            [0.0, self.degrees, -17.0].map(|angle| direction_left_of_up(angle).extend(0.0));
        let r = reflect(n, l);
        let angle = self.degrees.to_radians();
        drawing.arc("angle", p, 62.0, [FRAC_PI_2 - angle, FRAC_PI_2 + angle]);
        let arrows = [
            ("light", l, "$l$", dvec2(-20.0, -4.0)),
            ("normal", n, "$n$", dvec2(0.0, -12.0)),
            ("vector", r, "$r$", dvec2(20.0, -4.0)),
            ("accent", v, "$v$", dvec2(2.0, -12.0)),
        ];
        for (class, vector, name, shift) in arrows {
            let tip = VIEW.to_drawing(vector.truncate());
            drawing.arrow(class, p, tip);
            drawing.label("strong over", tip + shift, name);
        }
        drawing.dot("hit", p);
        Output::Drawing(drawing)
    }

    fn numbers(&self) -> Numbers {
        collect_numbers([("angle", format_number(self.degrees))])
    }
}
