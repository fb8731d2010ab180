//! The axes of the world, and the direction in which a camera looks.

use super::*;
use step01_rays::Camera;

const CONTENT: Content = Content::Drawing {
    title: "Three axes from the point C: x to the right, y up, and z to the lower left, towards you. A dotted line goes from C the other way, along -z, away from you.",
    caption: "Your right hand, palm towards you: thumb right, index finger up, middle finger bent towards you. \
                  The camera looks the other way, along $-z$.",
    draw,
};

/// The three axes from the front, and the direction in which a camera looks.
pub fn figure() -> Figure {
    Figure::new("right-hand", CONTENT)
}

/// Draws the axes, and a dotted line in the direction in which the camera looks.
fn draw(_: &ParameterValues) -> Drawing {
    let view = View { origin: dvec2(180.0, 122.0), scale: DVec2::splat(92.0) };
    // The z axis points towards the reader, and is drawn to the lower left.
    let project = |p: DVec3| view.to_drawing(p.truncate() + p.z * dvec2(-0.55, -0.42));
    let c = view.origin;
    let mut drawing = Drawing::new(208.0);
    let ahead = project(1.25 * Camera::new(3, 3, 1.0).ray(1.0, 1.0).direction);
    drawing.line("guide", c, ahead);
    drawing.label("quiet start", ahead + dvec2(8.0, 0.0), "the camera looks this way");
    for (class, axis, label) in [
        ("vector", DVec3::X, "$x$: thumb"),
        ("second", DVec3::Y, "$y$: index finger"),
        ("accent", DVec3::Z, "$z$: middle finger"),
    ] {
        drawing.arrow(class, c, project(axis));
        drawing.label("start", project(axis) + dvec2(14.0, 10.0), label);
    }
    drawing.dot("eye", c);
    drawing.label("strong end", c + dvec2(-12.0, -6.0), "$C$");
    drawing
}
