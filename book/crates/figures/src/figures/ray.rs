use crate::{
    Drawing, Handle, Interactive, Numbers, Output, Parameter, View, array, collect_numbers,
    format_number, format_rounded,
};
use glam::{DVec2, dvec2};
use step01_rays::Ray;

const SIZE: DVec2 = dvec2(480.0, 240.0);
const VIEW: View = View { origin: dvec2(104.0, 170.0), scale: dvec2(40.0, 40.0) };

/// The shift by which V is drawn above the ray.
const V_SHIFT: DVec2 = dvec2(-5.0, -14.0);

/// A ray in the plane z = 0 with the points at several t, and a point that keeps its distance
/// from S when V is made longer.
pub struct RayFigure {
    ray: Ray,
    /// The t of the point.
    t: f64,
}

impl RayFigure {
    /// The place of r(t) in the drawing.
    fn place(&self, t: f64) -> DVec2 {
        VIEW.to_drawing(self.ray.at(t).truncate())
    }

    /// The place of the tip of V.
    fn tip(&self) -> DVec2 {
        self.place(1.0) + V_SHIFT
    }
}

/// Whether a place is in the drawing, with room for a mark.
fn is_in_drawing(place: DVec2) -> bool {
    place.clamp(dvec2(8.0, 8.0), SIZE - 8.0) == place
}

/// The label S + tV of the point, above V and its name if the point is beside them.
fn draw_point_label(drawing: &mut Drawing, t: f64, point: DVec2, v_length: f64) {
    if !is_in_drawing(point) {
        return;
    }
    let sign = if t < 0.0 { '−' } else { '+' };
    let factor = format_rounded(t.abs(), 2);
    let factor = if factor == "1" { "" } else { &factor };
    let is_beside_v = (-10.0..v_length + 70.0).contains(&(t * v_length));
    let height = if is_beside_v { 52.0 } else { 16.0 };
    let end = (point - dvec2(8.0, height)).max(dvec2(76.0, 18.0));
    drawing.label_ending_at("", end, &format!("$S$ {sign} {factor}$V$"));
}

impl Interactive for RayFigure {
    const NAME: &str = "ray";
    const TITLE: &str = "A ray that starts at S and goes along V, with the points at t = 0, 1, 2 and 3 on it, and one at t = -0.5 behind its start.";
    const CAPTION: &str = "Each step of $t$ by 1 is one $V$ further from $S$. Where $t$ is negative, the point is behind the start, and not on the ray. \
                  $V$ has length {{#number ray:length}}, and the point {{#number ray:point}} has $t = {{#number ray:t}}$. \
                  <span class='move'>Make $V$ longer. The point stays: what's its $t$ now?</span>";

    fn parameters() -> Vec<Parameter> {
        vec![
            Parameter::coordinate(0.0, [-2.0, 7.0], 10.0),
            Parameter::coordinate(0.0, [-1.0, 3.0], 10.0),
            Parameter::coordinate(2.4, [-4.0, 7.0], 10.0),
            Parameter::coordinate(0.7, [-4.0, 4.0], 10.0),
            Parameter::coordinate(5.0, [-2.0, 8.0], 10.0),
        ]
    }

    fn from_values(values: &[f64]) -> Self {
        let [s_x, s_y, v_x, v_y, distance] = array(values);
        let [start, direction] = [dvec2(s_x, s_y), dvec2(v_x, v_y)].map(|point| point.extend(0.0));
        Self { ray: Ray { start, direction }, t: distance / direction.length() }
    }

    fn handles() -> Vec<Handle> {
        let from_start =
            |Self { ray, .. }: &Self, place| VIEW.to_world(place) - ray.start.truncate();
        let tip = |figure: &Self| Some(figure.tip());
        let v_at = move |figure: &Self, place| from_start(figure, place - V_SHIFT);
        let point = |figure: &Self| figure.place(figure.t);
        let distance_at = move |figure: &Self, place| {
            from_start(figure, place).dot(figure.ray.direction.truncate().normalize())
        };
        vec![
            Handle::of_point("the start S", 0, VIEW),
            Self::handle("the tip of V", [2, 3], tip, v_at),
            Self::handle_of_one("the point's distance from S", 4, point, distance_at),
        ]
    }

    fn is_allowed(&self) -> bool {
        let places = [self.place(0.0), self.tip()];
        0.5 <= self.ray.direction.length() && places.into_iter().all(is_in_drawing)
    }

    fn draw(&self) -> Output {
        let place = |t: f64| self.place(t);
        let v = place(1.0) - place(0.0);
        let mut drawing = Drawing::new(SIZE.x, SIZE.y);
        let steps = (0..).map(|k| 0.1 * f64::from(k));
        let end = steps.take_while(|t| is_in_drawing(place(*t))).last().unwrap_or(0.0);
        drawing.line("guide", place(0.0) - 90.0 * v.normalize(), place(0.0));
        drawing.arrow("ray", place(0.0), place(end));
        drawing.arrow("vector", place(0.0) + V_SHIFT, self.tip());
        drawing.label("strong", place(0.5) + 2.0 * V_SHIFT, "$V$");
        // Each whole t that has room gets a label; where V is short or steep, only some do.
        let step = (52.0 / v.x.abs().max(1.7 * v.y.abs())).ceil();
        let margin = dvec2(26.0, 32.0);
        for t in (-1..40).map(|k| if k < 0 { -0.5 } else { step * f64::from(k) }) {
            let has_room = place(t).clamp(margin, SIZE - margin) == place(t);
            if has_room && (0.0 <= t || step == 1.0) {
                drawing.dot(if t < 0.0 { "behind" } else { "ray" }, place(t));
                let label = format!("$t$ = {}", format_number(t));
                drawing.label("quiet", place(t) + dvec2(9.0, 25.0), &label);
            }
        }
        if v.x < 0.0 {
            drawing.label_starting_at("strong", place(0.0) + dvec2(12.0, -16.0), "$S$");
        } else {
            drawing.label_ending_at("strong", place(0.0) + dvec2(-14.0, -10.0), "$S$");
        }
        draw_point_label(&mut drawing, self.t, place(self.t), v.length());
        Output::Drawing(drawing)
    }

    fn numbers(&self) -> Numbers {
        let Self { ray, t } = self;
        let point = ray.at(*t);
        let [x, y] = [point.x, point.y].map(|number| format_rounded(number, 2));
        collect_numbers([
            ("length", format_rounded(ray.direction.length(), 2)),
            ("t", format_rounded(*t, 2)),
            ("point", format!("({x}, {y})")),
        ])
    }
}
