use super::Figure;
use crate::live::{Handle, Knob, Live, Sight};
use crate::roots;
use crate::svg::{Drawing, View};
use glam::{DVec2, DVec3, dvec2};
use step03_nearest::{Object, Ray, Sphere, nearest};

/// A ray and three spheres that its reader moves, one behind its start.
pub const HITS: Live = Live {
    name: "hits-along-a-ray",
    knobs: &[
        side("sphere 0, sideways", 5.3, [-2.2, 6.2]),
        side("sphere 0, upwards", 0.35, [-1.0, 1.0]),
        side("sphere 1, sideways", -1.5, [-2.2, 6.2]),
        side("sphere 1, upwards", 0.2, [-1.0, 1.0]),
        side("sphere 2, sideways", 2.4, [-2.2, 6.2]),
        side("sphere 2, upwards", -0.3, [-1.0, 1.0]),
    ],
    handles: &[
        Handle::new(
            "the centre of sphere 0",
            [0, 1],
            |values| VIEW.xy(values[0], values[1]),
            |values, to| drag(&mut values[..2], to),
        ),
        Handle::new(
            "the centre of sphere 1",
            [2, 3],
            |values| VIEW.xy(values[2], values[3]),
            |values, to| drag(&mut values[2..4], to),
        ),
        Handle::new(
            "the centre of sphere 2",
            [4, 5],
            |values| VIEW.xy(values[4], values[5]),
            |values, to| drag(&mut values[4..], to),
        ),
    ],
    is_allowed: |_| true,
    sight: |values| Sight::Drawing(draw(values)),
    numbers: |_| vec![],
    beside: None,
};

const fn side(words: &'static str, value: f64, range: [f64; 2]) -> Knob {
    Knob::new(["", words, ""], value, range, 20.0)
}

const VIEW: View = View { origin: dvec2(136.0, 100.0), scale: dvec2(46.0, 46.0) };

/// Brings a centre to a place in the drawing.
fn drag(centre: &mut [f64], to: DVec2) {
    let world = (to - VIEW.origin) / VIEW.scale * dvec2(1.0, -1.0);
    centre.copy_from_slice(&world.to_array());
}

/// The three spheres, each of which is told by its place in the list.
fn objects(values: &[f64]) -> [Object<usize>; 3] {
    [0, 1, 2].map(|k| {
        let centre = DVec3::new(values[2 * k], values[2 * k + 1], 0.0);
        Object {
            sphere: Sphere { centre, radius: [1.0, 0.7, 0.8][k] },
            material: k,
        }
    })
}

/// One ray through the spheres, and every t on it.
fn draw(values: &[f64]) -> Drawing {
    let ray = Ray { start: DVec3::ZERO, direction: DVec3::X };
    let (objects, view) = (objects(values), VIEW);
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
        let beside = above.max(dvec2(0.0, 14.0));
        drawing.label("quiet", beside, &format!("$k$ = {k}"));
    }
    drawing.line("guide", at(-2.7), at(0.0));
    drawing.arrow("ray", at(0.0), at(7.2));
    drawing.dot("eye", at(0.0));
    drawing.label("strong", at(0.0) + dvec2(0.0, -12.0), "$S$");
    let every = objects.iter().flat_map(|object| roots(&object.sphere, &ray));
    let mut every: Vec<f64> = every.filter(|t| !t.is_nan()).collect();
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

/// One ray through several spheres, one behind its start, and every t on it.
pub fn figure() -> Figure {
    Figure {
        title: "A ray from S passes through two spheres in front of it, and its line through a third behind it. The six values of t are marked; the smallest above 0 is the nearest hit.",
        caption: "Every $t$ on one line. Those below 0 lie behind the start. Of the others, the smallest is the hit \
                  you see. $k$ is the sphere's place in the list; it has no say in this. \
                  <span class='move'>Drag another sphere in front.</span>",
        drawing: draw(&HITS.values()),
    }
}
