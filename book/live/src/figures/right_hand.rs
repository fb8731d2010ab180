use crate::svg::{Drawing, View};
use crate::{Live, Sight};
use glam::{DVec2, DVec3, dvec2};
use step01_rays::Camera;

fn draw() -> Drawing {
    let view = View { origin: dvec2(180.0, 122.0), scale: DVec2::splat(92.0) };
    // What comes towards the reader runs to the lower left.
    let at = |p: DVec3| view.at(p.truncate() + p.z * dvec2(-0.55, -0.42));
    let c = at(DVec3::ZERO);
    let ahead = Camera::new(3, 3, 1.0).ray(1.0, 1.0).direction;
    let mut drawing = Drawing::new(480.0, 208.0);
    drawing.line("guide", c, at(1.25 * ahead));
    drawing.label_from(
        "quiet",
        at(1.25 * ahead) + dvec2(8.0, 0.0),
        "the camera looks here",
    );
    for (class, axis, label, finger, shift) in [
        ("vector", DVec3::X, "$x$", "thumb", dvec2(10.0, 6.0)),
        ("second", DVec3::Y, "$y$", "index finger", dvec2(12.0, 8.0)),
        ("accent", DVec3::Z, "$z$", "middle finger", dvec2(14.0, 12.0)),
    ] {
        drawing.arrow(class, c, at(axis));
        drawing.label_from("", at(axis) + shift, &format!("{label}: {finger}"));
    }
    drawing.dot("eye", c);
    drawing.label_to("strong", c + dvec2(-12.0, -6.0), "$C$");
    drawing
}

/// The three axes from the front, and the way a camera looks.
pub fn figure() -> Live {
    Live {
        title: "Three axes from the point C: x to the right, y up, and z to the lower left, towards you. A dotted line goes from C the other way, along -z, away from you.",
        caption: "Your right hand, palm towards you: thumb right, index finger up, middle finger bent towards you. \
                  The camera looks the other way, along $-z$.",
        ..Live::new("right-hand", |_| Sight::Drawing(draw()))
    }
}
