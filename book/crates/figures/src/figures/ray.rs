use crate::{
    Drawing, Handle, Interactive, Numbers, Output, Parameter, View, array, collect_numbers,
    format_number, format_rounded,
};
use glam::{DVec2, dvec2};
use step01_rays::Ray;

const SIZE: DVec2 = dvec2(480.0, 250.0);
const VIEW: View = View { origin: dvec2(104.0, 170.0), scale: dvec2(40.0, 40.0) };

/// The distance in the drawing between the ray and V.
const GAP: f64 = 13.0;

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

    /// The unit vector in the drawing that leads from the ray to V, to the left of it.
    fn left(&self) -> DVec2 {
        (self.place(0.0) - self.place(1.0)).perp().normalize()
    }

    fn tip(&self) -> DVec2 {
        self.place(1.0) + GAP * self.left()
    }
}

/// Whether a place is in the drawing, with so much room around it.
fn is_in_drawing(place: DVec2, room: DVec2) -> bool {
    place.clamp(room, SIZE - room) == place
}

/// The place of a label that begins at this distance from a point, in this direction.
fn label_place(label: &str, point: DVec2, direction: DVec2, distance: f64) -> DVec2 {
    let half_width = 4.0 * label.replace('$', "").chars().count() as f64;
    let extent = dvec2(half_width, 8.0).dot(direction.abs());
    point + (distance + extent) * direction + dvec2(0.0, 5.0)
}

impl Interactive for RayFigure {
    const NAME: &str = "ray";
    const TITLE: &str = "A ray that starts at S and goes along V, with the points at t = 0, 1, 2 and 3 on it, and one at t = -0.5 behind its start.";
    const CAPTION: &str = "Each step of $t$ by 1 is one $V$ further from $S$. Where $t$ is negative, the point is behind the start, and not on the ray. \
                  $V$ has length {{#number ray:length}}, and the point with the coordinates {{#number ray:point}} has $t = {{#number ray:t}}$. \
                  <span class='move'>Make $V$ longer, and this same point gets a smaller $t$.</span>";

    fn parameters() -> Vec<Parameter> {
        let start = Parameter::point([0.0, 0.0], [[-2.0, 7.0], [-0.5, 2.5]], 10.0);
        let v = Parameter::point([2.4, 0.7], [[-4.0, 7.0], [-4.0, 4.0]], 10.0);
        let distance = Parameter::new([""; 3], 5.0, [-2.0, 8.0], 10.0);
        start.into_iter().chain(v).chain([distance]).collect()
    }

    fn from_values(values: &[f64]) -> Self {
        let [s_x, s_y, v_x, v_y, distance] = array(values);
        let [start, direction] = [dvec2(s_x, s_y), dvec2(v_x, v_y)].map(|point| point.extend(0.0));
        Self { ray: Ray { start, direction }, t: distance / direction.length() }
    }

    fn handles() -> Vec<Handle> {
        let tip = |figure: &Self| Some(figure.tip());
        let v_at = |figure: &Self, place| {
            // V and the gap are at a right angle, and lead from S to the place.
            let way: DVec2 = place - figure.place(0.0);
            let length = (way.length_squared() - GAP * GAP).max(0.0).sqrt();
            let v = length / way.length_squared() * way.rotate(dvec2(length, GAP));
            v / VIEW.scale * dvec2(1.0, -1.0)
        };
        let point = |figure: &Self| figure.place(figure.t);
        let distance_at = |Self { ray, .. }: &Self, place| {
            let way = VIEW.to_world(place).extend(0.0) - ray.start;
            way.dot(ray.direction.normalize())
        };
        vec![
            Handle::of_point("the start S", 0, VIEW),
            Self::handle("the tip of V", [2, 3], tip, v_at),
            Self::handle_of_one("the point's distance from S", 4, point, distance_at),
        ]
    }

    fn is_allowed(&self) -> bool {
        let is_in_drawing = |place| is_in_drawing(place, DVec2::splat(8.0));
        0.5 <= self.ray.direction.length()
            && [self.place(0.0), self.tip()].into_iter().all(is_in_drawing)
    }

    fn draw(&self) -> Output {
        let place = |t: f64| self.place(t);
        let (v, left) = (place(1.0) - place(0.0), self.left());
        let back = -v.normalize();
        let is_visible = |t: f64| is_in_drawing(place(t), DVec2::splat(8.0));
        let mut drawing = Drawing::new(SIZE.x, SIZE.y);
        let steps = (0..).map(|k| 0.1 * f64::from(k));
        let end = steps.take_while(|t| is_visible(*t)).last().unwrap_or(0.0);
        drawing.line("guide", place(0.0) + 90.0 * back, place(0.0));
        drawing.arrow("ray", place(0.0), place(end));
        drawing.arrow("vector", place(0.0) + GAP * left, self.tip());
        drawing.label("strong", label_place("V", place(0.5), left, 20.0), "$V$");
        drawing.label("strong", label_place("S", place(0.0) + GAP * left, back, 6.0), "$S$");
        // Each whole t that has room gets a label; where V is short or steep, only some do.
        let step = (52.0 / v.x.abs().max(1.7 * v.y.abs())).ceil();
        for t in (-1..40).map(|k| if k < 0 { -0.5 } else { step * f64::from(k) }) {
            let label = format!("$t$ = {}", format_number(t));
            let middle = label_place(&label, place(t), -left, 7.0);
            let has_room = is_visible(t) && is_in_drawing(middle, dvec2(28.0, 14.0));
            if has_room && (0.0 <= t || step == 1.0) {
                drawing.dot(if t < 0.0 { "behind" } else { "ray" }, place(t));
                drawing.label("quiet", middle, &label);
            }
        }
        if is_visible(self.t) {
            let sign = if self.t < 0.0 { '−' } else { '+' };
            let factor = format_rounded(self.t.abs(), 2);
            let label = format!("$S$ {sign} {}$V$", if factor == "1" { "" } else { &factor });
            // Beyond the name of V, if the point is beside it, or else beyond those of the t.
            let is_beside_v = (-60.0..v.length() + 60.0).contains(&(self.t * v.length()));
            let distance = if is_beside_v { 44.0 } else { 12.0 };
            let places = [(left, distance), (-left, 28.0)]
                .map(|(side, distance)| label_place(&label, place(self.t), side, distance));
            let mut places = places.into_iter();
            if let Some(place) = places.find(|place| is_in_drawing(*place, dvec2(44.0, 14.0))) {
                drawing.label("", place, &label);
            }
        }
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
