//! The points where one ray hits three spheres.

use super::*;
use std::iter::zip;
use step03_nearest::{Object, Ray, Sphere, nearest};

const VIEW: View = View { origin: dvec2(150.0, 112.0), scale: dvec2(44.0, 44.0) };

/// The centre and the radius of each sphere.
const SPHERES: [(PointId, f64); 3] = [
    (PointId("the centre of sphere 0"), 1.0),
    (PointId("the centre of sphere 1"), 0.7),
    (PointId("the centre of sphere 2"), 0.8),
];

const CONTENT: Content = Content::Drawing {
    title: "A ray from S passes through two spheres in front of it, and its line through a third behind it. The six values of t are marked; the smallest above 0 is the nearest hit.",
    caption: "Every $t$ on one line. Those below 0 lie behind the start. Of the others, the smallest is the hit \
                  you see. $k$ is the sphere's position in the list, counted from 0; here it doesn't matter. \
                  <span class='move'>Drag another sphere in front.</span>",
    draw,
};

/// A ray, and three spheres that the reader can move. By default, one sphere is behind the ray's
/// start.
pub fn figure() -> Figure {
    let defaults = [[5.3, 0.35], [-1.5, 0.2], [2.4, -0.3]];
    let ranges = [[-1.6, 5.6], [-1.0, 1.0]];
    Figure {
        parameters: zip(SPHERES, defaults)
            .flat_map(|((centre, _), default)| Parameter::point(centre, default, ranges, 20.0))
            .collect(),
        handles: SPHERES.map(|(centre, _)| Handle::of_point_in_drawing(centre, VIEW)).into(),
        ..Figure::new("hits-along-a-ray", CONTENT)
    }
}

/// Draws the spheres and the ray, with a dot at each root and the root's value below the dot.
fn draw(values: &ParameterValues) -> Drawing {
    let ray = Ray { start: DVec3::ZERO, direction: DVec3::X };
    let objects = SPHERES.iter().zip(0..).map(|(&(centre, radius), material)| Object {
        name: "sphere",
        sphere: Sphere { centre: values.point(centre).extend(0.0), radius },
        material,
    });
    let objects: Vec<Object<usize>> = objects.collect();
    let position = |t: f64| VIEW.to_drawing(ray.at(t).truncate());
    let nearest_hit = nearest(&objects, &ray);
    let mut drawing = Drawing::new(276.0);
    for Object { sphere, material: k, .. } in &objects {
        let is_hit = nearest_hit.is_some_and(|hit| hit.object.material == *k);
        let class = if is_hit { "object seen" } else { "object" };
        let centre = VIEW.to_drawing(sphere.centre.truncate());
        let radius = VIEW.scale.x * sphere.radius;
        drawing.circle(class, centre, radius);
        let label = centre - dvec2(0.0, radius + 9.0);
        drawing.label("quiet over", label, &format!("$k$ = {k}"));
    }
    drawing.line("guide", position(-2.7), position(0.0));
    drawing.arrow("ray", position(0.0), position(7.2));
    drawing.dot("eye", position(0.0));
    drawing.label("strong over", position(0.0) + dvec2(0.0, -12.0), "$S$");
    for Object { sphere, material: k, .. } in &objects {
        // Each sphere has a row in which the values of its roots are written. A line leads down
        // from the dot of each root to the root's value. The first value is to the left of its
        // line, and the second value is to the right of its line, so that the two values don't
        // overlap.
        let y = 222.0 + 20.0 * *k as f64;
        for (t, anchor) in sphere.intersect(&ray).into_iter().zip(["end", "start"]) {
            let (dot, label) = match nearest_hit {
                Some(hit) if hit.t == t => ("hit", "hit"),
                _ if t < 0.0 => ("behind", "quiet"),
                _ => ("ray", "quiet"),
            };
            drawing.dot(dot, position(t));
            drawing.line("axis", position(t) + dvec2(0.0, 8.0), position(t).with_y(y));
            let shift = if anchor == "end" { -4.0 } else { 4.0 };
            let class = format!("{label} over {anchor}");
            drawing.label(&class, dvec2(position(t).x + shift, y), &format_with_max_decimals(t, 1));
        }
    }
    drawing.label("over", dvec2(24.0, 204.0), "$t$ =");
    drawing
}
