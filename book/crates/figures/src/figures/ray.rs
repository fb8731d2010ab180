//! A ray, with the points at several values of t.

use super::*;
use step01_rays::Ray;

const SIZE: DVec2 = dvec2(480.0, 250.0);
const VIEW: View = View { origin: dvec2(104.0, 170.0), scale: dvec2(40.0, 40.0) };

/// The offset from the ray to the arrow V, which is drawn beside the ray.
const BESIDE: DVec2 = dvec2(-6.0, -14.0);

const START: PointId = PointId("the start S");

/// The two components of V, which the reader sets with the handle at the tip of V.
const V: PointId = PointId("the tip of V");
const DISTANCE: ParameterId = ParameterId::new("distance");

const CONTENT: Content = Content::Drawing {
    title: "A ray that starts at S and goes along V, with the points at t = 0, 1, 2 and 3 on it, and one at t = -0.5 behind its start.",
    caption: "Each step of $t$ by 1 is one $V$ further from $S$. Where $t$ is negative, the point is behind the start, and not on the ray. \
                  $V$ has length {{#number ray:length}}, so the point at a distance of {{#number ray:distance}} from $S$ has $t = {{#number ray:t}}$. \
                  <span class='move'>Make $V$ longer, and this same point gets a smaller $t$.</span>",
    draw,
};

/// A ray in the plane z = 0, with the points at several values of t. The reader sets how far
/// another point is from S. This point stays where it is when V gets longer.
pub fn figure() -> Figure {
    let start = Parameter::point(START, [0.0, 0.0], [[-2.0, 7.0], [-0.5, 2.5]], 10.0);
    let v = Parameter::point(V, [2.4, 0.7], [[-4.0, 7.0], [-4.0, 4.0]], 10.0);
    let distance_label = "the point's distance from S";
    let distance = Parameter::number(DISTANCE, distance_label, 5.0, [-2.0, 8.0], 10.0);
    let v_at = |values: &ParameterValues, position| {
        Some(VIEW.to_world(position - BESIDE) - values.point(START))
    };
    let point = |values: &ParameterValues| position_on_ray(values, t_at_distance(values));
    let distance_at = |values: &ParameterValues, position| {
        let ray = ray(values);
        let from_start = VIEW.to_world(position).extend(0.0) - ray.start;
        from_start.dot(ray.direction.normalize())
    };
    Figure {
        parameters: start.into_iter().chain(v).chain([distance]).collect(),
        handles: vec![
            Handle::of_point_in_drawing(START, VIEW),
            Handle::new(V.0, [V.x(), V.y()], |values| Some(v_tip_position(values)), v_at),
            Handle::of_parameter(distance_label, DISTANCE, point, distance_at),
        ],
        has_something_to_show: |values| {
            let is_long = ray(values).direction.length() >= 1.0;
            is_long
                && is_well_inside_drawing(position_on_ray(values, 0.0))
                && is_well_inside_drawing(v_tip_position(values))
        },
        readouts,
        ..Figure::new("ray", CONTENT)
    }
}

fn ray(values: &ParameterValues) -> Ray {
    let [start, direction] = [START, V].map(|point| values.point(point).extend(0.0));
    Ray { start, direction }
}

/// The t of the point whose distance from S is the parameter `DISTANCE`.
fn t_at_distance(values: &ParameterValues) -> f64 {
    values[DISTANCE] / ray(values).direction.length()
}

/// The position, in the drawing, of the point at `t` on the ray.
fn position_on_ray(values: &ParameterValues, t: f64) -> DVec2 {
    VIEW.to_drawing(ray(values).at(t).truncate())
}

/// The position of the tip of V in the drawing.
fn v_tip_position(values: &ParameterValues) -> DVec2 {
    position_on_ray(values, 1.0) + BESIDE
}

/// Whether a position is at least 14 units from the border of the drawing.
fn is_well_inside_drawing(position: DVec2) -> bool {
    position.clamp(DVec2::splat(14.0), SIZE - 14.0) == position
}

/// Draws the ray, and the arrow V beside the ray. Also draws the points at several values of t, and
/// the point whose distance from S the reader sets.
fn draw(values: &ParameterValues) -> Drawing {
    let position = |t: f64| position_on_ray(values, t);
    let (s, v) = (position(0.0), position(1.0) - position(0.0));
    let mut drawing = Drawing::new(SIZE.y);
    let steps = (0..).map(|k| 0.1 * f64::from(k));
    let end = steps.take_while(|t| is_well_inside_drawing(position(*t))).last().unwrap_or(0.0);
    drawing.line("guide", s - 90.0 * v.normalize(), s);
    drawing.arrow("ray", s, position(end));
    drawing.arrow("vector", s + BESIDE, v_tip_position(values));
    drawing.label("strong over", position(0.5) + BESIDE + dvec2(-6.0, -10.0), "$V$");
    drawing.label("strong over", s + dvec2(-18.0, -12.0), "$S$");
    // If the ray's line slopes down to the right, the labels are above the line. Otherwise, the
    // labels are below the line.
    let shift = dvec2(8.0, if v.x * v.y <= 0.0 { 28.0 } else { -18.0 });
    for t in (-1..10).map(|k| f64::from(k).max(-0.5)) {
        let label = position(t) + shift;
        if is_well_inside_drawing(position(t)) && is_well_inside_drawing(label + dvec2(38.0, 0.0)) {
            drawing.dot(if t < 0.0 { "behind" } else { "ray" }, position(t));
            drawing.label("quiet over start", label, &format!("$t$ = {}", format_number(t)));
        }
    }
    let t = t_at_distance(values);
    let sign = if t < 0.0 { '−' } else { '+' };
    let label = format!("$S$ {sign} {}$V$", format_with_max_decimals(t.abs(), 2));
    // The label is above the ray, except near the top of the drawing, where it is below the ray.
    let position_above = position(t) + dvec2(-10.0, -24.0);
    let label_position =
        if position_above.y < 14.0 { position(t) + dvec2(-10.0, 30.0) } else { position_above };
    drawing.label("over", label_position, &label);
    drawing
}

fn readouts(values: &ParameterValues) -> Readouts {
    let (length, t) = (ray(values).direction.length(), t_at_distance(values));
    collect_readouts([
        ("length", format_with_max_decimals(length, 2)),
        ("distance", format_with_max_decimals(t.abs() * length, 2)),
        ("t", format_with_max_decimals(t, 2)),
    ])
}
