//! A two-dimensional world in which every ball is a mirror.

use super::*;
use course::examples::shadows::{OFFSET, hidden};
use step05_phong::{Object, Ray, Sphere, SurfacePoint, reflect, visible_point};

const VIEW: View = View { origin: dvec2(0.0, 300.0), scale: dvec2(48.0, 48.0) };

const EYE: PointId = PointId("the eye S");
const END_OF_V: PointId = PointId("the end of V");
const LIGHT: PointId = PointId("the light q");

/// The centre and the radius of each ball.
const BALLS: [(PointId, f64); 4] = [
    (PointId("ball 1"), 1.2),
    (PointId("ball 2"), 0.55),
    (PointId("ball 3"), 0.8),
    (PointId("ball 4"), 0.9),
];

/// The points that the reader can drag, in the order of the handles. Each has a mark and a default
/// position.
const POINTS: [(PointId, Mark, [f64; 2]); 7] = [
    (EYE, Mark::Point, [0.6, 2.6]),
    (END_OF_V, Mark::Point, [1.8, 2.65]),
    (LIGHT, Mark::Light, [1.5, 5.3]),
    (BALLS[0].0, Mark::Point, [4.6, 1.7]),
    (BALLS[1].0, Mark::Point, [2.65, 4.0]),
    (BALLS[2].0, Mark::Point, [4.95, 5.1]),
    (BALLS[3].0, Mark::Point, [7.2, 2.3]),
];

const CONTENT: Content = Content::Drawing {
    title: "Four balls, an eye S and a light q in a plane. The ray from the eye meets ball 1 at p; ball 2 blocks the way from there to the light. The mirrored ray goes on to ball 3 and from there to ball 4, which is the only one in the light.",
    caption: "A world in a plane, where every ball mirrors: the ray from the eye meets {{#number flat-world:path}}. From each hit, a line leads \
                  to the light; where it's dotted, the light is hidden by another ball or by the one that was hit. (No ray is followed after its third hit.) \
                  <span class='move'>Drag anything: the light, say, until $p$ sees it.</span>",
    draw,
};

/// Four balls, an eye and a light in the plane z = 0, and the path of a ray.
pub fn figure() -> Figure {
    let ranges = [[0.4, 9.6], [0.4, 5.6]];
    Figure {
        parameters: POINTS
            .map(|(point, _, default)| Parameter::point(point, default, ranges, 20.0))
            .concat(),
        handles: POINTS
            .map(|(point, mark, _)| Handle { mark, ..Handle::of_point_in_drawing(point, VIEW) })
            .into(),
        readouts,
        // The eye must be outside the balls, and V must be long enough to be seen.
        has_something_to_show: |values| {
            let FlatWorld { ray: Ray { start, direction }, balls, .. } = FlatWorld::new(values);
            let is_outside = |ball: &Sphere| ball.centre.distance(start) > ball.radius;
            direction.length() > 0.3 && balls.iter().all(|ball| is_outside(&ball.sphere))
        },
        ..Figure::new("flat-world", CONTENT)
    }
}

/// The contents of the plane: the ray from the eye, the light q and the balls. The material of a
/// ball is the ball's number, which the drawing shows near the ball's centre.
struct FlatWorld {
    ray: Ray,
    q: DVec3,
    balls: Vec<Object<usize>>,
}

/// A point that is hit by the ray from the eye, or by a reflection of this ray.
struct PathPoint<'a> {
    point: SurfacePoint<'a, usize>,
    /// Whether the light reaches the point.
    is_lit: bool,
}

impl FlatWorld {
    fn new(values: &ParameterValues) -> Self {
        let point = |id| values.point(id).extend(0.0);
        let balls = BALLS.iter().zip(1..).map(|(&(centre, radius), material)| {
            let sphere = Sphere { centre: point(centre), radius };
            Object { name: "ball", sphere, material }
        });
        let ray = Ray { start: point(EYE), direction: point(END_OF_V) - point(EYE) };
        Self { ray, q: point(LIGHT), balls: balls.collect() }
    }

