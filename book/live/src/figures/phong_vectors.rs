use super::Figure;
use crate::camera;
use crate::svg::{Drawing, View};
use glam::{DVec2, DVec3, dvec2};
use step05_phong::{WARM, objects, reflect, seen};

/// n, l, r and v at a hit of the scene, seen at a right angle to the plane of n and
/// l.
pub fn figure() -> Figure {
    let ray = camera().ray(262.0, 132.0);
    let mut drawing = Drawing::new(480.0, 320.0);
    if let Some(point) = seen(&objects(), &ray) {
        let (l, _) = WARM.seen_from(point.p);
        draw(&mut drawing, point.n, l, -ray.direction.normalize());
    }
    Figure {
        title: "A point on a sphere with four unit vectors: n straight up out of the surface, l to the light on the left, r its mirror image on the right, and v to the eye.",
        caption: "The four vectors where the ray through column 262, row 132 meets the red sphere. $l$ and $r$ \
                  make the same angle with $n$. All four are one unit long; $v$ is drawn shorter because it \
                  leans out of the plane of the other three.",
        drawing,
    }
}

/// Draws the four vectors, with n upwards and l to the left of it.
fn draw(drawing: &mut Drawing, n: DVec3, l: DVec3, v: DVec3) {
    let view = View { origin: dvec2(240.0, 240.0), scale: DVec2::splat(190.0) };
    let left = (l - l.dot(n) * n).normalize_or_zero();
    let flat = |vector: DVec3| dvec2(-vector.dot(left), vector.dot(n));
    let p = view.origin;
    let radius = 300.0;
    drawing.circle("object", p + dvec2(0.0, radius), radius);
    let angle = |vector: DVec3| flat(vector).to_angle();
    drawing.arc("angle", p, 62.0, angle(n), angle(l));
    drawing.arc("angle", p, 62.0, angle(reflect(l, n)), angle(n));
    let vectors = [
        ("light", l, "$l$", dvec2(-10.0, -2.0)),
        ("normal", n, "$n$", dvec2(0.0, -10.0)),
        ("vector", reflect(l, n), "$r$", dvec2(10.0, -2.0)),
        ("accent", v, "$v$", dvec2(2.0, -12.0)),
    ];
    for (class, vector, name, shift) in vectors {
        let tip = view.at(flat(vector));
        drawing.arrow(class, p, tip);
        drawing.label("strong", tip + shift, name);
    }
    drawing.dot("hit", p);
}
