use crate::{Drawing, Interactive, Output, View};
use glam::{DVec2, DVec3, dvec2};
use step01_rays::Camera;

/// The three axes from the front, and the way a camera looks.
pub struct RightHand;

impl Interactive for RightHand {
    const NAME: &str = "right-hand";
    const TITLE: &str = "Three axes from the point C: x to the right, y up, and z to the lower left, towards you. A dotted line goes from C the other way, along -z, away from you.";
    const CAPTION: &str = "Your right hand, palm towards you: thumb right, index finger up, middle finger bent towards you. \
                  The camera looks the other way, along $-z$.";

    fn from_values(_: &[f64]) -> Self {
        Self
    }

    fn draw(&self) -> Output {
        let view = View { origin: dvec2(180.0, 122.0), scale: DVec2::splat(92.0) };
        // The z axis, towards the reader, runs to the lower left.
        let project = |p: DVec3| view.to_drawing(p.truncate() + p.z * dvec2(-0.55, -0.42));
        let c = project(DVec3::ZERO);
        let forward = Camera::new(3, 3, 1.0).ray(1.0, 1.0).direction;
        let mut drawing = Drawing::new(480.0, 208.0);
        drawing.line("guide", c, project(1.25 * forward));
        let beside = project(1.25 * forward) + dvec2(8.0, 0.0);
        drawing.label_starting_at("quiet", beside, "the camera looks this way");
        for (class, axis, label, shift) in [
            ("vector", DVec3::X, "$x$: thumb", dvec2(10.0, 6.0)),
            ("second", DVec3::Y, "$y$: index finger", dvec2(12.0, 8.0)),
            ("accent", DVec3::Z, "$z$: middle finger", dvec2(14.0, 12.0)),
        ] {
            drawing.arrow(class, c, project(axis));
            drawing.label_starting_at("", project(axis) + shift, label);
        }
        drawing.dot("eye", c);
        drawing.label_ending_at("strong", c + dvec2(-12.0, -6.0), "$C$");
        Output::Drawing(drawing)
    }
}
