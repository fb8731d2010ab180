use crate::live::collect_numbers;
use crate::{Drawing, Handle, Live, Output, Parameter, View, format_fixed};
use exercises::shadows::{OFFSET, hidden};
use glam::{DVec2, DVec3, dvec2};
use step05_phong::{
    Object, Ray, Sphere, SurfacePoint, nearest, reflect, visible_point,
};

const VIEW: View = View { origin: dvec2(0.0, 300.0), scale: dvec2(48.0, 48.0) };

/// The largest x and y of what is dragged; the smallest is 0.4 each.
const LARGEST: DVec2 = dvec2(9.6, 5.9);

/// The number of mirrors that a ray may meet.
const DEPTH: usize = 2;

/// What is dragged, and where it is by default.
const DEFAULTS: [(&str, [f64; 2]); 7] = [
    ("the eye S", [0.6, 2.6]),
    ("the end of V", [1.8, 2.65]),
    ("the light q", [1.5, 5.3]),
    ("ball 1", [4.6, 1.7]),
    ("ball 2", [2.8, 3.9]),
    ("ball 3", [4.95, 5.1]),
    ("ball 4", [7.2, 2.3]),
];

/// The radii of the balls.
const RADII: [f64; 4] = [1.2, 0.45, 0.8, 0.9];

/// A world in the plane z = 0; the material of a ball is its number.
struct World {
    ray: Ray,
    q: DVec3,
    balls: Vec<Object<usize>>,
}

/// A hit on the way of a ray.
struct Hit<'a> {
    t: f64,
    point: SurfacePoint<'a, usize>,
    is_hidden: bool,
}

impl World {
    fn new(values: &[f64]) -> Self {
        let points =
            values.chunks_exact(2).map(|xy| DVec2::from_slice(xy).extend(0.0));
        let points: Vec<_> = points.collect();
        let balls = points[3..].iter().zip(RADII).zip(1..);
        let balls = balls.map(|((&centre, radius), number)| Object {
            name: "ball",
            sphere: Sphere { centre, radius },
            material: number,
        });
        let ray = Ray { start: points[0], direction: points[1] - points[0] };
        Self { ray, q: points[2], balls: balls.collect() }
    }

    /// Whether the eye is outside of the balls, and V long enough to be seen.
    fn is_allowed(&self) -> bool {
        let Ray { start, direction } = self.ray;
        let is_outside = |ball: &Object<usize>| {
            let Sphere { centre, radius } = ball.sphere;
            radius < centre.distance(start)
        };
        0.3 < direction.length() && self.balls.iter().all(is_outside)
    }

    /// The ray from the eye and the mirrored ones, each with its hit.
    fn path(&self) -> Vec<(Ray, Option<Hit<'_>>)> {
        let mut path = vec![];
        let mut ray = self.ray;
        for _ in 0..=DEPTH {
            let hit =
                nearest(&self.balls, &ray).zip(visible_point(&self.balls, &ray));
            let Some((hit, point)) = hit else {
                path.push((ray, None));
                break;
            };
            let is_hidden = hidden(&self.balls, &point, self.q);
            path.push((ray, Some(Hit { t: hit.t, point, is_hidden })));
            let direction = reflect(point.n, -ray.direction);
            ray = Ray { start: point.p + OFFSET * point.n, direction };
        }
        path
    }

    /// What the ray meets, in words.
    fn path_words(&self) -> String {
        let path = self.path();
        let words = path.iter().map(|(_, hit)| match hit {
            None => "nothing".to_string(),
            Some(Hit { t, point, is_hidden }) => format!(
                "ball {} at t = {}, {}",
                point.material,
                format_fixed(*t, 2),
                if *is_hidden { "in shadow" } else { "in the light" }
            ),
        });
        words.collect::<Vec<_>>().join("; then ")
    }
}

