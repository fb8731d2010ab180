//! The three cases of the quadratic: a ray misses a circle, touches it or crosses it.

use super::*;
use course::discriminant;
use step02_sphere::{Ray, Sphere};

const SPHERE: Sphere = Sphere { centre: DVec3::ZERO, radius: 1.0 };

/// The start of each ray and the default y of this start, for the rays from left to right.
const STARTS: [(PointId, f64); 3] = [
    (PointId("the start of the left ray"), 1.375),
    (PointId("the start of the middle ray"), 1.0),
    (PointId("the start of the right ray"), 0.4375),
];

/// The values of x at which the drawing of a ray begins and ends.
const X_RANGE: [f64; 2] = [-2.125, 2.125];

const CONTENT: Content = Content::Drawing {
    title: "Three rays and a circle, each above the parabola at² + bt + c. Left: the ray misses and the parabola stays above the axis. Middle: the ray touches and the parabola touches the axis once. Right: the ray crosses and the parabola cuts the axis twice.",
    caption: "The three cases. Where the curve $at^2 + bt + c$ is 0, the line of the ray meets the circle, at the \
                  point straight above. The sign of $D$ says which case it is before any root is known. \
                  <span class='move'>Drag a ray until it touches.</span>",
    draw,
};

/// Three rays, each with a circle. Below each ray is its parabola at² + bt + c.
pub fn figure() -> Figure {
    let ranges = [[-2.25, 1.5], [-1.5, 1.5]];
    let handles = STARTS.iter().enumerate();
    Figure {
        parameters: STARTS
            .map(|(start, y)| Parameter::point(start, [-2.125, y], ranges, 16.0))
            .concat(),
        handles: handles
            .map(|(case, (start, _))| Handle::of_point_in_drawing(*start, circle_view(case)))
            .collect(),
        ..Figure::new("three-cases", CONTENT)
    }
}

/// Maps the ray and the circle of a case to the drawing.
fn circle_view(case: usize) -> View {
    let x = 80.0 + 160.0 * case as f64;
    View { origin: dvec2(x, 112.0), scale: DVec2::splat(33.0) }
}

/// Draws the three cases side by side.
fn draw(values: &ParameterValues) -> Drawing {
    let mut drawing = Drawing::new(362.0);
    for (case, (start, _)) in STARTS.iter().enumerate() {
        let ray = Ray { start: values.point(*start).extend(0.0), direction: DVec3::X };
        draw_ray_and_parabola(&mut drawing, &ray, circle_view(case));
    }
    drawing.label("", dvec2(240.0, 350.0), "$at$² + $bt$ + $c$ along each ray");
    drawing
}

/// Draws one case: the circle, the ray, and the parabola below them, with dots at the roots.
fn draw_ray_and_parabola(drawing: &mut Drawing, ray: &Ray, circle_view: View) {
    let x = circle_view.origin.x;
    // The parabola is straight below the ray, with t = 0 below the ray's start.
    let origin = dvec2(x + 33.0 * ray.start.x, 278.0);
    let parabola_view = View { origin, scale: dvec2(33.0, 16.0) };
    let [first, last] = X_RANGE.map(|end| end - ray.start.x);
    let on_ray = |t: f64| circle_view.to_drawing(ray.at(t).truncate());
    let on_axis = |t: f64| parabola_view.xy_to_drawing(t, 0.0);
    drawing.circle("object", circle_view.origin, 33.0);
    drawing.line("guide", on_ray(first.min(0.0)), on_ray(0.0));
    drawing.arrow("ray", on_ray(0.0), on_ray(last));
    drawing.dot("eye", on_ray(0.0));
    drawing.arrow("axis", on_axis(first - 0.1), on_axis(last + 0.1));
    drawing.label("quiet", on_axis(last + 0.1) + dvec2(-2.0, 18.0), "$t$");
    let tick = dvec2(0.0, 4.0);
    drawing.line("axis", origin - tick, origin + tick);
    drawing.label("quiet", origin + dvec2(0.0, 18.0), "0");
    let (a, b, c) = SPHERE.coefficients(ray);
    let curve = (0..=60).map(|k| {
        let t = first + (last - first) * f64::from(k) / 60.0;
        parabola_view.xy_to_drawing(t, a * t * t + b * t + c)
    });
    drawing.path("curve", curve);
    let roots = SPHERE.intersect(ray);
    for t in roots {
        let class = match roots.first_hit() {
            Some(hit) if hit == t => "hit",
            _ if t <= 0.0 => "behind",
            _ => "ray",
        };
        drawing.line("guide", on_ray(t), on_axis(t));
        drawing.dot(class, on_ray(t));
        drawing.dot(class, on_axis(t));
    }
    let format = |number: f64| format_with_max_decimals(number, 2);
    let discriminant = format!("$D$ = {}", format(discriminant(&SPHERE, ray)));
    drawing.label("strong", dvec2(x, 20.0), &discriminant);
    let values = roots.into_iter().map(format).collect::<Vec<_>>().join(" or ");
    let label = if values.is_empty() { "no root".into() } else { format!("$t$ = {values}") };
    drawing.label("quiet", dvec2(x, 40.0), &label);
}
