use crate::camera;
use crate::live::{Handle, Knob, Live, Sight, digits, named};
use crate::svg::{Drawing, View, degrees_left};
use glam::{DVec2, DVec3, dvec2};
use step05_phong::{OBJECTS, WARM, reflect, visible_point};

/// Where in the drawing the hit is, and how long 1 is.
const VIEW: View = View { origin: dvec2(240.0, 240.0), scale: DVec2::splat(190.0) };

/// The unit vectors at the hit.
struct Vectors {
    n: DVec3,
    l: DVec3,
    v: DVec3,
    /// At a right angle to n, on the side of the light.
    left: DVec3,
}

impl Vectors {
    /// Those of a light that is turned so many degrees away from n.
    fn new(values: &[f64]) -> Self {
        let ray = camera().ray(262.0, 132.0);
        let objects = OBJECTS;
        let point = visible_point(&objects, &ray);
        let (p, n) = point.map_or((ray.start, DVec3::Y), |hit| (hit.p, hit.n));
        let (l, _) = WARM.direction_from(p);
        let left = (l - l.dot(n) * n).normalize_or_zero();
        let turn = DVec2::from_angle(values[0].to_radians());
        let turned = turn.rotate(dvec2(l.dot(n), l.dot(left)));
        let l = turned.x * n + turned.y * left;
        Self { n, l, v: -ray.direction.normalize(), left }
    }

    fn r(&self) -> DVec3 {
        reflect(self.n, self.l)
    }

    /// The angle between n and l, in degrees.
    fn angle(&self) -> f64 {
        self.l.dot(self.left).atan2(self.l.dot(self.n)).to_degrees()
    }

    /// A vector in the plane of n and l, with n upwards and l to the left of it.
    fn flat(&self, vector: DVec3) -> DVec2 {
        dvec2(-vector.dot(self.left), vector.dot(self.n))
    }
}

/// The four, seen at a right angle to the plane of n and l.
fn draw(values: &[f64]) -> Drawing {
    let all = Vectors::new(values);
    let mut drawing = Drawing::new(480.0, 320.0);
    let p = VIEW.origin;
    let radius = 300.0;
    drawing.circle("object", p + dvec2(0.0, radius), radius);
    let [n, l, r, v] = [all.n, all.l, all.r(), all.v].map(|one| all.flat(one));
    drawing.arc("angle", p, 62.0, [n.to_angle(), n.to_angle() + n.angle_to(l)]);
    drawing.arc("angle", p, 62.0, [n.to_angle() + n.angle_to(r), n.to_angle()]);
    // The names of l and r are on their own sides of n's, wherever the light is.
    let outward = if l.x < 0.0 { dvec2(-20.0, -4.0) } else { dvec2(20.0, -4.0) };
    let vectors = [
        ("light", l, "$l$", outward),
        ("normal", n, "$n$", dvec2(0.0, -12.0)),
        ("vector", r, "$r$", dvec2(-outward.x, -4.0)),
        ("accent", v, "$v$", dvec2(2.0, -12.0)),
    ];
    for (class, vector, name, shift) in vectors {
        let tip = VIEW.at(vector);
        drawing.arrow(class, p, tip);
        drawing.label("strong", tip + shift, name);
    }
    drawing.dot("hit", p);
    drawing
}

/// n, l, r and v at a hit of the scene, where the light is turned from its place.
pub fn figure() -> Live {
    Live {
        title: "A point on a sphere with four unit vectors: n straight up out of the surface, l to the light on the left, r its mirror image on the right, and v to the eye.",
        caption: "The four vectors where the ray through column 262, row 132 meets the red sphere. $l$ and $r$ \
                  make the same angle with $n$, {{#number phong-vectors:angle}}°. All four are one unit long; $v$ is drawn shorter because it \
                  leans out of the plane of the other three. <span class='move'>Turn the light until it is behind the surface.</span>",
        knobs: vec![Knob::new(
            ["", "turn of the light", "°"],
            0.0,
            [-30.0, 80.0],
            1.0,
        )],
        handles: vec![Handle::new(
            "the light l",
            [0, 0],
            |_, values| {
                let all = Vectors::new(values);
                VIEW.at(all.flat(all.l))
            },
            |_, _, to| {
                let straight = Vectors::new(&[0.0]).angle();
                DVec2::splat(degrees_left(VIEW.origin, to) - straight)
            },
        )],
        numbers: |values| {
            named([("angle", digits(1, Vectors::new(values).angle()))])
        },
        ..Live::new("phong-vectors", |values| Sight::Drawing(draw(values)))
    }
}
