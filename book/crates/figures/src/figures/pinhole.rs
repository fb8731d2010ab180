//! A pinhole camera from the side.

use super::*;
use step01_rays::Ray;

const CONTENT: Content = Content::Drawing {
    title: "A pinhole camera from the side. Rays go from the pinhole C to the top and the bottom of an upright arrow in the scene. They cross an image plane in front of C, where the arrow is upright and smaller, and continued backwards they meet the image behind C, where it is upside down.",
    caption: "Two rays to the ends of an arrow. Their lines, extended behind the pinhole, draw an image that's upside down. \
                  At the same distance in front, it has the same size, and is upright. Here, each $V$ leads to the image plane, so $t$ is 1 there.",
    draw,
};

/// A pinhole camera from the side, with an image behind the pinhole and an image in front of the
/// pinhole.
pub fn figure() -> Figure {
    Figure::new("pinhole", CONTENT)
}

/// Draws two rays through the pinhole, and an arrow three times: in the scene, on the image plane,
/// and upside down behind the pinhole.
fn draw(_: &ParameterValues) -> Drawing {
    let view = View { origin: dvec2(180.0, 94.0), scale: DVec2::splat(96.0) };
    let ray = |y| Ray { start: DVec3::ZERO, direction: DVec3::new(1.0, y, 0.0) };
    let [top, bottom] = [ray(0.34), ray(-0.2)];
    let position = |ray: &Ray, t: f64| view.to_drawing(ray.at(t).truncate());
    let (film, plane, object) = (-1.0, 1.0, 2.3);
    let at_t = |t: f64, y: f64| view.xy_to_drawing(t, 0.0).with_y(y);
    let mut drawing = Drawing::new(236.0);
    for t in [film, plane] {
        drawing.line("plane", at_t(t, 16.0), at_t(t, 172.0));
    }
    drawing.line("plane", at_t(0.0, 16.0), at_t(0.0, 87.0));
    drawing.line("plane", at_t(0.0, 101.0), at_t(0.0, 172.0));
    for ray in [&top, &bottom] {
        drawing.line("guide", position(ray, film), view.origin);
        drawing.line("ray", view.origin, position(ray, object));
    }
    for t in [film, plane, object] {
        drawing.arrow("second", position(&bottom, t), position(&top, t));
    }
    for (t, name, value) in [
        (film, "image", "$t$ = −1"),
        (0.0, "pinhole $C$", "$t$ = 0"),
        (plane, "image plane", "$t$ = 1"),
        (object, "scene", ""),
    ] {
        drawing.label("quiet", at_t(t, 198.0), name);
        drawing.label("quiet", at_t(t, 222.0), value);
    }
    drawing
}
