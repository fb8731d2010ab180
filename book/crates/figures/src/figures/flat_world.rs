use crate::{
    Drawing, Handle, Interactive, Mark, Numbers, Output, Parameter, View, collect_numbers,
    format_fixed,
};
use course::examples::shadows::{OFFSET, hidden};
use glam::{DVec2, DVec3, dvec2};
use step05_phong::{Object, Ray, Sphere, SurfacePoint, nearest, reflect, visible_point};

const VIEW: View = View { origin: dvec2(0.0, 300.0), scale: dvec2(48.0, 48.0) };

/// The number of mirrors that a ray may meet.
const DEPTH: usize = 2;

/// The handles with their marks and their default places.
const HANDLES: [(&str, Mark, [f64; 2]); 7] = [
    ("the eye S", Mark::Point, [0.6, 2.6]),
    ("the end of V", Mark::Point, [1.8, 2.65]),
    ("the light q", Mark::Light, [1.5, 5.3]),
    ("ball 1", Mark::Point, [4.6, 1.7]),
    ("ball 2", Mark::Point, [2.65, 4.0]),
    ("ball 3", Mark::Point, [4.95, 5.1]),
    ("ball 4", Mark::Point, [7.2, 2.3]),
];

/// The radii of the balls.
const RADII: [f64; 4] = [1.2, 0.55, 0.8, 0.9];

/// A world in the plane z = 0; the material of a ball is its number.
pub struct FlatWorld {
    ray: Ray,
    q: DVec3,
    balls: Vec<Object<usize>>,
}

/// A hit on the way of a ray.
struct Hit<'a> {
    t: f64,
    point: SurfacePoint<'a, usize>,
    /// The point that hides the light, if one does.
    blocking: Option<DVec3>,
}

impl FlatWorld {
    /// The hits of the ray from the eye and the mirrored ones, and the ray that meets
    /// nothing, unless the depth was used up.
    fn trace(&self) -> (Vec<Hit<'_>>, Option<Ray>) {
        let (mut hits, mut ray) = (vec![], self.ray);
        for _ in 0..=DEPTH {
            let hit = nearest(&self.balls, &ray).zip(visible_point(&self.balls, &ray));
            let Some((hit, point)) = hit else { return (hits, Some(ray)) };
            let start = point.p + OFFSET * point.n;
            let to_light = Ray { start, direction: self.q - start };
            let blocking = nearest(&self.balls, &to_light).map(|hit| to_light.at(hit.t));
            let blocking = blocking.filter(|_| hidden(&self.balls, &point, self.q, OFFSET));
            hits.push(Hit { t: hit.t, point, blocking });
            ray = Ray { start, direction: reflect(point.n, -ray.direction) };
        }
        (hits, None)
    }
}

impl Interactive for FlatWorld {
    const NAME: &str = "flat-world";
    const TITLE: &str = "Four balls, an eye S and a light q in a plane. The ray from the eye meets ball 1 at p; ball 2 blocks the way from there to the light. The mirrored ray goes on to ball 3 and from there to ball 4, which is the only one in the light.";
    const CAPTION: &str = "A world in a plane, where every ball mirrors: the ray from the eye meets {{#number flat-world:path}}. From each hit, a line leads \
                  to the light; where it's dotted, something hides the light, perhaps the ball itself. (No ray is followed after its third hit.) \
                  <span class='move'>Drag anything: the light, say, until $p$ sees it.</span>";

    fn parameters() -> Vec<Parameter> {
        let ranges = [[0.4, 9.6], [0.4, 5.6]];
        HANDLES.map(|(.., point)| Parameter::point(point, ranges, 20.0)).concat()
    }

    fn from_values(values: &[f64]) -> Self {
        let points = values.chunks_exact(2).map(|point| DVec2::from_slice(point).extend(0.0));
        let points: Vec<_> = points.collect();
        let balls = points[3..].iter().zip(RADII).zip(1..).map(|((&centre, radius), material)| {
            let sphere = Sphere { centre, radius };
            Object { name: "ball", sphere, material }
        });
        let ray = Ray { start: points[0], direction: points[1] - points[0] };
        Self { ray, q: points[2], balls: balls.collect() }
    }

    fn handles() -> Vec<Handle> {
        let handles = (0..).zip(HANDLES).map(|(k, (words, mark, _))| {
            let handle = Handle::of_point(words, 2 * k, VIEW);
            Handle { mark, ..handle }
        });
        handles.collect()
    }

    /// Whether the eye is outside of the balls, and V long enough to be seen.
    fn is_allowed(&self) -> bool {
        let Ray { start, direction } = self.ray;
        let is_outside = |sphere: Sphere| sphere.radius < sphere.centre.distance(start);
        0.3 < direction.length() && self.balls.iter().all(|ball| is_outside(ball.sphere))
    }

    fn draw(&self) -> Output {
        let mut drawing = Drawing::new(480.0, 300.0);
        let place = |point: DVec3| VIEW.to_drawing(point.truncate());
        let (hits, leaving) = self.trace();
        for Object { sphere, material, .. } in &self.balls {
            let is_seen = hits.iter().any(|hit| hit.point.material == material);
            let centre = place(sphere.centre);
            let class = if is_seen { "object seen" } else { "object" };
            drawing.circle(class, centre, VIEW.scale.x * sphere.radius);
            // Beside the handle.
            drawing.label("over", centre + dvec2(21.0, 5.0), &material.to_string());
        }
        // A ray that meets nothing leaves the drawing.
        let end = leaving.map(|ray| ray.start + 20.0 * ray.direction.normalize());
        let corners = hits.iter().map(|hit| hit.point.p).chain(end);
        drawing.path("ray", [self.ray.start].into_iter().chain(corners).map(place));
        for Hit { point: SurfacePoint { p, n, .. }, blocking, .. } in &hits {
            let class = if blocking.is_some() { "guide" } else { "light" };
            drawing.line(class, place(*p), place(self.q));
            if let Some(blocking) = blocking {
                drawing.dot("behind", place(*blocking));
            }
            drawing.arrow("normal", place(*p), place(p + 0.7 * n));
            drawing.dot("hit", place(*p));
        }
        let [s, v, q] = [self.ray.start, self.ray.at(1.0), self.q].map(place);
        drawing.arrow("ray", s, v);
        drawing.dot("eye", s);
        drawing.circle("light head", q, 7.0);
        let above = dvec2(0.0, -19.0);
        for (place, text) in [(s, "$S$"), (v, "$V$"), (q, "$q$")] {
            drawing.label("strong over", place + above, text);
        }
        if let Some(SurfacePoint { p, n, .. }) = hits.first().map(|hit| hit.point) {
            for (text, length) in [("$p$", -0.4), ("$n$", 0.95)] {
                drawing.label("strong over", place(p + length * n) + dvec2(0.0, 5.0), text);
            }
        }
        Output::Drawing(drawing)
    }

    /// The sentence about what the ray meets.
    fn numbers(&self) -> Numbers {
        let (hits, leaving) = self.trace();
        let words = hits.iter().map(|Hit { t, point, blocking }| {
            let place = if blocking.is_some() { "in shadow" } else { "in the light" };
            format!("ball {} at t = {}, {place}", point.material, format_fixed(*t, 2))
        });
        let words = words.chain(leaving.map(|_| "nothing".into()));
        collect_numbers([("path", words.collect::<Vec<_>>().join("; then "))])
    }
}
