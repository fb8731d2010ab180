use crate::{
    Drawing, Handle, Interactive, Numbers, Output, Parameter, View, collect_numbers, discriminant,
    format_fixed, format_number,
};
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::{FRAC_PI_2, TAU};
use step03_nearest::{Ray, Sphere};

/// The angle from the centre of a ball to its outline, in degrees.
const HALF_ANGLE: f64 = 8.0;

/// The distance of the balls from the eye; the image plane is at 1.
const DISTANCE: f64 = 0.7;

/// The map of the picture.
const PICTURE: View = View { origin: dvec2(116.0, 62.0), scale: DVec2::splat(190.0) };

/// The map of the eye and the balls, seen from above.
const ABOVE: View = View { origin: dvec2(116.0, 332.0), scale: DVec2::splat(190.0) };

/// A ball so many degrees off the axis.
fn ball(degrees: f64) -> Sphere {
    let angle = degrees.to_radians();
    let centre = DISTANCE * DVec3::new(angle.sin(), 0.0, -angle.cos());
    Sphere { centre, radius: DISTANCE * HALF_ANGLE.to_radians().sin() }
}

/// The outline of a ball on the image plane: on each line from the image of the centre, the
/// point where the discriminant falls below 0.
fn outline(ball: &Sphere) -> Vec<DVec2> {
    let centre = (ball.centre / -ball.centre.z).truncate();
    let edge = |line: DVec2| {
        let [mut inside, mut outside] = [0.0, 8.0];
        for _ in 0..30 {
            let middle = (inside + outside) / 2.0;
            let direction = (centre + middle * line).extend(-1.0);
            let is_outside = discriminant(ball, &Ray { start: DVec3::ZERO, direction }) < 0.0;
            *if is_outside { &mut outside } else { &mut inside } = middle;
        }
        centre + inside * line
    };
    let angles = (0..120).map(|k| TAU * f64::from(k) / 120.0);
    angles.map(|angle| edge(DVec2::from_angle(angle))).collect()
}

/// The place of a ball's centre, seen from above.
fn place_from_above(ball: &Sphere) -> DVec2 {
    ABOVE.xy_to_drawing(ball.centre.x, -ball.centre.z)
}

/// A ball, its image, and the rays that touch it on both sides.
fn draw_ball(drawing: &mut Drawing, ball: &Sphere) {
    let outline = outline(ball);
    drawing.circle("object", place_from_above(ball), ABOVE.scale.x * ball.radius);
    drawing.area("object", outline.iter().map(|point| PICTURE.to_drawing(*point)));
    let [inner, middle, outer] =
        [outline[60].x, ball.centre.x / -ball.centre.z, outline[0].x].map(|x| {
            let on_plane = ABOVE.xy_to_drawing(x, 1.0);
            drawing.line("leader", on_plane, PICTURE.xy_to_drawing(x, 0.0));
            on_plane
        });
    for (class, on_plane) in [("ray", inner), ("guide", middle), ("ray", outer)] {
        drawing.line(class, ABOVE.origin, on_plane);
    }
    drawing.line("second", inner, middle);
    drawing.line("accent", middle, outer);
}

/// A ball straight ahead of the eye, an equal one that the reader moves to the side, and their
/// picture.
pub struct BallOutlines {
    /// The angle of the ball on the right.
    degrees: f64,
}

impl Interactive for BallOutlines {
    const NAME: &str = "eggs";
    const TITLE: &str = "Two equal balls at the same distance from the eye, one straight ahead and one on the right, from above, and over them their picture. The rays that touch the one on the right are cut by the image plane at a slant; in the picture, it is longer than it is wide.";
    const CAPTION: &str = "Equal balls at the same distance from the eye. The lower part shows them from above, the upper one their images. \
                  The ball on the right is {{#number eggs:angle}}° from the axis, and its image {{#number eggs:times}} times as long as it's wide. \
                  A dotted ray goes through the centre of each: on the image plane, the outer half of an image at the side is longer than the inner one. \
                  <span class='move'>Drag the ball further to the side.</span>";

    fn parameters() -> Vec<Parameter> {
        vec![Parameter::new(["α", "angle of the ball", "°"], 40.0, [18.0, 48.0], 1.0)]
    }

    fn from_values(values: &[f64]) -> Self {
        Self { degrees: values[0] }
    }

    fn handles() -> Vec<Handle> {
        let locate = |figure: &Self| place_from_above(&ball(figure.degrees));
        let angle_at = |_: &Self, place| -ABOVE.degrees_left_of_up(place);
        vec![Self::handle_of_one("the ball on the right", 0, locate, angle_at)]
    }

    fn draw(&self) -> Output {
        let c = ABOVE.origin;
        let mut drawing = Drawing::new(480.0, 352.0);
        let corners = [(-0.45, -0.27), (1.75, -0.27), (1.75, 0.27), (-0.45, 0.27)];
        drawing.area("plane", corners.map(|(x, y)| PICTURE.xy_to_drawing(x, y)));
        drawing.line("plane", ABOVE.xy_to_drawing(-0.45, 1.0), ABOVE.xy_to_drawing(1.75, 1.0));
        draw_ball(&mut drawing, &ball(0.0));
        draw_ball(&mut drawing, &ball(self.degrees));
        let axis_and_ball = [FRAC_PI_2, FRAC_PI_2 - self.degrees.to_radians()];
        drawing.arc("angle", c, 70.0, axis_and_ball);
        drawing.label("", c + dvec2(30.0, -76.0), "$α$");
        drawing.dot("eye", c);
        Output::Drawing(drawing)
    }

    fn numbers(&self) -> Numbers {
        let outline = outline(&ball(self.degrees));
        let half_width = outline.iter().map(|point| point.y).fold(0.0, f64::max);
        let times = (outline[0].x - outline[60].x) / (2.0 * half_width);
        collect_numbers([("angle", format_number(self.degrees)), ("times", format_fixed(times, 1))])
    }
}
