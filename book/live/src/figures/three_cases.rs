use crate::discriminant;
use crate::live::{Handle, Knob, Live, Sight, digits};
use crate::svg::{Drawing, View};
use glam::{DVec2, DVec3, dvec2};
use step02_sphere::{Ray, Roots, Sphere};

/// The start of a case's ray.
fn handle((case, name): (usize, &str)) -> Handle {
    Handle::new(
        format!("the start of the {name} ray"),
        [2 * case, 2 * case + 1],
        |handle, values| {
            let case = handle.knobs[0] / 2;
            above(case).at(ray(values, case).start.truncate())
        },
        |handle, _, to| above(handle.knobs[0] / 2).world(to),
    )
}

const SPHERE: Sphere = Sphere { centre: DVec3::ZERO, radius: 1.0 };

/// As far as a ray is drawn, to the left and to the right.
const ENDS: [f64; 2] = [-2.125, 2.125];

/// The map of a case's ray and circle.
fn above(case: usize) -> View {
    let x = 80.0 + 160.0 * case as f64;
    View { origin: dvec2(x, 112.0), scale: DVec2::splat(33.0) }
}

fn ray(values: &[f64], case: usize) -> Ray {
    let [x, y] = [values[2 * case], values[2 * case + 1]];
    Ray { start: DVec3::new(x, y, 0.0), direction: DVec3::X }
}

fn draw(values: &[f64]) -> Drawing {
    let mut drawing = Drawing::new(480.0, 330.0);
    for case in 0..3 {
        draw_case(&mut drawing, &ray(values, case), case);
    }
    drawing.label("", dvec2(240.0, 318.0), "$at^2$ + $bt$ + $c$ along each ray");
    drawing
}

/// What the discriminant says, and the roots.
fn words(ray: &Ray) -> [String; 2] {
    let d = discriminant(&SPHERE, ray);
    let sign = match d {
        0.0 => "",
        ..0.0 => " < 0",
        _ => " > 0",
    };
    let t = |t: f64| digits(2, t);
    let count = match SPHERE.intersect(ray) {
        Roots::Zero => "no root".to_string(),
        Roots::One(touch) => format!("one root: {}", t(touch)),
        Roots::Two(near, far) => format!("two roots: {}, {}", t(near), t(far)),
    };
    [format!("$D$ = {}{sign}", t(d)), count]
}

fn draw_case(drawing: &mut Drawing, ray: &Ray, case: usize) {
    let above = above(case);
    let x = above.origin.x;
    // Straight below the ray: t = 0 is below its start.
    let zero = dvec2(x + 33.0 * ray.start.x, 246.0);
    let below = View { origin: zero, scale: dvec2(33.0, 17.0) };
    let [first, last] = ENDS.map(|end| end - ray.start.x);
    let on_ray = |t: f64| above.at(ray.at(t).truncate());
    let [discriminant, count] = words(ray);
    drawing.label("strong", dvec2(x, 20.0), &discriminant);
    drawing.label("quiet", dvec2(x, 40.0), &count);
    drawing.circle("object", above.origin, 33.0);
    if first < 0.0 {
        drawing.line("guide", on_ray(first), on_ray(0.0));
    }
    drawing.arrow("ray", on_ray(0.0), on_ray(last));
    drawing.dot("eye", on_ray(0.0));
    drawing.arrow("axis", below.xy(first - 0.1, 0.0), below.xy(last + 0.1, 0.0));
    let (a, b, c) = SPHERE.coefficients(ray);
    let curve: Vec<DVec2> = (0..=60)
        .map(|k| first + (last - first) * f64::from(k) / 60.0)
        .map(|t| below.xy(t, a * t * t + b * t + c))
        .collect();
    drawing.path("curve", &curve);
    for t in SPHERE.intersect(ray).iter() {
        let class = if t <= 0.0 { "behind" } else { "hit" };
        drawing.line("guide", on_ray(t), below.xy(t, 0.0));
        drawing.dot(class, on_ray(t));
        drawing.dot(class, below.xy(t, 0.0));
    }
    drawing.label("quiet", below.xy(last + 0.1, 0.0) + dvec2(-2.0, 18.0), "$t$");
}

/// Three rays and a circle, each above its parabola at² + bt + c.
pub fn figure() -> Live {
    Live {
        title: "Three rays and a circle, each above the parabola at² + bt + c. Left: the ray misses and the parabola stays above the axis. Middle: the ray touches and the parabola touches the axis once. Right: the ray crosses and the parabola cuts the axis twice.",
        caption: "The three cases. Where the curve $at^2 + bt + c$ is 0, the ray meets the circle, at the point \
                  straight above. The discriminant says which case it is before any root is known. \
                  <span class='move'>Drag a ray until it touches.</span>",
        // In sixteenths, sums and products are exact: so a ray that touches does so to the
        // last digit.
        knobs: [1.375, 1.0, 0.4375]
            .into_iter()
            .flat_map(|y| {
                let x = Knob::turned(-2.125, [-2.25, 1.875], 16.0);
                [x, Knob::turned(y, [-1.5, 1.5], 16.0)]
            })
            .collect(),
        handles: ["left", "middle", "right"]
            .into_iter()
            .enumerate()
            .map(handle)
            .collect(),
        ..Live::new("three-cases", |values| Sight::Drawing(draw(values)))
    }
}
