use crate::camera;
use crate::live::{Live, Sight, digits};
use crate::pictures::{short_name, step03};
use crate::svg::{Drawing, View};
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::TAU;
use step03_nearest::{OBJECTS, Object, Ray, Sphere, nearest};

/// x runs right, and t upwards; it is the depth, as V_z is −1.
const VIEW: View = View { origin: dvec2(240.0, 236.0), scale: DVec2::splat(17.0) };

/// As far to the left and to the right as a line runs.
const SIDE: f64 = 13.0;

/// From where to where the line of a ray is drawn.
const ENDS: [f64; 2] = [-5.4, 13.2];

/// The scene from above, cut along the row of the pixel (i, j), and the ray of that
/// pixel with every root on its line.
pub fn draw(values: &[f64]) -> Drawing {
    let ray = camera().ray(values[0], values[1]);
    let seen = nearest(&OBJECTS, &ray);
    let mut drawing = Drawing::new(480.0, 330.0);
    draw_depths(&mut drawing);
    // The largest, the ground, lies below the others.
    let mut objects = OBJECTS;
    objects.sort_by(|a, b| b.sphere.radius.total_cmp(&a.sphere.radius));
    for Object { sphere, .. } in &objects[1..] {
        let centre = VIEW.xy(sphere.centre.x, -sphere.centre.z);
        drawing.circle("guide", centre, VIEW.scale.x * sphere.radius);
    }
    for Object { name, sphere, .. } in &objects {
        let Some(cut) = cut(sphere, &ray) else { continue };
        let is_seen = seen.is_some_and(|hit| hit.object.sphere == *sphere);
        drawing.area(if is_seen { "object seen" } else { "object" }, &cut);
        let middle = cut.iter().sum::<DVec2>() / cut.len() as f64;
        let inside = middle.max(dvec2(0.0, 16.0)) + dvec2(0.0, 5.0);
        drawing.label("quiet", inside, short_name(name));
    }
    let at = |t: f64| VIEW.xy(ray.at(t).x, t);
    drawing.line("guide", at(ENDS[0]), at(0.0));
    drawing.arrow("ray", at(0.0), at(ENDS[1]));
    drawing.dot("eye", at(0.0));
    let roots = OBJECTS.iter().flat_map(|o| o.sphere.intersect(&ray).iter());
    for t in roots.filter(|t| (ENDS[0]..ENDS[1]).contains(t)) {
        drawing.dot(if t < 0.0 { "behind" } else { "ray" }, at(t));
    }
    if let Some(t) = seen.map(|hit| hit.t) {
        let label = format!("$t$ = {}", digits(2, t));
        let right = VIEW.xy(SIDE, t);
        drawing.line("guide", at(t), right);
        drawing.label_to("hit small", right + dvec2(0.0, -5.0), &label);
        drawing.dot("hit", at(t));
    }
    drawing
}

/// A line across every 5 t.
fn draw_depths(drawing: &mut Drawing) {
    for t in [0.0, 5.0, 10.0] {
        let [left, right] = [-SIDE, SIDE].map(|x| VIEW.xy(x, t));
        drawing.line("grid", left, right);
        let above = left + dvec2(0.0, -5.0);
        drawing.label_from("quiet", above, &format!("$t$ = {t}"));
    }
}

/// The outline of what the plane through the row of `ray` cuts out of a sphere.
fn cut(sphere: &Sphere, ray: &Ray) -> Option<Vec<DVec2>> {
    let ahead = ray.direction.with_x(0.0);
    let along = ahead.normalize();
    let normal = DVec3::X.cross(along);
    let height = sphere.centre.dot(normal);
    let square = sphere.radius * sphere.radius - height * height;
    let radius = (0.0 < square).then(|| square.sqrt())?;
    let middle = dvec2(sphere.centre.x, sphere.centre.dot(along));
    let points = (0..90).map(|k| {
        let side = DVec2::from_angle(TAU * f64::from(k) / 90.0);
        let DVec2 { x, y } = middle + radius * side;
        VIEW.xy(x, y / ahead.length())
    });
    Some(points.collect())
}

/// What is drawn of the pixel that is asked as printed.
pub fn figure() -> Live {
    Live {
        title: "The scene of step 3 from above: the eye, the ray of a pixel, and what the plane of its row cuts out of each sphere; the roots are marked on the ray.",
        caption: "The scene from above, cut along row {{#number step03_nearest:j}}, with the ray of this pixel and \
                  every root on its line. $V_z$ is $-1$, so $t$ is the depth.",
        ..Live::new("from-above", |_| {
            Sight::Drawing(draw(&step03::picture().values()))
        })
    }
}