/// The rays of a flat world.
fn draw(world: &World) -> Drawing {
    let mut drawing = Drawing::new(480.0, 300.0);
    let place = |point: DVec3| VIEW.to_drawing(point.truncate());
    let path = world.path();
    for Object { sphere, material, .. } in &world.balls {
        let hits = path.iter().filter_map(|(_, hit)| hit.as_ref());
        let is_seen =
            hits.map(|hit| hit.point.material).any(|ball| ball == material);
        let class = if is_seen { "object seen" } else { "object" };
        let centre = place(sphere.centre);
        drawing.circle(class, centre, VIEW.scale.x * sphere.radius);
        drawing.label("over", centre + dvec2(0.0, 5.0), &material.to_string());
    }
    for hit in path.iter().filter_map(|(_, hit)| hit.as_ref()) {
        let SurfacePoint { p, n, .. } = hit.point;
        let start = p + OFFSET * n;
        let to_light = Ray { start, direction: world.q - start };
        let class = if hit.is_hidden { "guide" } else { "light" };
        drawing.line(class, place(p), place(world.q));
        let blocking = nearest(&world.balls, &to_light).filter(|_| hit.is_hidden);
        if let Some(blocking) = blocking {
            drawing.dot("behind", place(to_light.at(blocking.t)));
        }
    }
    for (ray, hit) in &path {
        // A ray that meets nothing leaves the drawing.
        let far = 20.0 / ray.direction.length();
        let t = hit.as_ref().map_or(far, |hit| hit.t);
        drawing.line("ray", place(ray.start), place(ray.at(t)));
        if let Some(SurfacePoint { p, n, .. }) = hit.as_ref().map(|hit| hit.point) {
            drawing.arrow("normal", place(p), place(p + 0.7 * n));
            drawing.dot("hit", place(p));
        }
    }
    let [s, q] = [world.ray.start, world.q].map(place);
    drawing.arrow("ray", s, place(world.ray.at(1.0)));
    drawing.dot("eye", s);
    drawing.circle("light head", q, 7.0);
    drawing.label("strong over", s + dvec2(0.0, -14.0), "$S$");
    drawing.label(
        "strong over",
        place(world.ray.at(1.0)) + dvec2(0.0, -14.0),
        "$V$",
    );
    drawing.label("strong over", q + dvec2(0.0, -13.0), "$q$");
    if let Some((_, Some(hit))) = path.first() {
        let SurfacePoint { p, n, .. } = hit.point;
        drawing.label("strong over", place(p - 0.4 * n) + dvec2(0.0, 5.0), "$p$");
        drawing.label("strong over", place(p + 0.95 * n) + dvec2(0.0, 5.0), "$n$");
    }
    drawing
}

/// A flat world whose parts the reader moves.
pub fn figure() -> Live {
    let ranges = LARGEST.to_array().map(|largest| [0.4, largest]);
    let parameters = DEFAULTS.iter().flat_map(|(_, place)| {
        let pairs = place.iter().zip(ranges);
        pairs.map(|(x, range)| Parameter::coordinate(*x, range, 20.0))
    });
    let handles = DEFAULTS.iter().enumerate().map(|(k, (words, _))| {
        Handle::new(
            *words,
            [2 * k, 2 * k + 1],
            |handle, values| Some(VIEW.to_drawing(handle.coordinates(values))),
            |_, _, place| VIEW.to_world(place),
        )
    });
    Live {
        title: "Four balls, an eye S and a light q in a plane. The ray from the eye meets ball 1 at p; ball 2 blocks the way from there to the light. The mirrored ray goes on to ball 3 and from there to ball 4, which is the only one in the light.",
        caption: "The same functions in a plane: the ray meets {{#number flat-world:path}}. From each hit, a line leads \
                  to the light; where it's dotted, the light is hidden. \
                  <span class='move'>Drag the light until $p$ sees it, or anything else.</span>",
        parameters: parameters.collect(),
        handles: handles.collect(),
        is_allowed: |values| World::new(values).is_allowed(),
        numbers: |values| {
            collect_numbers([("path", World::new(values).path_words())])
        },
        ..Live::new("flat-world", |values| {
            Output::Drawing(draw(&World::new(values)))
        })
    }
}
