use crate::{
    Drawing, Handle, Interactive, Numbers, Output, Parameter, View, collect_numbers,
    degrees_left_of_up, format_rounded,
};
use glam::{DVec2, DVec3, dvec2};
use step05_phong::{OBJECTS, WARM, reflect, visible_point};

/// The place of the hit in the drawing, and the length of 1.
const VIEW: View = View { origin: dvec2(240.0, 240.0), scale: DVec2::splat(190.0) };

/// The unit vectors n, l, r and v at a hit of the scene, with a light to turn.
pub struct PhongVectors {
    n: DVec3,
    l: DVec3,
    v: DVec3,
    /// The tangent: perpendicular to n, on the side of the light.
    tangent: DVec3,
}

impl PhongVectors {
    /// The vectors where the scene's warm light is turned by `turn` degrees away from n.
    fn with_turned_light(turn: f64) -> Self {
        let ray = course::camera().ray(262.0, 132.0);
        let objects = OBJECTS;
        let point = visible_point(&objects, &ray);
        let (p, n) = point.map_or((ray.start, DVec3::Y), |hit| (hit.p, hit.n));
        let (l, _) = WARM.direction_from(p);
        let tangent = (l - l.dot(n) * n).normalize_or_zero();
        let rotation = DVec2::from_angle(turn.to_radians());
        let DVec2 { x, y } = rotation.rotate(dvec2(l.dot(n), l.dot(tangent)));
        Self { n, l: x * n + y * tangent, v: -ray.direction.normalize(), tangent }
    }

    /// The angle between n and l, in degrees.
    fn angle(&self) -> f64 {
        self.l.dot(self.tangent).atan2(self.l.dot(self.n)).to_degrees()
    }

    /// The projection of a vector to the plane of n and l: n is up, and l to the left.
    fn project(&self, vector: DVec3) -> DVec2 {
        dvec2(-vector.dot(self.tangent), vector.dot(self.n))
    }
}

impl Interactive for PhongVectors {
    const NAME: &str = "phong-vectors";
    const TITLE: &str = "A point on a sphere with four unit vectors: n straight up out of the surface, l to the light on the left, r its mirror image on the right, and v to the eye.";
    const CAPTION: &str = "The four vectors where the ray through column 262, row 132 meets the red sphere. $l$ and $r$ \
                  make the same angle with $n$, {{#number phong-vectors:angle}}°. All four are one unit long; $v$ is drawn shorter because it \
                  leans out of the plane of the other three. <span class='move'>Turn the light until it is behind the surface.</span>";

    fn parameters() -> Vec<Parameter> {
        vec![Parameter::new(["", "turn of the light", "°"], 0.0, [-30.0, 80.0], 1.0)]
    }

    fn from_values(values: &[f64]) -> Self {
        Self::with_turned_light(values[0])
    }

    fn handles() -> Vec<Handle> {
        let locate = |vectors: &Self| VIEW.to_drawing(vectors.project(vectors.l));
        let turn_at = |_: &Self, place| {
            degrees_left_of_up(VIEW.origin, place) - Self::with_turned_light(0.0).angle()
        };
        vec![Self::handle_of_one("the light l", 0, locate, turn_at)]
    }

    fn draw(&self) -> Output {
        let mut drawing = Drawing::new(480.0, 320.0);
        let p = VIEW.origin;
        drawing.circle("object", p + dvec2(0.0, 300.0), 300.0);
        let [n, l, r, v] =
            [self.n, self.l, reflect(self.n, self.l), self.v].map(|vector| self.project(vector));
        drawing.arc("angle", p, 62.0, [n.to_angle(), n.to_angle() + n.angle_to(l)]);
        drawing.arc("angle", p, 62.0, [n.to_angle() + n.angle_to(r), n.to_angle()]);
        // The names of l and r stand on different sides of n, wherever the light is.
        let outward = if l.x < 0.0 { dvec2(-20.0, -4.0) } else { dvec2(20.0, -4.0) };
        let arrows = [
            ("light", l, "$l$", outward),
            ("normal", n, "$n$", dvec2(0.0, -12.0)),
            ("vector", r, "$r$", dvec2(-outward.x, -4.0)),
            ("accent", v, "$v$", dvec2(2.0, -12.0)),
        ];
        for (class, vector, name, shift) in arrows {
            let tip = VIEW.to_drawing(vector);
            drawing.arrow(class, p, tip);
            drawing.label("strong over", tip + shift, name);
        }
        drawing.dot("hit", p);
        Output::Drawing(drawing)
    }

    fn numbers(&self) -> Numbers {
        collect_numbers([("angle", format_rounded(self.angle().abs(), 1))])
    }
}
