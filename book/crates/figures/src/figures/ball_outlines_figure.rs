use super::ball_outlines::{HALF_ANGLE, SPACING, ball, image_of_centre, outline, outline_size};
use crate::output::collect_numbers;
use crate::parameter::array;
use crate::{Drawing, Interactive, Numbers, Output, Parameter, View, format_fixed, format_number};
use glam::{DVec2, dvec2};
use std::f64::consts::FRAC_PI_2;

/// The number of the last ball that is whole in a picture so many degrees wide.
fn outermost_ball(degrees: f64) -> i32 {
    ((degrees / 2.0 - HALF_ANGLE) / SPACING) as i32
}

/// The distance in the drawing from the middle of the picture down to the plane.
const PLANE_DISTANCE: f64 = 78.0;

/// The ball `k` in the picture, cut off at its sides, and from above.
fn draw_ball(drawing: &mut Drawing, [picture, above]: [View; 2], k: i32, tan: f64) {
    let ball = ball(k);
    let centre = above.xy_to_drawing(ball.centre.x, -ball.centre.z);
    let outline = outline(k);
    let is_visible = outline.iter().any(|point| point.x.abs() < tan);
    let class = if is_visible { "object" } else { "guide" };
    drawing.circle(class, centre, above.scale.x * ball.radius);
    if is_visible {
        let cut = |point: &DVec2| dvec2(point.x.clamp(-tan, tan), point.y);
        let points: Vec<_> = outline.iter().map(|point| picture.to_drawing(cut(point))).collect();
        drawing.area("object", &points);
    }
}

/// The rays that touch the ball `k` on both sides, and the two parts of its picture.
fn draw_cone(drawing: &mut Drawing, [picture, above]: [View; 2], k: i32) {
    let outline = outline(k);
    let (outer, inner) = (outline[0].x, outline[60].x);
    let middle = image_of_centre(&ball(k)).x;
    let on_plane = |x: f64| above.xy_to_drawing(x, 1.0);
    for (class, x) in [("ray", inner), ("guide", middle), ("ray", outer)] {
        drawing.line(class, above.origin, on_plane(x));
        drawing.line("leader", on_plane(x), picture.xy_to_drawing(x, 0.0));
    }
    drawing.line("second", on_plane(inner), on_plane(middle));
    drawing.line("accent", on_plane(middle), on_plane(outer));
}

/// Equal balls round the eye and their picture, with a field of view to set.
pub struct BallOutlines {
    /// The field of view.
    degrees: f64,
}

impl Interactive for BallOutlines {
    const NAME: &str = "eggs";
    const TITLE: &str = "Seven balls in an arc round the eye, from above, and over it the picture of those in view. The rays that touch one on the right are cut by the image plane at a slant; in the picture, the balls are the longer the further they are from the middle.";
    const CAPTION: &str = "Equal balls, all at the same distance from the eye: from above and, over it, in the picture, with $\\theta = {{#number eggs:angle}}°$. \
                  The last ball that's whole in the picture is {{#number eggs:phi}}° from the axis, and its image {{#number eggs:times}} times as long as it's wide. \
                  The dashed ray goes through its centre: on the image plane, the outer part of the image is longer than the inner one. <span class='move'>Make $\\theta$ larger.</span>";

    fn parameters() -> Vec<Parameter> {
        vec![Parameter::new(["θ", "field of view", "°"], 100.0, [60.0, 140.0], 1.0)]
    }

    fn from_values(values: &[f64]) -> Self {
        let [degrees] = array(values);
        Self { degrees }
    }

    fn draw(&self) -> Output {
        let degrees = self.degrees;
        let tan = (degrees / 2.0).to_radians().tan();
        let scale = DVec2::splat((222.0 / tan).min(170.0));
        let picture = View { origin: dvec2(240.0, 56.0), scale };
        let c = picture.origin + dvec2(0.0, PLANE_DISTANCE + scale.y);
        let above = View { origin: c, scale };
        let mut drawing = Drawing::new(480.0, 336.0);
        drawing.rectangle("plane", picture.origin, dvec2(tan * scale.x, 50.0));
        for k in -3..=3 {
            draw_ball(&mut drawing, [picture, above], k, tan);
        }
        drawing.line("plane", above.xy_to_drawing(-tan, 1.0), above.xy_to_drawing(tan, 1.0));
        draw_cone(&mut drawing, [picture, above], outermost_ball(degrees));
        for side in [-tan, tan] {
            drawing.line("ray faint", c, above.xy_to_drawing(side, 1.0));
        }
        let half = (degrees / 2.0).to_radians();
        drawing.arc("angle", c, 34.0, [FRAC_PI_2 - half, FRAC_PI_2 + half]);
        drawing.label("", c + dvec2(-12.0, -40.0), "$θ$");
        drawing.dot("eye", c);
        drawing.into()
    }

    fn numbers(&self) -> Numbers {
        let degrees = self.degrees;
        let k = outermost_ball(degrees);
        let [length, width] = outline_size(&outline(k));
        collect_numbers([
            ("angle", format_number(degrees)),
            ("phi", format_number(SPACING * f64::from(k))),
            ("times", format_fixed(length / width, 1)),
        ])
    }
}
