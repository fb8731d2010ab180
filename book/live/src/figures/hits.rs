use super::Figure;
use crate::roots;
use crate::svg::{Drawing, View};
use glam::{DVec2, DVec3, dvec2};
use step03_nearest::{Object, Ray, Sphere, nearest};

/// One ray through several spheres, one behind its start, and every t on it.
pub fn figure() -> Figure {
    let ray = Ray { start: DVec3::ZERO, direction: DVec3::X };
    let object = |x, y, radius, k| {
        let sphere = Sphere { centre: DVec3::new(x, y, 0.0), radius };
        Object { sphere, material: k }
    };
    let objects = [
        object(5.3, 0.35, 1.0, 0),
        object(-1.5, 0.2, 0.7, 1),
        object(2.4, -0.3, 0.8, 2),
    ];
    let view = View { origin: dvec2(136.0, 100.0), scale: DVec2::splat(46.0) };
    let at = |t: f64| view.at(ray.at(t).truncate());
    let seen = nearest(&objects, &ray);
    let mut drawing = Drawing::new(480.0, 210.0);
    for Object { sphere, material: k } in &objects {
        let is_seen = seen.is_some_and(|hit| hit.object.material == *k);
        let class = if is_seen { "object seen" } else { "object" };
        let centre = view.at(sphere.centre.truncate());
        let radius = view.scale.x * sphere.radius;
        drawing.circle(class, centre, radius);
        let above = centre - dvec2(0.0, radius + 9.0);
        drawing.label("quiet", above, &format!("$k$ = {k}"));
    }
    drawing.line("guide", at(-2.7), at(0.0));
    drawing.arrow("ray", at(0.0), at(7.2));
    drawing.dot("eye", at(0.0));
    drawing.label("strong", at(0.0) + dvec2(0.0, -12.0), "$S$");
    for Object { sphere, .. } in &objects {
        for t in roots(sphere, &ray) {
            let class = match seen {
                Some(hit) if hit.t == t => "hit",
                _ if t < 0.0 => "behind",
                _ => "ray",
            };
            drawing.dot(class, at(t));
            drawing.line("leader", at(t) + dvec2(0.0, 8.0), dvec2(at(t).x, 172.0));
            let class = if class == "hit" { "hit" } else { "quiet" };
            let label = format!("{t:.1}").replace('-', "−");
            drawing.label(class, dvec2(at(t).x, 190.0), &label);
        }
    }
    drawing.label("", dvec2(at(0.0).x, 190.0), "$t$ =");
    Figure {
        title: "A ray from S passes through two spheres in front of it, and its line through a third behind it. The six values of t are marked; the smallest above 0 is the nearest hit.",
        caption: "Six values of $t$ on one line. Those below 0 belong to the sphere behind the start. Of the \
                  others, the smallest is the hit you see. $k$ is the sphere's place in the list; it \
                  has no say in this.",
        drawing,
    }
}
