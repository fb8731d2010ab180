//! The scene of step 3 from above, with the ray of the pixel that the reader has chosen in the
//! picture of step 3.

use super::*;
use crate::pictures::step03;
use crate::probe::probe_ray;
use std::f64::consts::TAU;
use step03_nearest::{OBJECTS, Object, Ray, Sphere, nearest};

/// Maps (x, t) to the drawing. Since V_z is −1, t is the depth.
const VIEW: View = View { origin: dvec2(240.0, 236.0), scale: DVec2::splat(17.0) };

/// How far the lines of equal t extend to the left and to the right.
const SIDE: f64 = 13.0;

/// The smallest and the largest t in the drawing.
const T_RANGE: [f64; 2] = [-5.4, 13.2];

const CONTENT: Content = Content::Drawing {
    title: "The scene of step 3 from above: the eye, the ray of a pixel, and what the plane of its row cuts out of each sphere; the roots are marked on the ray.",
    caption: "The scene from above, cut along row {{#number step03_nearest:j}}, with the ray of this pixel and \
                  every root on the visible part of its line. $V_z$ is $-1$, so $t$ is the depth.",
    draw,
};

/// The scene from above, cut along the row of a pixel, with the ray of that pixel and every root on
/// the visible part of the ray's line.
pub fn figure() -> Figure {
    Figure {
        values_from: Some("step03_nearest"),
        parameters: step03::figure().parameters,
        ..Figure::new("scene-from-above", CONTENT)
    }
}

/// Returns the outline, in the drawing, of the disc that a plane cuts out of a sphere. The plane
/// contains `ray` and all other rays of the same row of pixels. Returns None if the plane misses
/// the sphere.
fn outline_in_plane_of_row(sphere: &Sphere, ray: &Ray) -> Option<Vec<DVec2>> {
    let direction_without_x = ray.direction.with_x(0.0);
    let unit_direction = direction_without_x.normalize();
    let normal = DVec3::X.cross(unit_direction);
    let height = sphere.centre.dot(normal);
    let square = sphere.radius * sphere.radius - height * height;
    let radius = (square > 0.0).then(|| square.sqrt())?;
    let middle = dvec2(sphere.centre.x, sphere.centre.dot(unit_direction));
    let points = (0..90).map(|k| {
        let side = DVec2::from_angle(TAU * f64::from(k) / 90.0);
        VIEW.to_drawing((middle + radius * side) / dvec2(1.0, direction_without_x.length()))
    });
    Some(points.collect())
}

/// Draws lines of equal t, the outline of each sphere, and the ray with its roots.
fn draw(values: &ParameterValues) -> Drawing {
    let ray = probe_ray(values);
    let nearest_hit = nearest(&OBJECTS, &ray);
    let mut drawing = Drawing::new(330.0);
    for t in [0.0, 5.0, 10.0] {
        let [left, right] = [-SIDE, SIDE].map(|x| VIEW.xy_to_drawing(x, t));
        drawing.line("grid", left, right);
        drawing.label("quiet start", left + dvec2(0.0, -5.0), &format!("$t$ = {t}"));
    }
    // The largest sphere, the ground, is drawn first, so that it doesn't cover the other spheres.
    let mut objects = OBJECTS;
    objects.sort_by(|a, b| b.sphere.radius.total_cmp(&a.sphere.radius));
    for Object { name, sphere, .. } in &objects {
        let Some(outline) = outline_in_plane_of_row(sphere, &ray) else { continue };
        let is_hit = nearest_hit.is_some_and(|hit| hit.object.sphere == *sphere);
        drawing.area(if is_hit { "object seen" } else { "object" }, outline.iter().copied());
        let middle = outline.iter().sum::<DVec2>() / outline.len() as f64;
        let position = middle.max(dvec2(0.0, 16.0)) + dvec2(0.0, 5.0);
        drawing.label("quiet", position, short_name(name));
    }
    let position = |t: f64| VIEW.xy_to_drawing(ray.at(t).x, t);
    drawing.line("guide", position(T_RANGE[0]), position(0.0));
    drawing.arrow("ray", position(0.0), position(T_RANGE[1]));
    drawing.dot("eye", position(0.0));
    let roots = OBJECTS.iter().flat_map(|object| object.sphere.intersect(&ray));
    for t in roots.filter(|t| (T_RANGE[0]..T_RANGE[1]).contains(t)) {
        drawing.dot(if t < 0.0 { "behind" } else { "ray" }, position(t));
    }
    if let Some(t) = nearest_hit.map(|hit| hit.t) {
        let label = format!("$t$ = {}", format_with_max_decimals(t, 2));
        let line_end = VIEW.xy_to_drawing(SIDE, t);
        drawing.line("guide", position(t), line_end);
        drawing.label("hit small end", line_end + dvec2(0.0, -5.0), &label);
        drawing.dot("hit", position(t));
    }
    drawing
}
