use crate::{Drawing, Handle, Interactive, Output, Parameter, View, discriminant, format_rounded};
use glam::{DVec2, DVec3, dvec2};
use step02_sphere::{Ray, Roots, Sphere};

const SPHERE: Sphere = Sphere { centre: DVec3::ZERO, radius: 1.0 };

/// The x from which and to which a ray is drawn.
const X_RANGE: [f64; 2] = [-2.125, 2.125];

/// The map of a case's ray and circle.
fn circle_view(case: usize) -> View {
    let x = 80.0 + 160.0 * case as f64;
    View { origin: dvec2(x, 112.0), scale: DVec2::splat(33.0) }
}

/// The labels of the discriminant and of the roots.
fn labels(ray: &Ray) -> [String; 2] {
    let d = discriminant(&SPHERE, ray);
    let sign = match d {
        0.0 => "",
        ..0.0 => " < 0",
        _ => " > 0",
    };
    let format = |number: f64| format_rounded(number, 2);
    let roots = match SPHERE.intersect(ray) {
        Roots::Zero => "no root".into(),
        Roots::One(t) => format!("one root: {}", format(t)),
        Roots::Two(near, far) => format!("two roots: {}, {}", format(near), format(far)),
    };
    [format!("$D$ = {}{sign}", format(d)), roots]
}

fn draw_case(drawing: &mut Drawing, ray: &Ray, case: usize) {
    let circle_view = circle_view(case);
    let x = circle_view.origin.x;
    // The parabola is straight below the ray: t = 0 is below the start.
    let origin = dvec2(x + 33.0 * ray.start.x, 262.0);
    let parabola_view = View { origin, scale: dvec2(33.0, 16.0) };
    let [first, last] = X_RANGE.map(|end| end - ray.start.x);
    let on_ray = |t: f64| circle_view.to_drawing(ray.at(t).truncate());
    let [discriminant, root_words] = labels(ray);
    drawing.label("strong", dvec2(x, 20.0), &discriminant);
    drawing.label("quiet", dvec2(x, 40.0), &root_words);
    drawing.circle("object", circle_view.origin, 33.0);
    if first < 0.0 {
        drawing.line("guide", on_ray(first), on_ray(0.0));
    }
    drawing.arrow("ray", on_ray(0.0), on_ray(last));
    drawing.dot("eye", on_ray(0.0));
    let on_axis = |t: f64| parabola_view.xy_to_drawing(t, 0.0);
    drawing.arrow("axis", on_axis(first - 0.1), on_axis(last + 0.1));
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
    for t in roots.iter() {
        let class = match roots.first_hit() {
            Some(hit) if hit == t => "hit",
            _ if t <= 0.0 => "behind",
            _ => "ray",
        };
        drawing.line("guide", on_ray(t), on_axis(t));
        drawing.dot(class, on_ray(t));
        drawing.dot(class, on_axis(t));
    }
    drawing.label("quiet", on_axis(last + 0.1) + dvec2(-2.0, 18.0), "$t$");
}

/// Three rays and a circle, each above its parabola at² + bt + c.
pub struct ThreeCases {
    starts: Vec<DVec2>,
}

impl Interactive for ThreeCases {
    const NAME: &str = "three-cases";
    const TITLE: &str = "Three rays and a circle, each above the parabola at² + bt + c. Left: the ray misses and the parabola stays above the axis. Middle: the ray touches and the parabola touches the axis once. Right: the ray crosses and the parabola cuts the axis twice.";
    const CAPTION: &str = "The three cases. Where the curve $at^2 + bt + c$ is 0, the ray meets the circle, at the point \
                  straight above. The sign of $D$ says which case it is before any root is known. \
                  <span class='move'>Drag a ray until it touches.</span>";

    fn parameters() -> Vec<Parameter> {
        let ranges = [[-2.25, 1.5], [-1.5, 1.5]];
        [1.375, 1.0, 0.4375].map(|y| Parameter::point([-2.125, y], ranges, 16.0)).concat()
    }

    fn from_values(values: &[f64]) -> Self {
        Self { starts: values.chunks_exact(2).map(DVec2::from_slice).collect() }
    }

    fn handles() -> Vec<Handle> {
        let handles = ["left", "middle", "right"].iter().zip(0..).map(|(name, case)| {
            let words = format!("the start of the {name} ray");
            Handle::of_point(&words, 2 * case, circle_view(case))
        });
        handles.collect()
    }

    fn draw(&self) -> Output {
        let mut drawing = Drawing::new(480.0, 346.0);
        for (case, start) in self.starts.iter().enumerate() {
            let ray = Ray { start: start.extend(0.0), direction: DVec3::X };
            draw_case(&mut drawing, &ray, case);
        }
        drawing.label("", dvec2(240.0, 334.0), "$at^2$ + $bt$ + $c$ along each ray");
        Output::Drawing(drawing)
    }
}
