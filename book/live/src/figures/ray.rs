use crate::live::{Handle, Knob, Live, Sight, digits, named, number};
use crate::svg::{Drawing, View};
use glam::{DVec2, dvec2};
use step01_rays::Ray;

const SIZE: DVec2 = dvec2(480.0, 240.0);
const VIEW: View = View { origin: dvec2(104.0, 170.0), scale: dvec2(40.0, 40.0) };

fn ray(values: &[f64]) -> Ray {
    let at = |k: usize| dvec2(values[k], values[k + 1]).extend(0.0);
    Ray { start: at(0), direction: at(2) }
}

/// How many V the point is from S.
fn t(values: &[f64]) -> f64 {
    values[4] / ray(values).direction.length()
}

/// Whether a place is in the drawing, with room for what marks it.
fn is_inside(place: DVec2) -> bool {
    place.clamp(dvec2(8.0, 8.0), SIZE - 8.0) == place
}

/// Where in the drawing r(t) is.
fn at(values: &[f64], t: f64) -> DVec2 {
    VIEW.at(ray(values).at(t).truncate())
}

/// V is drawn above the ray, and not on it.
const BESIDE: DVec2 = dvec2(-5.0, -14.0);

fn draw(values: &[f64]) -> Drawing {
    let at = |t: f64| at(values, t);
    let v = at(1.0) - at(0.0);
    // The whole t that are in the drawing, with room for a label below.
    let room = dvec2(26.0, 32.0);
    let has_room = |t: &f64| at(*t).clamp(room, SIZE - room) == at(*t);
    let end = (0..).map(|k| 0.1 * f64::from(k));
    let end = end.take_while(|t| is_inside(at(*t))).last().unwrap_or(0.0);
    let mut drawing = Drawing::new(SIZE.x, SIZE.y);
    drawing.line("guide", at(0.0) - 90.0 * v.normalize(), at(0.0));
    drawing.arrow("ray", at(0.0), at(end));
    drawing.arrow("vector", at(0.0) + BESIDE, at(1.0) + BESIDE);
    drawing.label("strong", at(0.5) + 2.0 * BESIDE, "$V$");
    // Where V is short or steep, some of the labels would lie on others.
    let step = (52.0 / v.x.abs().max(1.7 * v.y.abs())).ceil();
    for t in (-1..40).map(|k| if k < 0 { -0.5 } else { step * f64::from(k) }) {
        let has_name = 0.0 <= t || step == 1.0;
        if has_room(&t) && has_name {
            drawing.dot(if t < 0.0 { "behind" } else { "ray" }, at(t));
            let label = format!("$t$ = {}", number(t));
            drawing.label("quiet", at(t) + dvec2(9.0, 25.0), &label);
        }
    }
    match v.x < 0.0 {
        true => drawing.label_from("strong", at(0.0) + dvec2(12.0, -16.0), "$S$"),
        false => drawing.label_to("strong", at(0.0) + dvec2(-14.0, -10.0), "$S$"),
    }
    let moving = t(values);
    let sign = if moving < 0.0 { '−' } else { '+' };
    let times = digits(2, moving.abs());
    let times = if times == "1" { "" } else { &times };
    let label = format!("$S$ {sign} {times}$V$");
    // Above V and its name, where the point is beside them.
    let is_beside = (-10.0..v.length() + 70.0).contains(&(moving * v.length()));
    let up = if is_beside { 52.0 } else { 16.0 };
    let place = at(moving) - dvec2(8.0, up);
    if is_inside(at(moving)) {
        drawing.label_to("", place.max(dvec2(76.0, 18.0)), &label);
    }
    drawing
}

/// A ray with the points at several t, and one that stays at its distance from S when V
/// is made longer.
pub fn figure() -> Live {
    Live {
        title: "A ray that starts at S and goes along V, with the points at t = 0, 1, 2 and 3 on it, and one at t = -0.5 behind its start.",
        caption: "Each step of $t$ by 1 is one $V$ further from $S$. Where $t$ is negative, the point is behind the start, and not on the ray. \
                  $V$ has length {{#number ray:length}}, and the point {{#number ray:point}} has $t = {{#number ray:t}}$. \
                  <span class='move'>Make $V$ longer. The point stays: what's its $t$ now?</span>",
        knobs: vec![
            Knob::turned(0.0, [-2.0, 7.0], 10.0),
            Knob::turned(0.0, [-1.0, 3.0], 10.0),
            Knob::turned(2.4, [-4.0, 7.0], 10.0),
            Knob::turned(0.7, [-4.0, 4.0], 10.0),
            Knob::turned(5.0, [-2.0, 8.0], 10.0),
        ],
        handles: vec![
            Handle::new(
                "the start S",
                [0, 1],
                |_, values| at(values, 0.0),
                |_, _, to| VIEW.world(to),
            ),
            Handle::new(
                "the tip of V",
                [2, 3],
                |_, values| at(values, 1.0) + BESIDE,
                |_, values, to| {
                    VIEW.world(to - BESIDE) - dvec2(values[0], values[1])
                },
            ),
            Handle::new(
                "the point at t",
                [4, 4],
                |_, values| at(values, t(values)),
                |_, values, to| {
                    let Ray { start, direction } = ray(values);
                    let along = direction.normalize();
                    let way = VIEW.world(to).extend(0.0) - start;
                    DVec2::splat(way.dot(along))
                },
            ),
        ],
        is_allowed: |values| {
            let ends = [at(values, 0.0), at(values, 1.0) + BESIDE];
            0.5 <= ray(values).direction.length() && ends.into_iter().all(is_inside)
        },
        numbers: |values| {
            let (ray, t) = (ray(values), t(values));
            let [x, y] = ray.at(t).truncate().to_array().map(|x| digits(2, x));
            named([
                ("length", digits(2, ray.direction.length())),
                ("t", digits(2, t)),
                ("point", format!("({x}, {y})")),
            ])
        },
        ..Live::new("ray", |values| Sight::Drawing(draw(values)))
    }
}
