use super::Figure;
use crate::svg::{Drawing, View};
use glam::{DVec3, dvec2};
use step01_rays::Ray;

/// A ray with the points at several t.
pub fn figure() -> Figure {
    let ray = Ray {
        start: DVec3::new(0.0, 0.0, 0.0),
        direction: DVec3::new(2.0, 0.7, 0.0),
    };
    let view = View { origin: dvec2(112.0, 172.0), scale: dvec2(50.0, 50.0) };
    let at = |t: f64| view.at(ray.at(t).truncate());
    let mut drawing = Drawing::new(480.0, 240.0);
    drawing.line("guide", at(-0.9), at(0.0));
    drawing.line("ray", at(0.0), at(3.2));
    drawing.arrow("ray faint", at(3.0), at(3.55));
    let beside = dvec2(-5.0, -14.0);
    drawing.arrow("vector", at(0.0) + beside, at(1.0) + beside);
    drawing.label("strong", at(0.5) + 2.0 * beside, "$V$");
    for (t, name) in
        [(-0.5, "-0.5"), (0.0, "0"), (1.0, "1"), (2.0, "2"), (3.0, "3")]
    {
        drawing.dot(if t < 0.0 { "behind" } else { "ray" }, at(t));
        let label = format!("$t$ = {}", name.replace('-', "−"));
        drawing.label("quiet", at(t) + dvec2(9.0, 25.0), &label);
    }
    drawing.label_to("strong", at(0.0) + dvec2(-14.0, -10.0), "$S$");
    drawing.label_to("", at(2.0) + dvec2(-8.0, -16.0), "$S$ + 2$V$");
    Figure {
        title: "A ray that starts at S and goes along V, with the points at t = 0, 1, 2 and 3 on it, and one at t = -0.5 behind its start.",
        caption: "A ray. Each step of $t$ by 1 is one $V$ further from $S$. Where $t$ is below 0, \
                  the point lies behind the start, on the same line but not on the ray.",
        drawing,
    }
}
