use super::Figure;
use crate::live::{Handle, Knob, Live, Sight, number, vector};
use crate::svg::{Drawing, View};
use glam::{DVec2, dvec2};
use step01_rays::Ray;

/// A ray with the points at several t, one of which moves.
pub const RAY: Live = Live {
    name: "ray",
    knobs: &[
        Knob::new(["", "S, sideways", ""], 0.0, [-2.0, 7.0], 10.0),
        Knob::new(["", "S, upwards", ""], 0.0, [-1.0, 3.0], 10.0),
        Knob::new(["", "V, sideways", ""], 2.0, [-4.0, 4.0], 10.0),
        Knob::new(["", "V, upwards", ""], 0.7, [-4.0, 4.0], 10.0),
        Knob::new(["", "t", ""], 2.0, [-0.9, 3.2], 10.0),
    ],
    handles: &[
        Handle::new(
            "the start S",
            [0, 1],
            |values| at(values, 0.0),
            |values, to| values[..2].copy_from_slice(&world(to).to_array()),
        ),
        Handle::new(
            "the tip of V",
            [2, 3],
            |values| at(values, 1.0) + BESIDE,
            |values, to| {
                let v = world(to - BESIDE) - dvec2(values[0], values[1]);
                values[2..4].copy_from_slice(&v.to_array());
            },
        ),
        Handle::new(
            "the point at t",
            [4, 4],
            |values| at(values, values[4]),
            |values, to| {
                let Ray { start, direction: v } = ray(values);
                values[4] = (world(to).extend(0.0) - start).dot(v) / v.dot(v);
            },
        ),
    ],
    is_allowed: |values| {
        let is_inside = |at: DVec2| at.clamp(dvec2(8.0, 8.0), SIZE - 8.0) == at;
        let handles = RAY.handles.iter().map(|handle| (handle.at)(values));
        ray(values).direction.length() != 0.0 && handles.into_iter().all(is_inside)
    },
    sight: |values| Sight::Drawing(draw(values)),
    numbers: |values| {
        let point = ray(values).at(values[4]).truncate();
        vec![
            ("t".into(), number(values[4])),
            ("point".into(), vector(&point.to_array())),
        ]
    },
    beside: None,
};

const SIZE: DVec2 = dvec2(480.0, 240.0);
const VIEW: View = View { origin: dvec2(112.0, 172.0), scale: dvec2(50.0, 50.0) };

fn ray(values: &[f64]) -> Ray {
    let at = |k: usize| dvec2(values[k], values[k + 1]).extend(0.0);
    Ray { start: at(0), direction: at(2) }
}

/// Where in the drawing r(t) is.
fn at(values: &[f64], t: f64) -> DVec2 {
    VIEW.at(ray(values).at(t).truncate())
}

/// The point of the world at a place in the drawing.
fn world(place: DVec2) -> DVec2 {
    (place - VIEW.origin) / VIEW.scale * dvec2(1.0, -1.0)
}

/// V is drawn above the ray, and not on it.
const BESIDE: DVec2 = dvec2(-5.0, -14.0);

fn draw(values: &[f64]) -> Drawing {
    let at = |t: f64| at(values, t);
    let moving = values[4];
    let mut drawing = Drawing::new(SIZE.x, SIZE.y);
    drawing.line("guide", at(-0.9), at(0.0));
    drawing.line("ray", at(0.0), at(3.2));
    drawing.arrow("ray faint", at(3.0), at(3.55));
    drawing.arrow("vector", at(0.0) + BESIDE, at(1.0) + BESIDE);
    drawing.label("strong", at(0.5) + 2.0 * BESIDE, "$V$");
    for t in [-0.5, 0.0, 1.0, 2.0, 3.0] {
        drawing.dot(if t < 0.0 { "behind" } else { "ray" }, at(t));
        let label = format!("$t$ = {}", number(t));
        drawing.label("quiet", at(t) + dvec2(9.0, 25.0), &label);
    }
    drawing.label_to("strong", at(0.0) + dvec2(-14.0, -10.0), "$S$");
    let sign = if moving < 0.0 { '−' } else { '+' };
    let label = format!("$S$ {sign} {}$V$", number(moving.abs()));
    drawing.label_to("", at(moving) + dvec2(-8.0, -16.0), &label);
    drawing
}

/// The ray as it is printed.
pub fn figure() -> Figure {
    Figure {
        title: "A ray that starts at S and goes along V, with the points at t = 0, 1, 2 and 3 on it, and one at t = -0.5 behind its start.",
        caption: "A ray. Each step of $t$ by 1 is one $V$ further from $S$. Where $t$ is below 0, \
                  the point lies behind the start, on the same line but not on the ray. \
                  At $t = {{#number ray:t}}$ it is {{#number ray:point}}. \
                  <span class='move'>Make $V$ longer, and see which $t$ a point has now.</span>",
        drawing: draw(&RAY.values()),
    }
}
