//! What a ball looks like at the side of a picture.

use super::*;
use std::f64::consts::FRAC_PI_2;

/// The angle between the centre and the outline of a ball, as seen from the eye, in degrees.
const HALF_ANGLE: f64 = 8.0;

/// The distance from the eye to the centre of each ball. The image plane is at distance 1.
const DISTANCE: f64 = 0.7;

/// Maps the image plane, seen from the front, to the drawing.
const PICTURE: View = View { origin: dvec2(116.0, 62.0), scale: DVec2::splat(190.0) };

/// Maps the eye and the balls, seen from above, to the drawing.
const ABOVE: View = View { origin: dvec2(116.0, 332.0), scale: DVec2::splat(190.0) };

const ANGLE: ParameterId = ParameterId::new("angle");

const CONTENT: Content = Content::Drawing {
    title: "Two equal balls at the same distance from the eye, one straight ahead and one on the right, from above, and over them their picture. The rays that touch the ball on the right are cut by the image plane at a slant; in the picture, this ball is longer than it is wide.",
    caption: "Equal balls at the same distance from the eye. The lower part shows them from above, the upper one their images. \
                  The ball on the right is {{#number ball-outlines:angle}}° from the axis, and its image {{#number ball-outlines:times}} times as long as it's wide. \
                  A dotted ray goes through the centre of each: on the image plane, the outer half of an image at the side is longer than the inner one. \
                  <span class='move'>Drag the ball further to the side.</span>",
    draw,
};

/// A ball straight ahead of the eye, an equally large ball that the reader can move to the side,
/// and the picture of both balls.
pub fn figure() -> Figure {
    Figure {
        parameters: vec![
            Parameter::number(ANGLE, "angle of the ball", 40.0, [18.0, 48.0], 1.0)
                .with_symbol("α")
                .with_unit("°"),
        ],
        handles: vec![Handle::of_parameter(
            "the ball on the right",
            ANGLE,
            |values| centre_from_above(values[ANGLE]),
            |_, position| -ABOVE.degrees_left_of_up(position),
        )],
        readouts: |values| {
            let half = image_half_axes(values[ANGLE]);
            collect_readouts([
                ("angle", format_number(values[ANGLE])),
                ("times", format_with_max_decimals(half.x / half.y, 1)),
            ])
        },
        ..Figure::new("ball-outlines", CONTENT)
    }
}

/// The position, in the view from above, of the centre of a ball. The ball is `degrees` to the
/// right of the axis.
fn centre_from_above(degrees: f64) -> DVec2 {
    ABOVE.to_drawing(DISTANCE * direction_left_of_up(-degrees))
}

/// The x at which a ray crosses the image plane. The ray is `degrees` to the right of the axis.
fn image_plane_x(degrees: f64) -> f64 {
    degrees.to_radians().tan()
}

/// Half the width and half the height of a ball's image. The image is the ellipse in which the
/// image plane cuts the cone of rays that touch the ball.
fn image_half_axes(degrees: f64) -> DVec2 {
    let [left, right] = [degrees - HALF_ANGLE, degrees + HALF_ANGLE].map(image_plane_x);
    let middle = (left + right) / 2.0;
    let (sin, cos) = degrees.to_radians().sin_cos();
    // The top of the ellipse is on the cone, so the line from the eye to the top makes the angle
    // `HALF_ANGLE` with the cone's axis. This gives the distance from the eye to the top.
    let distance = (middle * sin + cos) / HALF_ANGLE.to_radians().cos();
    dvec2((right - left) / 2.0, (distance * distance - middle * middle - 1.0).sqrt())
}

/// Draws a ball and its image, the two rays that touch the ball, and the ray through the ball's
/// centre.
fn draw_ball(drawing: &mut Drawing, degrees: f64) {
    // Both shadings have the same light, seen once from the front and once from above.
    let DVec3 { x, y, z } = TO_LIGHT;
    let in_picture = Shading::new("ball-outlines-image", TO_LIGHT);
    let from_above = Shading::new("ball-outlines-ball", DVec3::new(x, -z, y));
    let radius = ABOVE.scale.x * DISTANCE * HALF_ANGLE.to_radians().sin();
    drawing.ball(&from_above, centre_from_above(degrees), DVec2::splat(radius));
    let [left, middle, right] =
        [degrees - HALF_ANGLE, degrees, degrees + HALF_ANGLE].map(image_plane_x);
    let centre = PICTURE.xy_to_drawing((left + right) / 2.0, 0.0);
    drawing.ball(&in_picture, centre, PICTURE.scale * image_half_axes(degrees));
    let on_plane = |x: f64| ABOVE.xy_to_drawing(x, 1.0);
    for (class, x) in [("ray", left), ("guide", middle), ("ray", right)] {
        drawing.line("axis", on_plane(x), PICTURE.xy_to_drawing(x, 0.0));
        drawing.line(class, ABOVE.origin, on_plane(x));
    }
    drawing.line("second", on_plane(left), on_plane(middle));
    drawing.line("accent", on_plane(middle), on_plane(right));
}

/// Draws the picture's frame and the image plane, then both balls and the angle between them.
fn draw(values: &ParameterValues) -> Drawing {
    let c = ABOVE.origin;
    let mut drawing = Drawing::new(352.0);
    let corners = [(-0.45, -0.27), (1.75, -0.27), (1.75, 0.27), (-0.45, 0.27)];
    drawing.area("plane", corners.map(|(x, y)| PICTURE.xy_to_drawing(x, y)));
    drawing.line("plane", ABOVE.xy_to_drawing(-0.45, 1.0), ABOVE.xy_to_drawing(1.75, 1.0));
    draw_ball(&mut drawing, 0.0);
    draw_ball(&mut drawing, values[ANGLE]);
    drawing.arc("axis", c, 70.0, [FRAC_PI_2, FRAC_PI_2 - values[ANGLE].to_radians()]);
    drawing.label("", c + dvec2(30.0, -76.0), "$α$");
    drawing.dot("eye", c);
    drawing
}
