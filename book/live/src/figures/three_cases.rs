use super::Figure;
use crate::svg::{Drawing, View};
use glam::{DVec2, DVec3, dvec2};
use step02_sphere::{Ray, Roots, Sphere};

/// A ray that misses, touches and enters a circle, each above the parabola at² + bt
/// + c.
pub fn figure() -> Figure {
    let sphere = Sphere { centre: DVec3::ZERO, radius: 1.0 };
    let mut drawing = Drawing::new(480.0, 330.0);
    let cases = [
        (1.4, "$D$ < 0", "no root"),
        (1.0, "$D$ = 0", "one root"),
        (0.45, "$D$ > 0", "two roots"),
    ];
    for (k, (height, case, count)) in cases.into_iter().enumerate() {
        let x = 80.0 + 160.0 * f64::from(k as u32);
        let ray = Ray { start: DVec3::new(-2.1, height, 0.0), direction: DVec3::X };
        let roots = match sphere.intersect(&ray) {
            Roots::None => vec![],
            Roots::One(t) => vec![t],
            Roots::Two(near, far) => vec![near, far],
        };
        let above = View { origin: dvec2(x, 112.0), scale: DVec2::splat(33.0) };
        let below =
            View { origin: dvec2(x - 2.1 * 33.0, 246.0), scale: dvec2(33.0, 17.0) };
        let on_ray = |t: f64| above.at(ray.at(t).truncate());
        drawing.label("strong", dvec2(x, 20.0), case);
        drawing.label("quiet", dvec2(x, 40.0), count);
        drawing.circle("object", above.origin, 33.0);
        drawing.arrow("ray", on_ray(0.0), on_ray(4.25));
        drawing.dot("eye", on_ray(0.0));
        drawing.arrow("axis", below.xy(-0.1, 0.0), below.xy(4.35, 0.0));
        let (a, b, c) = sphere.coefficients(&ray);
        let curve: Vec<DVec2> = (0..=60)
            .map(|k| f64::from(k) * 0.07)
            .map(|t| below.xy(t, a * t * t + b * t + c))
            .collect();
        drawing.path("curve", &curve);
        for t in roots {
            drawing.line("guide", on_ray(t), below.xy(t, 0.0));
            drawing.dot("hit", on_ray(t));
            drawing.dot("hit", below.xy(t, 0.0));
        }
        drawing.label("quiet", below.xy(4.35, 0.0) + dvec2(-2.0, 18.0), "$t$");
    }
    drawing.label("", dvec2(240.0, 318.0), "$at^2$ + $bt$ + $c$ along each ray");
    Figure {
        title: "Three rays and a circle, each above the parabola at² + bt + c. Left: the ray misses and the parabola stays above the axis. Middle: the ray touches and the parabola touches the axis once. Right: the ray crosses and the parabola cuts the axis twice.",
        caption: "The three cases. Where the parabola crosses 0, the ray meets the circle: straight above \
                  each root is its point. The discriminant says which case it is before any root is known.",
        drawing,
    }
}
