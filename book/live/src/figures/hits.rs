use crate::live::{Handle, Knob, Live, Sight};
use crate::svg::{Drawing, View};
use glam::{DVec3, dvec2};
use step03_nearest::{Object, Ray, Sphere, nearest};

const VIEW: View = View { origin: dvec2(136.0, 100.0), scale: dvec2(46.0, 46.0) };

/// The centre of a sphere.
fn handle(k: usize) -> Handle {
    Handle::new(
        format!("the centre of sphere {k}"),
        [2 * k, 2 * k + 1],
        |handle, values| VIEW.at(handle.point(values)),
        |_, _, to| VIEW.world(to),
    )
}

/// The three spheres, each of which is told by its place in the list.
fn objects(values: &[f64]) -> [Object<usize>; 3] {
    [(0, 1.0), (1, 0.7), (2, 0.8)].map(|(k, radius)| {
        let centre = DVec3::new(values[2 * k], values[2 * k + 1], 0.0);
        let sphere = Sphere { centre, radius };
        Object { name: "sphere", sphere, material: k }
    })
}

/// One ray through the spheres, and every t on it.
fn draw(values: &[f64]) -> Drawing {
    let ray = Ray { start: DVec3::ZERO, direction: DVec3::X };
    let (objects, view) = (objects(values), VIEW);
    let at = |t: f64| view.at(ray.at(t).truncate());
    let seen = nearest(&objects, &ray);
    let mut drawing = Drawing::new(480.0, 210.0);
    for Object { sphere, material: k, .. } in &objects {
        let is_seen = seen.is_some_and(|hit| hit.object.material == *k);
        let class = if is_seen { "object seen" } else { "object" };
        let centre = view.at(sphere.centre.truncate());
        let radius = view.scale.x * sphere.radius;
        drawing.circle(class, centre, radius);
        let above = centre - dvec2(0.0, radius + 9.0);
        let beside = above.max(dvec2(0.0, 14.0));
        drawing.label("quiet", beside, &format!("$k$ = {k}"));
    }
    drawing.line("guide", at(-2.7), at(0.0));
    drawing.arrow("ray", at(0.0), at(7.2));
    drawing.dot("eye", at(0.0));
    drawing.label("strong", at(0.0) + dvec2(0.0, -12.0), "$S$");
    let every = objects.iter().flat_map(|o| o.sphere.intersect(&ray).iter());
    let mut every: Vec<f64> = every.collect();
    every.sort_by(f64::total_cmp);
    // Where a label stands already, the next goes below; "t =" is the first.
    let mut taken = vec![at(0.0).x];
    for t in every {
        let class = match seen {
            Some(hit) if hit.t == t => "hit",
            _ if t < 0.0 => "behind",
            _ => "ray",
        };
        drawing.dot(class, at(t));
        drawing.line("leader", at(t) + dvec2(0.0, 8.0), dvec2(at(t).x, 172.0));
        let class = if class == "hit" { "hit" } else { "quiet" };
        let label = format!("{t:.1}").replace('-', "−");
        let is_taken = taken.iter().any(|x| (at(t).x - x).abs() < 27.0);
        let y = if is_taken { 206.0 } else { 190.0 };
        if !is_taken {
            taken.push(at(t).x);
        }
        drawing.label(class, dvec2(at(t).x, y), &label);
    }
    drawing.label("", dvec2(at(0.0).x, 190.0), "$t$ =");
    drawing
}

/// A ray and three spheres that its reader moves, one behind its start.
pub fn figure() -> Live {
    Live {
        title: "A ray from S passes through two spheres in front of it, and its line through a third behind it. The six values of t are marked; the smallest above 0 is the nearest hit.",
        caption: "Every $t$ on one line. Those below 0 lie behind the start. Of the others, the smallest is the hit \
                  you see. $k$ is the sphere's place in the list; here it doesn't matter. \
                  <span class='move'>Drag another sphere in front.</span>",
        knobs: [[5.3, 0.35], [-1.5, 0.2], [2.4, -0.3]]
            .into_iter()
            .flat_map(|[x, y]| {
                [
                    Knob::turned(x, [-2.2, 6.2], 20.0),
                    Knob::turned(y, [-1.0, 1.0], 20.0),
                ]
            })
            .collect(),
        handles: [0, 1, 2].map(handle).into(),
        ..Live::new("hits-along-a-ray", |values| Sight::Drawing(draw(values)))
    }
}