    /// Follows the ray from the eye, and the reflections of this ray, until the third hit. Returns
    /// the hits, and the ray that hits nothing, if there is such a ray.
    fn trace(&self) -> (Vec<PathPoint<'_>>, Option<Ray>) {
        let (mut hits, mut ray) = (vec![], self.ray);
        for _ in 0..3 {
            let Some(point) = visible_point(&self.balls, &ray) else { return (hits, Some(ray)) };
            let start = point.p + OFFSET * point.n;
            ray = Ray { start, direction: reflect(point.n, -ray.direction) };
            let is_lit = !hidden(&self.balls, &point, self.q, OFFSET);
            hits.push(PathPoint { point, is_lit });
        }
        (hits, None)
    }
}

/// Draws the balls, the path of the ray, and a line from each hit to the light.
fn draw(values: &ParameterValues) -> Drawing {
    let world = FlatWorld::new(values);
    let (hits, escaping_ray) = world.trace();
    let position = |point: DVec3| VIEW.to_drawing(point.truncate());
    let mut drawing = Drawing::new(300.0);
    for Object { sphere, material, .. } in &world.balls {
        let is_seen = hits.iter().any(|hit| hit.point.material() == material);
        let class = if is_seen { "object seen" } else { "object" };
        let radius = VIEW.scale.x * sphere.radius;
        drawing.circle(class, position(sphere.centre), radius);
        // The ball's number must overlap neither the ball's outline nor the ball's handle, which is
        // large on a phone.
        let label_offset = if radius < 35.0 { radius + 10.0 } else { 25.0 };
        let label = position(sphere.centre) + dvec2(label_offset, 5.0);
        drawing.label("over", label, &material.to_string());
    }
    // A ray that hits nothing is drawn past the edge of the drawing.
    let end = escaping_ray.map(|ray| ray.start + 20.0 * ray.direction.normalize());
    let corners = hits.iter().map(|hit| hit.point.p).chain(end);
    drawing.path("ray", [world.ray.start].into_iter().chain(corners).map(position));
    for PathPoint { point: SurfacePoint { p, n, .. }, is_lit } in &hits {
        let class = if *is_lit { "light" } else { "guide" };
        drawing.line(class, position(*p), position(world.q));
        drawing.arrow("second", position(*p), position(p + 0.7 * n));
        drawing.dot("hit", position(*p));
    }
    let [s, v, q] = [world.ray.start, world.ray.at(1.0), world.q];
    drawing.arrow("ray", position(s), position(v));
    drawing.dot("eye", position(s));
    drawing.circle("light head", position(q), 7.0);
    let point_above = |point: DVec3| point + 0.6 * DVec3::Y;
    let mut names = vec![(point_above(s), "$S$"), (point_above(v), "$V$"), (point_above(q), "$q$")];
    if let Some(PathPoint { point: SurfacePoint { p, n, .. }, .. }) = hits.first() {
        names.extend([(p - 0.4 * n, "$p$"), (p + 0.95 * n, "$n$")]);
    }
    for (point, name) in names {
        drawing.label("strong over", position(point) + DVec2::Y * 5.0, name);
    }
    drawing
}

/// Describes the hits of the ray from the eye, and the hits of its reflections.
fn readouts(values: &ParameterValues) -> Readouts {
    let world = FlatWorld::new(values);
    let (hits, escaping_ray) = world.trace();
    let hit_phrases = hits.iter().map(|PathPoint { point, is_lit }| {
        let lighting = if *is_lit { "in the light" } else { "in shadow" };
        format!(
            "ball {} at t = {}, {lighting}",
            point.material(),
            format_with_max_decimals(point.hit.t, 2)
        )
    });
    let phrases: Vec<_> = hit_phrases.chain(escaping_ray.map(|_| "nothing".into())).collect();
    collect_readouts([("path", phrases.join("; then "))])
}
